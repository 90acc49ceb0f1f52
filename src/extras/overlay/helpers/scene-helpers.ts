// The helpers of the scene itself: axes, the grid on the ground, the boxes and the normals of
// meshes. World space to CSS pixels of the layer. Computed again only where the view, the ball, a
// mesh, or what hides something has changed.
import { Matrix3, type Mesh, type Object3D, Vector3 } from 'three';
import type { ExtraHost } from '../../../viewer/extra.js';
import { sameValue } from '../../../phong/fields/field-store.js';
import { normalMatrix } from '../../../phong/material/normal-matrix.js';
import { PhongMaterial } from '../../../phong/material/phong-material.js';
import { niceCeil } from '../../../phong/math/round-number.js';
import {
  add,
  dot,
  length,
  normalize,
  scale,
  subtract,
  transformed,
  type Vec3,
} from '../../../phong/math/vector.js';
import { arrowHead, type DrawnItem, type Stroke, strokes } from '../drawing/display-list.js';
import type { Drawing, Name } from '../drawing/label-layout.js';
import { isInside, type Point, type Projection } from '../drawing/projection.js';
import type { SceneBall } from './light-marks.js';
import { isBehind, type RayTest, RayTests } from './occlusion.js';

/**
 * Whether something is in front of a place; undefined while that is not known. `key`: the place's,
 * across frames.
 */
type Hiding = (key: string, place: () => Vec3) => boolean | undefined;

export class SceneHelpers {
  readonly #host: ExtraHost;
  readonly #hidden: RayTests<string, boolean>;
  /** What the last drawing was computed from. */
  #seen: readonly unknown[] = [];
  /** Null once something else is hidden than before. */
  #drawing: Drawing | null = null;

  /** `changed` is called when something looks different although nothing was drawn. */
  constructor(host: ExtraHost, changed: () => void) {
    this.#host = host;
    this.#hidden = new RayTests(host, () => {
      this.#drawing = null;
      changed();
    });
  }

  show(view: Projection, scene: SceneBall, helpers: ExtraHost['values']['helpers']): Drawing {
    const seen = [view, scene, helpers, ...this.#meshes.flatMap(stateOf)];
    const isSame = sameValue(seen, this.#seen);
    if (isSame && this.#drawing !== null) return this.#drawing;
    this.#seen = seen;
    this.#drawing = this.drawingAt(view, scene, helpers);
    if (!isSame) {
      this.#hidden.follow(() => {
        const tests = new Map<string, RayTest<boolean>>();
        this.drawingAt(view, scene, helpers, tests);
        return tests;
      });
    }
    return this.#drawing;
  }

  hide(): void {
    this.#hidden.stop();
    this.#seen = [];
    this.#drawing = null;
  }

  /** `tests` collects the places that have to be tested for being hidden. */
  drawingAt(
    view: Projection,
    scene: SceneBall,
    helpers: ExtraHost['values']['helpers'],
    tests?: Map<string, RayTest<boolean>>,
  ): Drawing {
    const hiding: Hiding = (key, place) => {
      tests?.set(key, isBehind(place(), view));
      return this.#hidden.answer(key);
    };
    const list: DrawnItem[] = [];
    const names: Name[] = [];
    if (helpers.includes('grid')) {
      list.push(...gridMarks(view, scene, hiding));
    }
    if (helpers.includes('bounds')) {
      list.push(...boundsMarks(this.#meshes, view));
    }
    if (helpers.includes('normals')) {
      list.push(...normalMarks(this.#meshes, view, scene, hiding));
    }
    if (helpers.includes('axes')) {
      list.push(...axesMarks(view, scene, hiding, names));
    }
    return { list, names, covered: [] };
  }

  /** The visible meshes, the page author's own included. */
  get #meshes(): Mesh[] {
    const meshes: Mesh[] = [];
    this.#host.viewport.picture.scene.traverseVisible((object: Object3D) => {
      // By its mark, not its class: another copy of three.js may have made it.
      if ((object as Partial<Mesh>).isMesh === true) {
        meshes.push(object as Mesh);
      }
    });
    return meshes;
  }
}

/** What differs where a mesh has moved, or has other vertices, another material or other sides. */
const stateOf = ({ geometry, material, matrixWorld }: Mesh): unknown[] => [
  geometry,
  geometry.boundingBox,
  (geometry.attributes['position'] as { version?: number } | undefined)?.version,
  material,
  (material as { style?: unknown }).style,
  ...matrixWorld.elements,
];

/** Light enough for a core (display-list.ts), and apart for eyes that see red and green alike. */
const COLORS = {
  x: '#ff9a8a',
  y: '#8fe388',
  z: '#8fc4ff',
  grid: '#c8d0e0',
  bounds: '#ffd24a',
  normals: '#7fe0ff',
} as const;

/** Length of an axis beyond the scene's centre, in radii of the scene. */
const AXIS = 1.3;

/** Pieces of an axis and of a line of the grid that are hidden, or not, as a whole. */
const AXIS_PIECES = 24;
const GRID_PIECES = 16;

/** From the origin along x, y and z; adds their `names`. */
function axesMarks(
  view: Projection,
  { center, radius }: SceneBall,
  hiding: Hiding,
  names: Name[],
): DrawnItem[] {
  const reach = length(center) + AXIS * radius;
  const list: DrawnItem[] = [];
  for (const [i, name] of (['x', 'y', 'z'] as const).entries()) {
    const tip: Vec3 = [i === 0 ? reach : 0, i === 1 ? reach : 0, i === 2 ? reach : 0];
    const style = { color: COLORS[name], width: 2 };
    const { shown, behind } = pieces([0, 0, 0], tip, AXIS_PIECES, `axis ${name}`, view, hiding);
    list.push(...strokes(behind, { ...style, dashed: true }), ...strokes(shown, style));
    const ends = view.segment([0, 0, 0], tip);
    if (ends === null) continue;
    list.push(...strokes(arrowHead(...ends), { ...style, filled: true }));
    const last = lastInside(tip, view);
    if (last !== null) {
      names.push({ text: name, center: last, gap: NAME_GAP });
    }
  }
  return list;
}

/** Between an axis and its name, CSS pixels. */
const NAME_GAP = 10;

/** The farthest point of an axis that leaves room for its name inside. */
function lastInside(tip: Vec3, view: Projection): Point | null {
  for (let i = AXIS_PIECES; i > 0; i--) {
    const point = view.point(scale(tip, i / AXIS_PIECES));
    if (point !== null && isInside(point, view, NAME_GAP)) return point;
  }
  return null;
}

/**
 * Lines of the plane y = 0 at round distances: 1, 2 or 5 times a power of ten. Parts behind shapes
 * are left out.
 */
function gridMarks(
  view: Projection,
  { center, radius }: SceneBall,
  hiding: Hiding,
): readonly DrawnItem[] {
  const step = niceCeil(radius / 4);
  const endsAround = (middle: number) =>
    [
      Math.floor((middle - GRID * radius) / step),
      Math.ceil((middle + GRID * radius) / step),
    ] as const;
  const [lowX, highX] = endsAround(center[0]);
  const [lowZ, highZ] = endsAround(center[2]);
  // Far from the origin the lines' coordinates round to each other.
  if (!(highX - lowX < MOST_LINES && highZ - lowZ < MOST_LINES)) return [];
  const lines: (readonly Point[])[] = [];
  const draw = (key: string, from: Vec3, to: Vec3): void => {
    lines.push(...pieces(from, to, GRID_PIECES, key, view, hiding).shown);
  };
  for (let x = lowX; x <= highX; x++) {
    draw(`grid x ${x}`, [x * step, 0, lowZ * step], [x * step, 0, highZ * step]);
  }
  for (let z = lowZ; z <= highZ; z++) {
    draw(`grid z ${z}`, [lowX * step, 0, z * step], [highX * step, 0, z * step]);
  }
  return strokes(lines, { color: COLORS.grid, width: 1, outline: 0.5, opacity: 0.7 });
}

/** Half the grid's size, in radii of the scene. */
const GRID = 1.5;

/** Three times as many as a scene at the origin has. */
const MOST_LINES = 40;

/** A line in equal pieces: those in front, and those behind shapes. Neighbours are joined. */
function pieces(
  from: Vec3,
  to: Vec3,
  count: number,
  key: string,
  view: Projection,
  hiding: Hiding,
): { shown: Stroke['lines']; behind: Stroke['lines'] } {
  const at = (share: number) => add(from, scale(subtract(to, from), share));
  const result: Record<'shown' | 'behind', (readonly Point[])[]> = { shown: [], behind: [] };
  const sideOf = (i: number): 'shown' | 'behind' =>
    hiding(`${key} ${i}`, () => at((i + 0.5) / count)) === true ? 'behind' : 'shown';
  for (let i = 0, first = 0, next = sideOf(0); i < count; i++) {
    const side = next;
    if (i + 1 < count) {
      next = sideOf(i + 1);
      if (next === side) continue;
    }
    const piece = view.segment(at(first / count), at((i + 1) / count));
    if (piece !== null) {
      result[side].push(piece);
    }
    first = i + 1;
  }
  return result;
}

/** The box of each mesh along its own axes. Edges at its back are dashed. */
function boundsMarks(meshes: readonly Mesh[], view: Projection): DrawnItem[] {
  const front: (readonly Point[])[] = [];
  const back: (readonly Point[])[] = [];
  for (const mesh of meshes.slice(0, MOST_BOXES)) {
    boxEdges(mesh, view, front, back);
  }
  const style = { color: COLORS.bounds, width: 1.5 };
  return [...strokes(back, { ...style, dashed: true }), ...strokes(front, style)];
}

/** More would run into each other. */
const MOST_BOXES = 200;

function boxEdges(
  mesh: Mesh,
  view: Projection,
  front: (readonly Point[])[],
  back: (readonly Point[])[],
): void {
  const { geometry, matrixWorld } = mesh;
  if (geometry.boundingBox === null) {
    geometry.computeBoundingBox();
  }
  const box = geometry.boundingBox;
  if (box === null || box.isEmpty()) return;
  const ends = [box.min.toArray(), box.max.toArray()] as const;
  const endOf = (bits: number, axis: 0 | 1 | 2): number => ends[(bits >> axis) & 1]![axis];
  const corner = (bits: number): Vec3 =>
    transformed(matrixWorld.elements, endOf(bits, 0), endOf(bits, 1), endOf(bits, 2));
  const eye = new Vector3(...view.eye).applyMatrix4(matrixWorld.clone().invert());
  /**
   * The eye is on the outer side of the face, in the box's own space. A flattened box has no such
   * space, and hides nothing: there the difference is not a number.
   */
  const isFront = (axis: number, bit: number): boolean => {
    const beyond = eye.getComponent(axis) - ends[bit]![axis]!;
    return !(bit === 0 ? beyond >= 0 : beyond <= 0);
  };
  for (const axis of [0, 1, 2]) {
    for (const bits of [0, 1, 2, 3]) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const base = ((bits & 1) << u) | ((bits >> 1) << v);
      const edge = view.segment(corner(base), corner(base | (1 << axis)));
      if (edge === null) continue;
      (isFront(u, bits & 1) || isFront(v, bits >> 1) ? front : back).push(edge);
    }
  }
}

/** Normals of all meshes together. More would cover the picture. */
const MOST_NORMALS = 400;

/** CSS pixels of the scene's disc for each normal, so that small scenes are not covered either. */
const NORMAL_PIXELS = 300;

/** Length of a drawn normal, in radii of the scene. */
const NORMAL = 0.09;

/**
 * Takes vertices in an order without a pattern: steps of a fixed size would follow the rows of a
 * sphere.
 */
const GOLDEN = (Math.sqrt(5) - 1) / 2;

/**
 * Normals at a sample of the vertices, or of the triangles under flat shading; of double-sided
 * surfaces, toward the eye.
 */
function normalMarks(
  meshes: readonly Mesh[],
  view: Projection,
  { center, radius }: SceneBall,
  hiding: Hiding,
): DrawnItem[] {
  const drawn = meshes.filter(
    ({ geometry }) => geometry.hasAttribute('normal') && geometry.hasAttribute('position'),
  );
  const pixels = Math.PI * (radius * view.pixelsPerUnit(view.depthOf(center))) ** 2;
  const each = Math.min(MOST_NORMALS, pixels / NORMAL_PIXELS) / drawn.length;
  const lines: (readonly Point[])[] = [];
  const heads: (readonly Point[])[] = [];
  for (const [index, mesh] of drawn.entries()) {
    const { count } = mesh.geometry.getAttribute('position');
    const samples = Math.min(Math.ceil(each), count);
    const phong = mesh.material instanceof PhongMaterial ? mesh.material : null;
    const normalAt = normalsOf(mesh, phong?.style.shading === 'flat');
    for (let i = 0; i < samples; i++) {
      const { p, N } = normalAt(samples === count ? i : Math.floor(((i * GOLDEN) % 1) * count));
      if (length(N) === 0) continue;
      const faces = dot(N, subtract(view.eye, p)) > 0;
      if (!faces && phong?.sides !== 'double') continue;
      const isHidden = hiding(`normal ${index} ${i}`, () => p);
      if (faces ? isHidden === true : isHidden !== false) continue;
      const ends = view.segment(p, add(p, scale(N, (faces ? 1 : -1) * NORMAL * radius)));
      if (ends === null) continue;
      lines.push(ends);
      heads.push(...arrowHead(...ends, 5));
    }
  }
  const style = { color: COLORS.normals, width: 1, outline: 1 };
  return [...strokes(lines, style), ...strokes(heads, { ...style, filled: true })];
}

/** World place and normal by vertex; the normal is a unit vector, or zero. */
function normalsOf(
  { geometry, matrixWorld }: Mesh,
  isFlat: boolean,
): (vertex: number) => { readonly p: Vec3; readonly N: Vec3 } {
  const turn = new Matrix3();
  normalMatrix(matrixWorld, turn);
  const position = geometry.getAttribute('position');
  const normal = geometry.getAttribute('normal');
  const placeOf = (vertex: number): Vec3 =>
    new Vector3().fromBufferAttribute(position, vertex).applyMatrix4(matrixWorld).toArray();
  return (vertex) => {
    const turned = new Vector3().fromBufferAttribute(normal, vertex).applyMatrix3(turn);
    const N = normalize(turned.toArray());
    const first = vertex - (vertex % 3);
    const p = isFlat
      ? scale(add(add(placeOf(first), placeOf(first + 1)), placeOf(first + 2)), 1 / 3)
      : placeOf(vertex);
    return { p, N };
  };
}
