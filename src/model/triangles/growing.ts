// Lists of numbers whose length is not known before the end of the file. Typed arrays, doubled when they are full.

interface NumberArray {
  readonly length: number;
  [index: number]: number;
  set(values: ArrayLike<number>, offset?: number): void;
  subarray(begin: number, end: number): NumberArray;
}

const FIRST_LENGTH = 1024;

export class Growing<A extends NumberArray> {
  readonly #make: new (length: number) => A;
  /** Valid up to {@link length}. Replaced when it grows: do not keep it. */
  array: A;
  length = 0;

  /** @param capacity the length it will probably have. */
  constructor(make: new (length: number) => A, capacity = FIRST_LENGTH) {
    this.#make = make;
    this.array = new make(capacity);
  }

  push(value: number): void {
    if (this.length === this.array.length) this.#grow();
    this.array[this.length] = value;
    this.length += 1;
  }

  #grow(): void {
    const larger = new this.#make(Math.max(this.array.length * 2, FIRST_LENGTH));
    larger.set(this.array);
    this.array = larger;
  }
}
