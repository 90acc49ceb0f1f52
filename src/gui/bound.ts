// How does a getter and a setter become the object with a property that lil-gui binds to?

export interface Bound<T> {
  value: T;
}

export const bound = <T>(get: () => T, set: (value: T) => void = () => undefined): Bound<T> => ({
  get value() {
    return get();
  },
  set value(value: T) {
    set(value);
  },
});
