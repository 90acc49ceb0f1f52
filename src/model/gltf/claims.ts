// What a glTF document will cost when it is drawn: draws, corners and numbers of what its scene shows, counted in the
// JSON alone before anything is allocated. Must agree with parts.ts about what is shared and what is copied.
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
  const geometries = new Map<ClaimedSkin | undefined, Set<string>>();
  const converted = new Map<string, Set<Accessor | string>>();
  const packed = new Map<number, DracoClaims>();
  for (const { primitives, instances, skin } of nodes) {
    const copies = instances?.count ?? 1;
    for (const accessor of primitives.length > 0 ? Object.values(instances?.lists ?? {}) : [])
      accessors.read(accessor);
    for (const primitive of primitives) {
      const { corners, vertices } = primitive;
      budget.add({ parts: copies, corners: copies * corners });
      await slices.pauseIfDue();
      const known = geometries.get(skin) ?? new Set();
      // The weights of morph targets belong to a node.
      if (primitive.targets.length === 0 && known.has(primitive.key)) continue;
      // A joint has a matrix in the file and one in its pose, in float64.
      if (!geometries.has(skin)) budget.add({ values: (skin?.joints.length ?? 0) * 64 });
      if (skin?.inverseBindMatrices !== undefined) accessors.read(skin.inverseBindMatrices);
      geometries.set(skin, known.add(primitive.key));
      for (const accessor of primitive.read) accessors.read(accessor);
      budget.add({ values: ownValues(primitive, skin !== undefined) });
      for (const { name, accessor, items } of primitive.attributes) {
        const sources = converted.get(name) ?? new Set();
        // Unpacked data belongs to one geometry, even if its accessors are shared.
        const source = primitive.packed === undefined ? accessor : primitive.key;
        if (sources.has(source)) continue;
        converted.set(name, sources.add(source));
        budget.add({ values: accessor.count * items });
      }
      if (primitive.packed !== undefined) {
        requireAtMost(Math.max(corners, vertices), DRACO_LIMIT, 'corners in one Draco mesh');
        const most = packed.get(primitive.packed) ?? primitive;
        packed.set(primitive.packed, {
          corners: Math.max(most.corners, corners),
          vertices: Math.max(most.vertices, vertices),
        });
      }
    }
  }
  return packed;
}

export interface DracoClaims {
  readonly corners: number;
  readonly vertices: number;
}

/** What a computed tangent costs, in values: itself, and two sums in float64 while it is computed. */
const TANGENT_VALUES = 16;

/**
 * What a vertex with joints or morph targets costs, in values: position, normal and tangent once more, its joints and
 * their weights, and whether they mirror it.
 */
const MOVING_VALUES = 17;

/** Values that no other geometry shares: indices, or a copy of the vertices for each corner (see parts.ts). */
function ownValues(primitive: Primitive, skinned: boolean): number {
  const { attributes, order, corners, vertices, tangents, targets } = primitive;
  const flat = attributes.every(({ name }) => name !== 'NORMAL');
  // Strips, and vertices that do not fill the last triangle, get an index.
  const indexed = order !== undefined || corners !== vertices;
  const separate = indexed && (flat || usesFew(corners, vertices));
  const own = separate ? corners : vertices;
  const items = attributes.reduce((sum, attribute) => sum + attribute.items, 0);
  return (
    (separate ? corners * items : indexed ? corners : 0) +
    (flat ? corners * 3 : 0) +
    (skinned || targets.length > 0 ? own * MOVING_VALUES : 0) +
    // Its own index, where joints mirror it.
    (skinned ? corners : 0) +
    // As in the file, and as floats.
    targets.reduce((sum, target) => sum + Object.keys(target).length, 0) * (vertices + own) * 3 +
    (tangents ? own * TANGENT_VALUES : 0)
  );
}

/** Whether a primitive uses so few of its vertices that it gets a copy of its own. */
export const usesFew = (corners: number, vertices: number): boolean => corners * 2 < vertices;
