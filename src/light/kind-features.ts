// The features that the packed lights of each kind need.
import { KINDS, type LightKind, unionOf } from './light-features.js';
import type { PackedLights } from './pack-lights.js';

/** For each kind, the features that any of its lights needs; 0 without a light of that kind. */
export function kindFeatures({
  counts,
  features,
}: Readonly<Pick<PackedLights, 'counts' | 'features'>>): Record<LightKind, number> {
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
