// A light's angles seen from the side: a small diagram of the plane of N and L: N upright, L on its left, R its mirror
// image or H between L and V, and V as seen in that plane. In the picture V points at the eye, so that its angle to R
// cannot be seen there.
import type { FragmentExplanation } from '../../element/explanation.js';
import { add, dot, length, normalize, scale, subtract, type Vec3 } from '../../math/vector.js';
import { arrow, type Primitive } from '../drawing/display-list.js';
import {
  type Box,
  boxesAlong,
  type LabelWish,
  placeLabels,
  textWidth,
  whole,
} from '../drawing/label-layout.js';
import type { Point } from '../drawing/projection.js';
import { degreesText, type SumRow } from './sum.js';

/** The diagram's size in pixels for text of 12 pixels: probe.css scales it with its text. */
export const PLANE = { width: 140, height: 104 } as const;

const FONT_SIZE = 12;

/** Where the vectors start, and their length. */
const FOOT: Point = { x: 70, y: 82 };
const LENGTH = 58;

/** Shares of the length at which the arcs are. */
const ARCS = [0.45, 0.8] as const;
const ARC_STEPS = 12;

/** The diagram's axes: N and, on the right, the side away from L. */
interface Axes {
  readonly up: Vec3;
  readonly right: Vec3;
}

/** Empty where N, L and so their plane are missing. */
export function planeOf(
  { N, V }: FragmentExplanation,
  { share, absence }: SumRow,
  halfway: boolean,
): Primitive[] {
  const { L, NoL, RoV } = share;
  if (absence === 'no direction' || length(N) === 0) return [];
  const sideways = subtract(scale(N, NoL), L);
  // Along N there is no plane: then the side that V is on.
  const right = length(sideways) > 1e-9 ? sideways : subtract(V, scale(N, dot(N, V)));
  const axes: Axes = { up: N, right: normalize(right) };
  const lobe = halfway ? normalize(add(L, V)) : subtract(scale(N, 2 * NoL), L);
  const vectors: readonly (readonly [name: string, v: Vec3])[] = [
    ['N', N],
    ['L', L],
    ['V', V],
    ...(absence === null ? ([[halfway ? 'H' : 'R', lobe]] as const) : []),
  ];
  const list: Primitive[] = [
    { kind: 'stroke', lines: [[at(-1.1, 0), at(1.1, 0)]], color: '#b9b9c6', width: 1 },
  ];
  const wishes: LabelWish[] = [];
  const texts: string[] = [];
  const avoided: Box[] = [];
  for (const [name, v] of vectors) {
    const tip = seen(axes, v);
    list.push(...arrow([FOOT, tip], { color: '#fff', width: 1.5 }));
    avoided.push(...boxesAlong([FOOT, tip], 2));
    texts.push(name);
    wishes.push({ center: tip, gap: 6, width: textWidth(name, FONT_SIZE) });
  }
  const angles: readonly (readonly [from: Vec3, to: Vec3, cosine: number])[] = [
    [N, L, NoL],
    ...(absence === null ? ([[halfway ? N : V, lobe, RoV]] as const) : []),
  ];
  angles.forEach(([from, to, cosine], i) => {
    const line = arcBetween(seen(axes, from), seen(axes, to), ARCS[i]! * LENGTH);
    if (line.length === 0) return;
    list.push({ kind: 'stroke', lines: [line], color: '#fff', width: 1 });
    const text = degreesText(cosine);
    texts.push(text);
    // Nearer to L, or to R or H, than to what the other angle is measured from.
    wishes.push({ center: line[(3 * ARC_STEPS) / 4]!, gap: 9, width: textWidth(text, FONT_SIZE) });
  });
  const places = placeLabels(wishes, whole(PLANE), avoided, FONT_SIZE);
  places.forEach((place, i) => {
    if (place !== null) list.push({ kind: 'label', at: place, text: texts[i]!, color: '#fff' });
  });
  return list;
}

const at = (x: number, y: number): Point => ({ x: FOOT.x + LENGTH * x, y: FOOT.y - LENGTH * y });

/** The tip of a vector as seen in the plane: the farther it leans out of it, the shorter it is. */
const seen = ({ up, right }: Axes, v: Vec3): Point => at(dot(v, right), dot(v, up));

/** Around the foot, from the direction of one point to that of the other; empty if one is the foot. */
function arcBetween(from: Point, to: Point, radius: number): Point[] {
  const angleOf = ({ x, y }: Point): number => Math.atan2(FOOT.y - y, x - FOOT.x);
  const isFoot = ({ x, y }: Point): boolean => Math.hypot(x - FOOT.x, y - FOOT.y) < 1;
  if (isFoot(from) || isFoot(to)) return [];
  const start = angleOf(from);
  let turn = angleOf(to) - start;
  if (turn > Math.PI) turn -= 2 * Math.PI;
  if (turn < -Math.PI) turn += 2 * Math.PI;
  return Array.from({ length: ARC_STEPS + 1 }, (_, i) => {
    const angle = start + (turn * i) / ARC_STEPS;
    return { x: FOOT.x + radius * Math.cos(angle), y: FOOT.y - radius * Math.sin(angle) };
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
    const [x, y, z] = [position.getX(vertex), position.getY(vertex), position.getZ(vertex)];
    const along = (row: 0 | 1 | 2): number => e[row] * x + e[4 + row]! * y + e[8 + row]! * z + e[12 + row]!;
    return [along(0), along(1), along(2)];
  });
}
