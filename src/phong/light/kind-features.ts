// The code that the lights of each kind need, for specialised programs.
import { unionOf } from './light-features.js';
import { KINDS, type LightKind } from './light-state.js';

/** Lights in the order of KINDS; a mask each. */
interface SortedLights {
  readonly counts: Readonly<Record<LightKind, number>>;
  readonly features: ArrayLike<number>;
}

/** The features that any light of each kind needs; 0 without one. */
export function kindFeatures({ counts, features }: SortedLights): Record<LightKind, number> {
  const all: Record<LightKind, number> = { directional: 0, point: 0, spot: 0 };
  let light = 0;
  for (const kind of KINDS) {
    for (let i = 0; i < counts[kind]; i++, light++) {
      const own = features[light]!;
      all[kind] = i === 0 ? own : unionOf(all[kind], own);
    }
  }
  return all;
}
