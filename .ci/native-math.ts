// Gives what browsers load the engine's own functions in place of src/phong/math/elementary.ts,
// which stills need for the same bytes in every engine. The own ones are 0.7 kB of the first file
// and differ from an engine's by less than 1e-13.

import type { Plugin } from 'vite';

const NATIVE = '\0native-math';

export const nativeMath = (): Plugin => ({
  name: 'native-math',
  enforce: 'pre',
  resolveId: (specifier) => (/(^|\/)elementary\.js$/.test(specifier) ? NATIVE : null),
  load: (id) =>
    id === NATIVE
      ? `export const { acos, atan2, exp, log, log1p, pow } = Math;
export { sin as sinSmall, cos as cosSmall };
const { sin, cos } = Math;`
      : null,
});
