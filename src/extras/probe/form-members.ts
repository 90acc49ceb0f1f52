// What a <phong-probe> has as HTML's own controls of forms do.
import type { PhongProbe } from '../../viewer/extra.js';

/** What stands behind an element. */
interface Control {
  readonly internals: ElementInternals;
  value: string;
}

export function defineFormMembers(prototype: PhongProbe, own: (of: PhongProbe) => Control): void {
  const define = (key: string, member: PropertyDescriptor & ThisType<PhongProbe>): unknown =>
    Object.defineProperty(prototype, key, { configurable: true, ...member });
  for (const key of ['form', 'validity', 'validationMessage', 'willValidate'] as const) {
    define(key, {
      get() {
        return own(this).internals[key];
      },
    });
  }
  for (const key of ['checkValidity', 'reportValidity'] as const) {
    define(key, {
      value() {
        return own(this).internals[key]();
      },
    });
  }
  define('value', {
    get() {
      return own(this).value;
    },
    set(value: unknown) {
      own(this).value = String(value);
    },
  });
}
