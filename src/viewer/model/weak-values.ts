// What meshes of a page share, by key. Does not keep it alive: a viewer that was removed gives its
// content back only by being collected, since it may come back.

export class WeakValues<V extends object> {
  readonly #refs = new Map<string, WeakRef<V>>();
  readonly #collected = new FinalizationRegistry<string>((key) => {
    if (this.get(key) === undefined) {
      this.#refs.delete(key);
    }
  });

  get(key: string): V | undefined {
    return this.#refs.get(key)?.deref();
  }

  set(key: string, value: V): void {
    this.#refs.set(key, new WeakRef(value));
    this.#collected.register(value, key);
  }

  delete(key: string): void {
    this.#refs.delete(key);
  }
}
