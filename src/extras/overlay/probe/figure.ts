// The figure at a probed point, and its display list: N, L of the lights that add most, R or H of
// one of them and their angles. V is a point, because it points at the eye, so the angle between R
// and V has no arc: it would lie on R itself.
import type { FragmentExplanation, ViewerTexts } from '../../../viewer/extra.js';
import { radians } from '../../../phong/math/angle.js';
import {
  add,
  clamp,
  dot,
  length,
  map,
  normalize,
  scale,
  subtract,
  transformed,
  type Vec3,
} from '../../../phong/math/vector.js';
import { arrow, coreColor, cssRgb, type DrawnItem } from '../drawing/display-list.js';
import { boxAround, boxesAlong, listOf, type Name, type Rect } from '../drawing/label-layout.js';
import type { Point, Projection } from '../drawing/projection.js';
import { byShare, degreesOf, type Sum, type SumRow, lobeWords, normalWords } from './sum.js';

/** Most lights with arrows. More would be unreadable. */
export const MOST_LIGHTS = 6;

/**
 * Points of an arc. Between two of them an arc of 180 degrees and 40 pixels strays by less than a
 * pixel.
 */
const ARC_STEPS = 24;

/** Shares of an arrow's length at which the arcs from N to L and to H are drawn. */
const ARC_RADIUS = { L: 0.5, H: 0.7 };

const WHITE: Vec3 = [1, 1, 1];

export interface Vector {
  readonly name: string;
  /** Unit length. */
  readonly direction: Vec3;
  /** Channels 0–1; more for bright lights. */
  readonly color: Vec3;
  /** The light adds neither a diffuse nor a specular term. */
  readonly dashed: boolean;
}

interface Arc {
  /** Ends of vectors of less than unit length, with the curve between them. */
  readonly points: readonly Vec3[];
  readonly label: string;
}

export interface Figure {
  readonly vectors: readonly Vector[];
  readonly arcs: readonly Arc[];
}

/**
 * `chosen`: the row whose R or H and angles are drawn, alone if `alone`. Null where no light
 * shines.
 */
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
  if (chosen !== null && !rows.includes(chosen)) {
    rows.push(chosen);
  }
  for (const row of rows) {
    if (row.absence === 'no direction') continue;
    const name = sum.rows.length === 1 ? 'L' : `L ${row.name}`;
    vectors.push({ name, direction: row.L, color: colorOf(row), dashed: row.absence !== null });
  }
  if (chosen === null || !hasNormal || chosen.absence === 'no direction') return { vectors, arcs };
  const { L, NoL } = chosen;
  const color = colorOf(chosen);
  arcs.push({ points: arc(N, L, ARC_RADIUS.L), label: normalWords(texts, chosen).angle });
  if (chosen.absence !== null) return { vectors, arcs };
  const { angle } = lobeWords(texts, chosen.RoV, fragment.shininess);
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

const plain = (name: string, direction: Vec3): Vector => ({
  name,
  direction,
  color: WHITE,
  dashed: false,
});

/** The colour of the light's brightest term; white for one whose terms are all black. */
function colorOf({ light }: SumRow): Vec3 {
  const colors = light === null ? [] : [light.diffuse, light.specular, light.ambient];
  const brightest = colors.find((color) => color.some((x) => x > 0));
  return brightest === undefined ? WHITE : map(brightest, (x) => x / 255);
}

/**
 * From one unit vector to another, at a distance from their common foot. Opposite vectors give a
 * straight line.
 */
function arc(from: Vec3, to: Vec3, radius: number): Vec3[] {
  const angle = radians(degreesOf(dot(from, to)));
  const sine = Math.sin(angle);
  return Array.from({ length: ARC_STEPS + 1 }, (_, i) => {
    const t = i / ARC_STEPS;
    // Slerp; nearly equal or opposite vectors span no plane.
    const [a, b] =
      sine < 1e-6 ? [1 - t, t] : [Math.sin((1 - t) * angle) / sine, Math.sin(t * angle) / sine];
    return scale(add(scale(from, a), scale(to, b)), radius);
  });
}

/**
 * The corners of the fragment's triangle in world space, as drawn now. Empty if the geometry has
 * changed.
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

/**
 * Length of a vector across the line of sight: a share of the layer's smaller side, within limits
 * in CSS pixels.
 */
const ARROW = { share: 0.24, least: 22, most: 110 };

/**
 * Radius of the mark, CSS pixels. Shorter arrows point at the eye or away from it and have no line.
 */
const MARK = 6;

/** Half the width that labels keep clear of an arrow, CSS pixels. */
const LINE_HALF = 3;

/** Layers smaller than this have room for arrows but not for their names. CSS pixels. */
const NAMED = { width: 140, height: 110 };

/** The mark alone. `dashed`: hidden, or on no surface. */
export const markOf = (center: Point, dashed: boolean): DrawnItem[] => [
  { kind: 'disc', center, radius: MARK, fill: null, color: '#fff', width: 2, dashed },
];

export interface Surroundings {
  /** A triangle around the point, if any. */
  readonly outline: readonly Vec3[];
  /** Labels stay inside. */
  readonly room: Rect;
  /** Boxes to keep clear of: the probe's, and those of the names of lights and axes. */
  readonly boxes: readonly Rect[];
  readonly fontSize: number;
}

/** `p` is the point in world space, `at` its place on the layer. */
export function drawingOf(
  projection: Projection,
  p: Vec3,
  at: Point,
  { vectors, arcs }: Figure,
  { outline, room, boxes, fontSize }: Surroundings,
): readonly DrawnItem[] {
  const { width, height } = projection;
  const pixels = clamp(ARROW.share * Math.min(width, height), ARROW.least, ARROW.most);
  const unit = pixels / projection.pixelsPerUnit(projection.depthOf(p));
  const placeOf = (vector: Vec3) => projection.point(add(p, scale(vector, unit)));
  const list: DrawnItem[] = [];
  const labels: Name[] = [{ text: 'V', center: at, gap: MARK + 4 }];
  const covered = [boxAround(at, MARK)];
  if (outline.length > 0) {
    const lines = projection.line([...outline, outline[0]!]);
    list.push({ kind: 'stroke', lines, color: '#fff', width: 1, dashed: true });
  }
  for (const { points, label } of arcs) {
    const line = points.map(placeOf).filter((point) => point !== null);
    if (line.length < 2) continue;
    list.push({ kind: 'stroke', lines: [line], color: '#fff', width: 1.5 });
    covered.push(...boxesAlong(line, 1));
    labels.push({ text: label, center: line[Math.floor(line.length / 2)]!, gap: 8 });
  }
  for (const { name, direction, color, dashed } of vectors) {
    const tip = placeOf(direction);
    if (tip === null) continue;
    const css = cssRgb(coreColor(color));
    covered.push(...boxesAlong([at, tip], LINE_HALF));
    if (Math.hypot(tip.x - at.x, tip.y - at.y) > MARK) {
      list.push(...arrow(at, tip, { color: css, width: 2.5, dashed }));
    }
    labels.push({ text: name, center: tip, gap: 7, color: css });
  }
  // The ring, and in it the tip of V, which points at the eye.
  list.push(...markOf(at, false), {
    kind: 'disc',
    center: at,
    radius: 1,
    fill: '#fff',
    color: '#fff',
    width: 1,
  });
  // The names of vectors come before those of angles.
  labels.sort((a, b) => Number(a.text.endsWith('°')) - Number(b.text.endsWith('°')));
  const hasRoom = width >= NAMED.width && height >= NAMED.height;
  return listOf([{ list, names: hasRoom ? labels : [], covered }], room, fontSize, boxes).list;
}
