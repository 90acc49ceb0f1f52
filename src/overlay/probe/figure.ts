// The vectors and angles of a fragment that are drawn: N, L of the lights that add most, and R or H of one of them, in
// world space. V is not among them: it points at the eye, so the picture shows it as a point. For the same reason the
// angle between R and V has no arc: it would lie on R itself.
import type { FragmentExplanation } from '../../element/explanation.js';
import type { ViewerTexts } from '../../element/fields/texts.js';
import { add, dot, length, map, normalize, scale, subtract, transformed, type Vec3 } from '../../math/vector.js';
import { byShare, type Sum, type SumRow } from './sum.js';
import { lobeWords, normalWords } from './words.js';

/** Most lights with arrows. More arrows would be unreadable. */
export const MOST_LIGHTS = 6;

/** Points of an arc. Between two of them an arc of 180 degrees and 40 pixels strays by less than a pixel. */
const ARC_STEPS = 24;

/** Shares of an arrow's length at which the arcs from N to L and to H are drawn. */
const ARC_RADIUS = { L: 0.5, H: 0.7 };

export interface Vector {
  readonly name: string;
  /** The name of its light. */
  readonly of?: string;
  /** Unit length. */
  readonly direction: Vec3;
  /** Channels 0–1, 1 or the light's own; null for white. */
  readonly color: Vec3 | null;
  /** The light adds neither a diffuse nor a specular term. */
  readonly dashed: boolean;
}

export interface Arc {
  /** Ends of vectors of less than unit length, with the curve between them. */
  readonly points: readonly Vec3[];
  readonly label: string;
}

export interface Figure {
  readonly vectors: readonly Vector[];
  readonly arcs: readonly Arc[];
}

/** `chosen`: the row whose R or H and angles are drawn, alone if `alone`. Null where no light shines. */
export function figureOf(
  fragment: FragmentExplanation,
  sum: Sum,
  chosen: SumRow | null,
  { alone, halfway }: { readonly alone: boolean; readonly halfway: boolean },
  texts: ViewerTexts | null,
): Figure {
  const { N, V } = fragment;
  const hasNormal = length(N) > 0;
  const vectors: Vector[] = hasNormal ? [plain('N', N)] : [];
  const arcs: Arc[] = [];
  const rows = alone && chosen !== null ? [chosen] : byShare(sum.rows).slice(0, MOST_LIGHTS);
  if (chosen !== null && !rows.includes(chosen)) rows.push(chosen);
  for (const row of rows) {
    const { L } = row.share;
    if (row.absence === 'no direction') continue;
    const name = sum.rows.length === 1 ? 'L' : `L ${row.name}`;
    vectors.push({ name, of: row.name, direction: L, color: colorOf(row), dashed: row.absence !== null });
  }
  if (chosen === null || !hasNormal || chosen.absence === 'no direction') return { vectors, arcs };
  const { L, NoL } = chosen.share;
  const color = colorOf(chosen);
  arcs.push({ points: arc(N, L, ARC_RADIUS.L), label: normalWords(texts, chosen.share).angle });
  if (chosen.absence !== null) return { vectors, arcs };
  const { angle } = lobeWords(texts, chosen.share.RoV, fragment.shininess);
  if (halfway) {
    const H = normalize(add(L, V));
    vectors.push({ ...plain('H', H), color });
    arcs.push({ points: arc(N, H, ARC_RADIUS.H), label: angle });
  } else {
    const R = subtract(scale(N, 2 * NoL), L);
    vectors.push({ ...plain(`R ∠V ${angle}`, R), color });
  }
  return { vectors, arcs };
}

const plain = (name: string, direction: Vec3): Vector => ({ name, direction, color: null, dashed: false });

/** The colour of the light's brightest term; white for one whose terms are all black. */
function colorOf({ light }: SumRow): Vec3 | null {
  if (light === null) return null;
  const brightest = [light.diffuse, light.specular, light.ambient].find((color) => color.some((x) => x > 0));
  return brightest === undefined ? null : map(brightest, (x) => x / 255);
}

/** From one unit vector to another, at a distance from their common foot. Of opposite ones: a straight line. */
function arc(from: Vec3, to: Vec3, radius: number): Vec3[] {
  const angle = Math.acos(Math.min(Math.max(dot(from, to), -1), 1));
  const sine = Math.sin(angle);
  return Array.from({ length: ARC_STEPS + 1 }, (_, i) => {
    const t = i / ARC_STEPS;
    // Slerp; nearly equal or opposite vectors span no plane.
    const [a, b] = sine < 1e-6 ? [1 - t, t] : [Math.sin((1 - t) * angle) / sine, Math.sin(t * angle) / sine];
    return scale(add(scale(from, a), scale(to, b)), radius);
  });
}

/**
 * The corners of the triangle that a fragment belongs to, in world space, as drawn now. Empty if the object's geometry
 * has changed.
 */
export function trianglePlaces({ object, triangle }: FragmentExplanation): Vec3[] {
  const { geometry, matrixWorld } = object;
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  if (3 * triangle + 2 >= (index ?? position).count) return [];
  const e = matrixWorld.elements;
  return [0, 1, 2].map((corner): Vec3 => {
    const vertex = index === null ? 3 * triangle + corner : index.getX(3 * triangle + corner);
    return transformed(e, position.getX(vertex), position.getY(vertex), position.getZ(vertex));
  });
}
