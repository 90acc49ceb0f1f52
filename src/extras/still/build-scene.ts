// From declared values to a scene for the ray caster: what a viewer of this size shows at first.
import { Camera, Matrix4, Mesh, Scene, Vector3 } from 'three';
import { Orbit } from '../../phong/camera/orbit.js';
import type { LightState, LightValues, Term } from '../../phong/light/light-state.js';
import { cullsBackFaces } from '../../phong/material/back-faces.js';
import { lobeScale, PLAIN_LOOK } from '../../phong/material/file-surface.js';
import { cosDegrees, sinDegrees } from '../../phong/math/angle.js';
import { transformed, type Vec3 } from '../../phong/math/vector.js';
import { fitTo } from '../../phong/geometry/framing.js';
import { chosenLights, unknownLightText } from '../../phong/material/view/view-light.js';
import { type Quantity, viewEntry } from '../../phong/material/view/view-table.js';
import type { View } from '../../phong/material/views.js';
import { appearanceOf } from '../../phong/model/appearance.js';
import { requireAtMost } from '../../phong/model/budget.js';
import { LIMITS } from '../../phong/model/limits.js';
import type { MeshState } from '../../phong/model/mesh-fields.js';
import type { ContentPart } from '../../phong/model/model.js';
import { sampledSegments } from '../../phong/model/shapes/segments.js';
import { CLOSED } from '../../phong/model/shapes/shapes.js';
import type { CastCamera, CastMaterial, CastObject, CastOptions, CastScene } from './cast-scene.js';
import type { Declared, ViewerValues, Warn } from './markup.js';
import { meshShape } from './mesh-shape.js';
import { Contents, type ModelPlace } from './models.js';
import { countOf } from './placed.js';
import { Screen } from './screen.js';
import { measure } from '../../phong/geometry/bounds.js';
import { type Frustum } from '../../phong/geometry/frustum-clip.js';

type GeometryName = NonNullable<MeshState['values']['geometry']>;

/** A part of a declared mesh. */
interface PlacedPart {
  readonly state: MeshState;
  readonly part: ContentPart;
  /** The built-in shape that it is; null for a model's. */
  readonly shape: GeometryName | null;
  readonly object: Mesh;
}

/** @throws where something is declared that cannot be drawn, and names it. */
export async function castSceneOf(
  { viewer, lights, meshes }: Declared,
  { width, height }: CastOptions,
  place: ModelPlace,
): Promise<CastScene> {
  const { values } = viewer;
  const contents = new Contents(place);
  const { view, fov, theta, phi, reflection } = values;
  const { shows } = viewEntry(view);
  if (shows.by === 'triangles') throw new TypeError('a still cannot show view="triangles"');
  const scene = new Scene();
  const parts: PlacedPart[] = [];
  for (const state of [viewer as MeshState, ...meshes]) {
    parts.push(...(await partsOf(state, values, contents)));
    requireAtMost(parts.length, LIMITS.parts, 'draws', 'The still has');
  }
  for (const { object } of parts) {
    scene.add(object);
  }
  const fit = fitTo(measure(scene), values, fov, width / height);
  const radius = values.radius === 'auto' ? fit.radius : values.radius;
  const orbit = new Orbit({ theta, phi, radius, target: fit.target });
  const camera = { eye: orbit.eye(), ...orbit.basis(), fov };
  const { slopeX, slopeY } = new Screen(camera, width, height);
  const seen: Seen = {
    camera: threeCamera(camera, slopeX, slopeY),
    view: { frame: { ...camera, origin: ZERO }, slopeX, slopeY, radius },
    pixels: height / (2 * slopeY),
  };
  const objects: CastObject[] = [];
  let triangles = 0;
  for (const part of parts) {
    const object = await objectOf(part, values, seen, contents);
    triangles += countOf(object.shape);
    requireAtMost(triangles, LIMITS.triangles, 'triangles', 'The still has');
    objects.push(object);
  }
  const term = termOf(view);
  return {
    camera,
    lights: shownLights(lights, values, place.warn),
    objects,
    reflection,
    terms: term === null ? values.terms : [term],
    linear: values.colorInterpolation === 'linear',
    ...(shows.by === 'quantity' && { quantity: view as Quantity }),
  };
}

async function partsOf(
  state: MeshState,
  viewer: Readonly<ViewerValues>,
  contents: Contents,
): Promise<PlacedPart[]> {
  const { geometry, src } = state.values;
  const matrix = matrixOf(state.values);
  const placed = (part: ContentPart, shape: GeometryName | null): PlacedPart => {
    const object = new Mesh(part.geometry);
    object.matrixWorld.multiplyMatrices(matrix, part.matrix);
    return { state, part, shape, object };
  };
  if (src !== '') {
    const model = await contents.model(state.values, viewer.crossOrigin);
    return model.parts.map((part) => placed(part, null));
  }
  if (geometry === null) return [];
  const part: ContentPart = {
    name: geometry,
    geometry: await contents.geometry(geometry, undefined, false),
    matrix: new Matrix4(),
    look: PLAIN_LOOK,
    sides: CLOSED.has(geometry) ? 'closed' : 'double',
    surface: {},
  };
  return [placed(part, geometry)];
}

async function objectOf(
  { state, part, shape: name, object }: PlacedPart,
  viewer: Readonly<ViewerValues>,
  seen: Seen,
  contents: Contents,
): Promise<CastObject> {
  const { look, surface, sides, ...own } = appearanceOf(state, part);
  const shading = own.shading ?? viewer.shading;
  const matrix = object.matrixWorld.elements;
  const { segments } = state.values;
  const isAuto = segments === 'auto';
  const fine =
    name !== null && isAuto && shading === 'phong'
      ? sampledSegments(seen.view, seen.pixels, name, matrix)
      : null;
  const count = fine ?? (isAuto ? undefined : segments);
  const geometry =
    name === null ? part.geometry : await contents.geometry(name, count, fine !== null);
  const mesh = meshShape(geometry, look);
  const material: CastMaterial = {
    ...mesh.look,
    ...surface,
    shading,
    reflection: own.reflection ?? viewer.reflection,
    single: cullsBackFaces(sides, geometry, object.matrixWorld, seen.camera),
    lobeScale: look.roughness === null ? 1 : lobeScale(surface.shininess),
    // A view of one term is without emissive and unlit colours.
    ...(termOf(viewer.view) !== null && {
      emissive: ZERO,
      baseColor: look.unlit ? ZERO : look.baseColor,
    }),
  };
  if (part.geometry.boundingSphere === null) {
    part.geometry.computeBoundingSphere(); // as three.js does before it sorts
  }
  const { x, y, z } = part.geometry.boundingSphere!.center;
  // A copy: see the constructor of `surfaces.ts`. Millions of places are `transformed`.
  const center: Vec3 = [...transformed(matrix, x, y, z)];
  return { shape: mesh.shape, matrix, center, material };
}

/** The camera, and the pixels of a unit of length at depth 1. */
interface Seen {
  readonly camera: Camera;
  readonly view: Frustum;
  readonly pixels: number;
}

const ZERO: Vec3 = [0, 0, 0];

/** Its near plane is the eye, up to rounding. */
function threeCamera({ eye, right, up, back }: CastCamera, x: number, y: number): Camera {
  const camera = new Camera();
  const [near, far] = [1e-9, 1];
  camera.projectionMatrix.makePerspective(-x * near, x * near, y * near, -y * near, near, far);
  const [a, b, c] = [right, up, back].map((axis) => new Vector3(...axis));
  camera.matrixWorld.makeBasis(a!, b!, c!).setPosition(...eye);
  return camera;
}

/** The one term that a view shows; null for all, or another quantity. */
function termOf(view: View): Term | null {
  const { shows } = viewEntry(view);
  return shows.by === 'equation' ? shows.term : null;
}

/** The lights that the view is limited to. */
function shownLights(
  lights: readonly LightState[],
  values: Readonly<ViewerValues>,
  warn: Warn,
): readonly Readonly<LightValues>[] {
  const { viewLight } = values;
  const names = lights.map(({ values: { name } }, i) => name || `light ${String(i + 1)}`);
  const chosen = chosenLights(values, lights, (_, i) => names[i] === viewLight);
  if (viewLight !== '' && chosen.length === 0) {
    warn(unknownLightText(viewLight, names));
  }
  return chosen.map((i) => lights[i]!.values);
}

/** As three.js has it, order XYZ, but by degrees: right angles are exact. */
function matrixOf({ position, rotation, scale }: MeshState['values']): Matrix4 {
  const [x, y, z] = rotation ?? ZERO;
  const [a, b] = [cosDegrees(x), sinDegrees(x)];
  const [c, d] = [cosDegrees(y), sinDegrees(y)];
  const [e, f] = [cosDegrees(z), sinDegrees(z)];
  return new Matrix4(
    ...[c * e, -c * f, d, 0],
    ...[a * f + b * e * d, a * e - b * f * d, -b * c, 0],
    ...[b * f - a * e * d, b * e + a * f * d, a * c, 0],
    ...[0, 0, 0, 1],
  )
    .scale(new Vector3(...(scale ?? [1, 1, 1])))
    .setPosition(...(position ?? ZERO));
}
