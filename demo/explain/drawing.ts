// How are a fragment's vectors drawn? N and L at its place in the picture, and for each light N, L, R and V in the plane of N and L.
// Only SVG attributes are set, which a strict CSP allows. Knows no tables and no events.
import type { FragmentExplanation, LightExplanation, PhongViewer, Vec3 } from 'phong-viewer';

/** Length of a unit vector in the picture, as a share of the camera's distance. */
const ARROW = 0.14;
/** Radius of the mark, CSS pixels. */
const MARK = 7;
/** Vectors shorter on screen than the mark are not drawn: they point toward the user, or away. */
const SHORT = MARK;

export interface Place {
  /** CSS pixels from the picture's top left corner. */
  readonly x: number;
  readonly y: number;
}

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** a + s b. */
const along = (a: Vec3, s: number, b: Vec3): Vec3 => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const distance = (a: Vec3, b: Vec3): number => Math.hypot(...along(a, -1, b));

/** Where `point` is in the picture; null if it is beside or behind the eye. */
export function project(viewer: PhongViewer, point: Vec3): Place | null {
  const { eye, target, up, radius } = viewer.camera;
  const back = along([0, 0, 0], 1 / radius, along(eye, -1, target));
  const from = along(point, -1, eye);
  const depth = -dot(from, back);
  if (depth <= 0) return null;
  const { width, height } = viewer.getBoundingClientRect();
  const scale = height / 2 / Math.tan((viewer.fov * Math.PI) / 360) / depth;
  return { x: width / 2 + scale * dot(from, cross(up, back)), y: height / 2 - scale * dot(from, up) };
}

/** Draws the mark, N, and L of every light that reaches the front of the surface. V is left out: it points at the user. */
export function drawInPicture(
  svg: Element,
  viewer: PhongViewer,
  at: Place | null,
  fragment: FragmentExplanation | null,
): void {
  const parts = at === null ? [] : [make('circle', { cx: at.x, cy: at.y, r: MARK })];
  if (at !== null && fragment !== null) {
    const length = ARROW * viewer.camera.radius;
    const lit = fragment.shares.filter((share) => share !== null && share.insideCone && share.NoL > 0);
    const vectors = [['N', fragment.N], ...lit.map((share) => [share!.name, share!.L])] as [string, Vec3][];
    for (const [name, vector] of vectors) {
      const end = project(viewer, along(fragment.p, length, vector));
      if (end !== null && Math.hypot(end.x - at.x, end.y - at.y) > SHORT)
        parts.push(...arrow(at, end, 8, name));
    }
  }
  svg.replaceChildren(...parts);
}

/**
 * N upright, L to its left, R its mirror image, and V projected onto their plane: the farther it leans out of the plane, the shorter
 * it is. N·L and R·V are to scale, because N, L and R lie in the plane.
 */
export function planeOf(fragment: FragmentExplanation, { L, NoL, RoV }: LightExplanation): Element {
  const sideways = along(L, -NoL, fragment.N);
  const sine = Math.hypot(...sideways);
  const V = {
    x: sine > 0 ? -dot(fragment.V, sideways) / sine : 0,
    y: -dot(fragment.N, fragment.V),
  };
  const words = `N upright, L at ${degrees(NoL)} from it, R its mirror image, V at ${degrees(RoV)} from R`;
  const svg = make('svg', { viewBox: '-130 -168 260 282', class: 'plane', role: 'img', 'aria-label': words });
  const tips: [string, Place][] = [
    ['N', { x: 0, y: -1 }],
    ['L', { x: -sine, y: -NoL }],
    ['R', { x: sine, y: -NoL }],
    ['V', V],
  ];
  svg.append(make('rect', { class: 'inside', x: -120, y: 0, width: 240, height: 110 }));
  for (const [name, { x, y }] of tips)
    svg.append(...arrow({ x: 0, y: 0 }, { x: 100 * x, y: 100 * y }, 14, name, name === 'N' ? 48 : 18));
  return svg;
}

const degrees = (cosine: number): string =>
  `${((Math.acos(Math.min(Math.max(cosine, -1), 1)) * 180) / Math.PI).toFixed(0)} degrees`;

/** A line with an arrow head of `head` units, and its name `beyond` units past the tip. */
function arrow(from: Place, to: Place, head: number, name: string, beyond = head): Element[] {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length === 0) return [];
  const [x, y] = [(to.x - from.x) / length, (to.y - from.y) / length];
  const at = (forward: number, aside: number): string =>
    `${(to.x + forward * x - aside * y).toFixed(1)} ${(to.y + forward * y + aside * x).toFixed(1)}`;
  const [tx, ty] = at(beyond, 0).split(' ');
  const text = make('text', {
    x: tx!,
    y: ty!,
    'text-anchor': x > 0.5 ? 'start' : x < -0.5 ? 'end' : 'middle',
  });
  text.setAttribute('dominant-baseline', 'middle');
  text.textContent = name;
  const line = `M${from.x.toFixed(1)} ${from.y.toFixed(1)}L${at(-head / 2, 0)}`;
  const tip = `M${at(0, 0)}L${at(-head, head / 2.5)}L${at(-head, -head / 2.5)}Z`;
  return [make('path', { d: line }), make('path', { d: tip, class: 'tip' }), text];
}

function make(tag: string, attributes: Readonly<Record<string, string | number>>): Element {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}
