// A value that a control reads and writes: a getter and a setter as the object with a property that
// lil-gui binds to.

/** Invariant in `T`: a control for any text is no control for one of three words. */
export interface Bound<in out T> {
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

/** Runs `write`. False if the element refuses the value. */
export function accepted(write: () => void): boolean {
  try {
    write();
    return true;
  } catch (error) {
    if (error instanceof RangeError || error instanceof TypeError) return false;
    throw error;
  }
}
