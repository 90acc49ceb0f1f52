// A value as lil-gui wants it, an object with a property, made of a getter and a setter.

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
