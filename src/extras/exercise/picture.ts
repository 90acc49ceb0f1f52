// The points of a viewer's picture, as a learner's function is given them: one for each pixel that
// shows a surface, with each lamp in world space.
import {
  add,
  dot,
  length,
  map,
  ORIGIN,
  scale,
  subtract,
  type Vec3,
} from '../../phong/math/vector.js';
import {
  type CameraAxes,
  coefficientsOf,
  decoded,
  toWorld,
} from '../../phong/reference/equation.js';
import type { ViewerSnapshot } from '../../viewer/extra.js';
import { pick, shadedPoint } from '../explain/pick.js';
import { refused } from './guard.js';
import { kindOf } from '../../phong/light/light-features.js';
import type { Case, Work } from '../../phong/mistakes/judge.js';
import { lampOf } from '../../phong/mistakes/steps.js';
import { type Lamp, NO_CONE, only, type Scene, type Task } from '../../phong/mistakes/sheet.js';

export interface PicturePoints {
  readonly width: number;
  readonly height: number;
  readonly cases: readonly Case[];
  /** The pixel of each case, counted in rows from the top. */
  readonly pixels: readonly number[];
  readonly axes: CameraAxes;
  /** Colours are summed in linear light, and encoded when they are shown. */
  readonly linear: boolean;
  /** What the surface of each case adds to the sum itself. */
  readonly emissive: readonly Vec3[];
}

/** Enough for a picture of 300 × 200. */
const MOST_PIXELS = 60_000;

/**
 * Null where the viewer draws nothing. Throws {@link Refused} for an exponent that an exercise cannot
 * have.
 */
export function* pointsOf(
  { scene, lights }: ViewerSnapshot,
  task: Task,
): Work<PicturePoints | null> {
  if (scene === null) return null;
  const shrink = Math.min(1, Math.sqrt(MOST_PIXELS / (scene.width * scene.height)));
  const width = Math.max(Math.round(scene.width * shrink), 1);
  const height = Math.max(Math.round(scene.height * shrink), 1);
  const { origin, eye } = scene.frame;
  const world = add(origin, eye);
  const cases: Case[] = [];
  const pixels: number[] = [];
  const emissive: Vec3[] = [];
  // All surfaces of a viewer are shaded in one space.
  const linear = scene.objects.some(({ phong }) => phong?.linear === true);
  const lamps = lights
    .filter(({ values }) => values.active && task.kinds.includes(kindOf(values)))
    .map(({ values }) => only(task.terms, placed(values, world, scene.frame, linear)));
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      yield;
      const hit = yield* pick({ ...scene, width, height }, column, row);
      if (hit === null || hit.drawn.phong.look.unlit) continue;
      const { surface, normal } = shadedPoint(hit);
      const { shininess } = surface;
      if (shininess < 1 || shininess > 256) {
        throw refused('The exponent is {n} in this picture: an exercise needs 1 to 256.', null, {
          n: shininess,
        });
      }
      const given = {
        material: { ...coefficientsOf(surface, linear), shininess },
        // As the driver gets them: far from the origin a rounding is seen.
        p: map(add(origin, hit.p), Math.fround),
        normal,
        eye: map(world, Math.fround),
        reflection: task.reflection,
        terms: task.terms,
      };
      cases.push(lamps.map((light) => ({ ...given, light })));
      pixels.push(row * width + column);
      emissive.push(decoded(surface.emissive, linear));
    }
  }
  return { width, height, cases, pixels, axes: scene.frame, linear, emissive };
}

/** A light in world space, with 1 as full; one without a cone or decay has some axis. */
function placed(
  light: ViewerSnapshot['lights'][number]['values'],
  eye: Vec3,
  axes: CameraAxes,
  linear: boolean,
): Lamp {
  const isCamera = light.space === 'camera';
  const turned = (v: Vec3) => (isCamera ? toWorld(axes, v) : v);
  const [x, y, z, w] = light.position;
  const place = add(isCamera && w === 1 ? eye : ORIGIN, turned([x, y, z]));
  const axis = turned(light.axis);
  return {
    ...lampOf(light, linear),
    position: [...map(place, Math.fround), w],
    ...(dot(axis, axis) > 0 ? { axis } : NO_CONE),
  };
}

/** The same picture as a test scene: with its lamp, its size, its exponent and the length of its normals. */
export function underScene(
  picture: PicturePoints,
  scene: Scene,
  terms: Task['terms'],
): PicturePoints {
  const points = picture.cases.flat().map(({ p }) => p);
  const center = scale(points.reduce<Vec3>(add, ORIGIN), 1 / points.length);
  const size = points.reduce((most, p) => Math.max(most, length(subtract(p, center))), 1e-6);
  const { right, up, back } = picture.axes;
  const turned = (v: Vec3): Vec3 => [dot(right, v), dot(up, v), dot(back, v)];
  const placed = (p: Vec3) => map(turned(subtract(p, center)), (x) => Math.fround(x / size));
  const light = only(terms, {
    ...scene,
    ambient: [0.25, 0.25, 0.25],
    diffuse: [0.9, 0.9, 0.9],
    specular: [0.9, 0.9, 0.9],
  });
  // One lamp, however many the picture has.
  const cases = picture.cases.map((at) =>
    at.slice(0, 1).map((given) => ({
      ...given,
      light,
      p: placed(given.p),
      normal: scale(turned(given.normal), scene.normal),
      eye: placed(given.eye),
      material: { ...given.material, shininess: scene.shininess },
    })),
  );
  return { ...picture, cases };
}
