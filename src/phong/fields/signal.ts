// A list of listeners. Parts of one thing use it and live equally long, so there is no way to stop
// listening.

export class Signal<T = void> {
  readonly #listeners: ((value: T) => void)[] = [];

  /** Calls `listener` at once when the signal is given, after those that came before. */
  listen(listener: (value: T) => void): void {
    this.#listeners.push(listener);
  }

  emit(value: T): void {
    for (const listener of this.#listeners) {
      listener(value);
    }
  }
}
