// Code of extras as the viewer uses it: the table of extras provides it.
import { lazyCode } from '../../phong/lazy-code.js';

/** Fetches code of an extra. Rejects where this copy of the package has none. */
export interface ExtraCode<Code> {
  (): Promise<Code>;
  /** Called by the table of extras (`viewer/extras.ts`): `load` is as for {@link lazyCode}. */
  provide(load: (failures: number) => Promise<Code>): void;
}

/**
 * Code of an extra, for the file that uses it: it says what it needs, and imports nothing.
 * @param what names the part, as in {@link lazyCode}.
 */
export function extraCode<Code>(what: string): ExtraCode<Code> {
  let provided: (() => Promise<Code>) | undefined;
  let missing: Error | undefined;
  const code = (): Promise<Code> =>
    provided?.() ??
    Promise.reject((missing ??= new Error(`This copy of the package has no code of ${what}.`)));
  const provide: ExtraCode<Code>['provide'] = (load) => {
    provided = lazyCode(load, what);
  };
  return Object.assign(code, { provide });
}

let reported: unknown;

/** For uses that go on without the code. One error that comes again and again is said once. */
export function reportMissing(error: unknown): void {
  if (error !== reported) {
    console.warn(`<phong-viewer>: ${(error as Error).message}`);
  }
  reported = error;
}
