// What users of a page share by key, and how many they are. Only the users keep it alive: a viewer
// that was removed gives its content back only by being collected, since it may come back.

interface Disposable {
  dispose(): void;
}

interface Use {
  readonly key: string;
  users: number;
  held?: Disposable;
}

export class Shared<V extends object> {
  readonly #refs = new Map<string, WeakRef<V>>();
  readonly #uses = new WeakMap<V, Use>();
  readonly #collected = new FinalizationRegistry<Use>(({ key, held }) => {
    held?.dispose();
    if (this.get(key) === undefined) {
      this.#refs.delete(key);
    }
  });

  get(key: string): V | undefined {
    return this.#refs.get(key)?.deref();
  }

  /** For one more user; made for the first. */
  acquire(key: string, make: () => V): V {
    const value = this.get(key) ?? this.#add(key, make());
    this.#uses.get(value)!.users += 1;
    return value;
  }

  /** True where that was the last user. The next one gets the same value, until it is forgotten. */
  release(value: V): boolean {
    const use = this.#uses.get(value)!;
    use.users -= 1;
    return use.users === 0;
  }

  /**
   * `held` is disposed of if the value is collected before its last user has released it: removed
   * viewers release nothing, and another viewer may have drawn it after they were removed. `held`
   * must not refer to the value.
   */
  hold(value: V, held: Disposable): void {
    this.#uses.get(value)!.held = held;
  }

  /** The next user of its key gets another value. */
  forget(value: V): void {
    const { key } = this.#uses.get(value)!;
    if (this.get(key) === value) {
      this.#refs.delete(key);
      this.#collected.unregister(value);
    }
  }

  /** Gives another key, which no value has, to a value with one user. False for other values. */
  move(value: V, key: string): boolean {
    if (this.#uses.get(value)!.users !== 1 || this.get(key) !== undefined) return false;
    this.forget(value);
    this.#add(key, value, 1);
    return true;
  }

  #add(key: string, value: V, users = 0): V {
    const use = { key, users };
    this.#refs.set(key, new WeakRef(value));
    this.#uses.set(value, use);
    this.#collected.register(value, use, value);
    return value;
  }
}
