// Fetches code that the first frame does not need with its first use, and again with the next use
// after a failure.

/**
 * A function that fetches a part of the package by `load`, which is an `import()`. All uses share
 * one request. After a failure the next call requests it again, and the error is a sentence for the
 * page's author; the browser's own error is its `cause`.
 * @param load is called with the number of failures so far. The build uses it
 * (.ci/retried-imports.ts): browsers that keep failed imports never request the same address again
 * (https://github.com/whatwg/html/issues/6768).
 * @param what names the part in that sentence: "The code of … could not be fetched."
 */
export function lazyCode<T>(
  load: (failures: number) => Promise<T>,
  what: string,
): () => Promise<T> {
  let code: Promise<T> | null = null;
  let failures = 0;
  return () =>
    (code ??= load(failures).catch((cause: unknown) => {
      code = null;
      failures += 1;
      throw new Error(`The code of ${what} could not be fetched. The next use requests it again.`, {
        cause,
      });
    }));
}

/** Milliseconds after a failed request of {@link fasterCode} before the next one. */
const PAUSE = 30_000;

/**
 * For code without which everything is the same, but slower. The returned function gives null until
 * the code is there. Its first call requests it; nothing is said of failures.
 */
export function fasterCode<T>(code: () => Promise<T>): () => T | null {
  let present: T | null = null;
  let requested = -Infinity;
  return () => {
    if (present === null && performance.now() > requested + PAUSE) {
      requested = performance.now();
      code().then(
        (loaded) => (present = loaded),
        () => undefined,
      );
    }
    return present;
  };
}
