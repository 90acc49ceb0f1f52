// What a glTF document draws, counted in the JSON alone before anything is allocated: parts, corners, and the accessors
// that are read. geometries.ts counts the numbers of what it makes as it makes it.
import { DRACO_LIMIT } from '../limits.js';
import { requireAtMost, type ModelBudget } from '../model-budget.js';
import type { Slices } from '../slices.js';
import type { Accessor, Accessors } from './accessors.js';
import type { Instances } from './instances.js';
import type { Primitive } from './primitives.js';

/** Shared by all nodes of one document while they are counted. */
interface ClaimContext {
  readonly accessors: Accessors;
  readonly budget: ModelBudget;
}

interface ClaimedNode {
  /** Primitives of its mesh. */
  readonly primitives: readonly Primitive[];
  readonly instances: Instances | undefined;
  readonly skin: ClaimedSkin | undefined;
}

/** Compared by identity. */
interface ClaimedSkin {
  readonly joints: readonly number[];
  readonly inverseBindMatrices: Accessor | undefined;
}

/**
 * @param nodes all that are drawn.
 * @returns the largest claims of what each Draco buffer view holds.
 * @throws ModelError `too-large` past a limit.
 */
export async function countClaims(
  nodes: readonly ClaimedNode[],
  { accessors, budget }: ClaimContext,
  slices: Slices,
): Promise<ReadonlyMap<number, DracoClaims>> {
  const counted = new Set<Primitive | ClaimedSkin>();
  const packed = new Map<number, DracoClaims>();
  for (const { primitives, instances, skin } of nodes) {
    const copies = instances?.count ?? 1;
    if (primitives.length === 0) continue;
    for (const accessor of Object.values(instances?.lists ?? {})) accessors.read(accessor);
    if (skin !== undefined && !counted.has(skin)) {
      counted.add(skin);
      // A joint has a matrix in the file and one in its pose, in float64.
      budget.add({ values: skin.joints.length * 64 });
      if (skin.inverseBindMatrices !== undefined) accessors.read(skin.inverseBindMatrices);
    }
    for (const primitive of primitives) {
      budget.add({ parts: copies, corners: copies * primitive.corners });
      await slices.pauseIfDue();
      if (counted.has(primitive)) continue;
      counted.add(primitive);
      for (const accessor of primitive.read) accessors.read(accessor);
      if (primitive.packed === undefined) continue;
      const { attributes, corners, vertices } = primitive;
      requireAtMost(Math.max(corners, vertices), DRACO_LIMIT, 'corners in one Draco mesh');
      // The decoder's numbers.
      budget.add({ values: attributes.reduce((sum, { items }) => sum + items * vertices, corners) });
      const most = packed.get(primitive.packed) ?? primitive;
      packed.set(primitive.packed, {
        corners: Math.max(most.corners, corners),
        vertices: Math.max(most.vertices, vertices),
      });
    }
  }
  return packed;
}

export interface DracoClaims {
  readonly corners: number;
  readonly vertices: number;
}
