// Does a highlight smaller than a pixel have the right brightness? Compares antialias="highlights" with float64
// averages over many samples per pixel and, where nothing is undersampled, with antialias="edges".

import type { Locator } from '@playwright/test';
import { basisOf } from '../../src/camera/orbit.js';
import { LIGHT_FIELDS, type LightValues } from '../../src/light/light-state.js';
import { add, dot, scale, type Vec3 } from '../../src/math/vector.js';
import { logGl } from '../element/support/gl-log.js';
import { assign, type PhongViewer } from '../element/support/viewer.js';
import { compare, expect, type Picture, pixelAt, pixels, test } from '../support/test.js';
import { firstOf } from '../support/repeats.js';
import { Random } from '../stress/random.js';
import { betweenPrograms, bothPictures, DifferenceSum } from './between-programs.js';
import { look, SIZE } from './program-scenes.js';
import { sceneMarkup } from './random-scene.js';
import { caster, type CastMesh, type DeclaredScene, lens } from './ray-cast.js';

const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
/** Along each side of a pixel, of the converged picture. */
const SAMPLES = 16;
/** Pixels to each side of a highlight's centre that are compared. */
const AROUND = 5;

const light = (values: Partial<LightValues>): LightValues => ({
  ...(Object.fromEntries(
    Object.entries(LIGHT_FIELDS).map(([key, field]) => [key, field.fallback]),
  ) as unknown as LightValues),
  ...values,
});

/** Specular light alone, so that a code of 255 is 1/255 of the lobe. */
function shiny(geometry: CastMesh['geometry'], shininess: number, size = 1): CastMesh {
  const [none, all] = [[0, 0, 0] as const, [255, 255, 255] as const];
  const place = { position: none, rotation: none, scale: [size, size, size] as const };
  return { geometry, ka: none, kd: none, ks: all, shininess, ...place };
}

interface View {
  readonly scene: DeclaredScene;
  readonly size: { readonly width: number; readonly height: number };
}

/** A sphere of so many pixels, seen from four diameters away. */
function sphere(diameter: number, shininess: number, lights: LightValues[]): View {
  const side = diameter + 24;
  const radius = 4;
  const outline = Math.tan(Math.asin(0.5 / radius));
  return {
    size: { width: side, height: side },
    scene: {
      pose: { theta: 20, phi: 70, radius, target: [0, 0, 0] },
      fov: (2 * Math.atan((outline * side) / diameter) * 180) / Math.PI,
      meshes: [{ ...shiny('sphere', shininess), segments: 128 }],
      lights,
      options: { terms: ['specular'] },
    },
  };
}

/** Where the eye sees a point, in pixels, whose centres are whole. */
function seenAt({ scene, size: { width, height } }: View, p: Vec3): readonly [number, number] {
  const { axes, eyeOffset, pixel } = lens(scene, width, height);
  const from = add(p, scale(eyeOffset, -1));
  const depth = -dot(from, axes.back);
  const [x, y] = [dot(from, axes.right) / depth / pixel, dot(from, axes.up) / depth / pixel];
  return [width / 2 + x - 0.5, height / 2 - y - 0.5];
}

interface Errors {
  max: number;
  squares: number;
  count: number;
}

const none = (): Errors => ({ max: 0, squares: 0, count: 0 });

/** Of the pixels around a highlight, in 1/255: what float64 gives on the average, before rounding. */
function noteErrors(
  { scene, size }: View,
  at: readonly [number, number],
  pictures: Record<string, Picture>,
  errors: Record<string, Errors>,
): void {
  // prettier-ignore
  const cast = caster(scene, size.width, size.height);
  for (let y = Math.round(at[1]) - AROUND; y <= at[1] + AROUND; y++) {
    for (let x = Math.round(at[0]) - AROUND; x <= at[0] + AROUND; x++) {
      let sum = 0;
      let inside = true;
      for (let i = 0; i < SAMPLES; i++) {
        for (let k = 0; k < SAMPLES; k++) {
          const hit = cast(x + (i + 0.5) / SAMPLES - 0.5, y + (k + 0.5) / SAMPLES - 0.5);
          inside &&= hit !== null;
          sum += hit?.shaded.color[0] ?? 0;
        }
      }
      if (!inside) continue;
      const wanted = (255 * sum) / SAMPLES ** 2;
      for (const [name, picture] of Object.entries(pictures)) {
        const error = Math.abs(pixelAt(picture, x, y)[0] - wanted);
        const of = (errors[name] ??= none());
        of.max = Math.max(of.max, error);
        of.squares += error ** 2;
        of.count += 1;
      }
    }
  }
}

/** Codes, largest and root mean square, of filtered highlights as measured: a tenth more is a change. */
type Measured = readonly [max: number, rmse: number];

const SPHERES: readonly (readonly [diameter: number, shininess: number, Measured])[] = [
  [16, 1e3, [7.35, 0.76]],
  [120, 1e4, [5.09, 0.37]],
  [40, 1e4, [3.42, 0.28]],
  [16, 1e4, [1.84, 0.12]],
  [40, 1e3, [2.77, 0.26]],
  [40, 1e5, [0.24, 0.02]],
  // Vertices lie on sixteenths of a pixel here, a 60th of this highlight's width.
  [120, 1e3, [3.83, 0.62]],
  [120, 1e5, [3.88, 0.26]],
];

const FLOORS: readonly (readonly ['phong' | 'blinn-phong', shininess: number, height: number, Measured])[] = [
  ['phong', 1e4, 0.3, [5.62, 0.54]],
  ['blinn-phong', 1e4, 0.3, [4.32, 0.43]],
  ['phong', 1e5, 2, [0.76, 0.11]],
  ['blinn-phong', 1e5, 2, [4.27, 0.44]],
  ['phong', 1e3, 0.3, [2.53, 0.42]],
  ['phong', 1e4, 2, [2.22, 0.41]],
  ['blinn-phong', 1e3, 0.3, [2.74, 0.49]],
  ['blinn-phong', 1e4, 2, [1.76, 0.48]],
];

function expectBetter(errors: Record<string, Errors>, [max, square]: Measured, where: string): void {
  const { edges, highlights } = errors as { edges: Errors; highlights: Errors };
  // Other seeds than the one that was measured have other highlights.
  if (SEED === 1) expect.soft(highlights.max, where).toBeLessThanOrEqual(1.1 * max + 0.01);
  if (SEED === 1) expect.soft(rmse(highlights), where).toBeLessThanOrEqual(1.1 * square + 0.01);
  expect.soft(highlights.max, where).toBeLessThan(12);
  expect.soft(rmse(edges), where).toBeGreaterThan(2 * rmse(highlights));
}

const rmse = ({ squares, count }: Errors): number => Math.sqrt(squares / count);

/** Its code is fetched when it is first asked for. */
async function averaged(viewer: Locator): Promise<void> {
  await assign(viewer, { antialias: 'highlights' });
  await viewer.evaluate((element: PhongViewer) => element.ready);
}

async function bothKinds(viewer: Locator, { scene, size }: View): Promise<Record<string, Picture>> {
  await viewer.evaluate((element, text) => (element.outerHTML = text), sceneMarkup(scene, 'phong'));
  const edges = await pixels(viewer, size);
  await averaged(viewer);
  return { edges, highlights: await pixels(viewer, size) };
}

const summary = (errors: Record<string, Errors>): string =>
  Object.entries(errors)
    .map(([name, of]) => `${name} ${of.max.toFixed(2)} (rmse ${rmse(of).toFixed(2)})`)
    .join(', ');

test(`shows highlights of small spheres with their average brightness (seed ${SEED})`, async ({ mount }) => {
  test.setTimeout(300_000);
  const viewer = await mount('<phong-viewer></phong-viewer>', { width: 100, height: 100 });
  for (const [diameter, shininess, measured] of firstOf(SPHERES, 2)) {
    const random = new Random(SEED + diameter + shininess);
    const errors: Record<string, Errors> = {};
    for (let i = 0; i < 4; i++) {
      const view = sphere(diameter, shininess, []);
      const { back } = basisOf(view.scene.pose);
      // Half-way between light and eye, up to 30° off the eye: the highlight is well inside.
      const half = random.around([...back] as Vec3, random.from(0, Math.PI / 6));
      const L = add(scale(half, 2 * dot(half, back)), scale(back, -1));
      const lit: View = { ...view, scene: { ...view.scene, lights: [light({ position: [...L, 0] })] } };
      noteErrors(lit, seenAt(lit, scale(half, 0.5)), await bothKinds(viewer, lit), errors);
    }
    console.log(`sphere of ${diameter} pixels, shininess ${shininess}: ${summary(errors)}`);
    expectBetter(errors, measured, `${diameter} pixels, shininess ${shininess}`);
  }
});

/** A floor under a lamp at this height, seen from five units away. */
function floor(height: number, shininess: number, reflection: 'phong' | 'blinn-phong'): View {
  return {
    size: { width: 150, height: 110 },
    scene: {
      pose: { theta: 0, phi: 55, radius: 5, target: [0, 0, 0] },
      fov: 45,
      meshes: [shiny('plane', shininess, 6)],
      lights: [light({ position: [0.2, height, 0.1, 1] })],
      options: { reflection, terms: ['specular'] },
    },
  };
}

test('shows highlights of lamps near a floor with their average brightness', async ({ mount }) => {
  test.setTimeout(300_000);
  const viewer = await mount('<phong-viewer></phong-viewer>', { width: 150, height: 110 });
  for (const [reflection, shininess, height, measured] of firstOf(FLOORS, 4)) {
    const view = floor(height, shininess, reflection);
    const { back } = basisOf(view.scene.pose);
    const eye = scale(back, 5);
    // Mirrored in the floor, the lamp is seen through the highlight.
    const t = eye[1] / (eye[1] + height);
    const at: Vec3 = [eye[0] + t * (0.2 - eye[0]), 0, eye[2] + t * (0.1 - eye[2])];
    const errors: Record<string, Errors> = {};
    noteErrors(view, seenAt(view, at), await bothKinds(viewer, view), errors);
    const where = `${reflection}, shininess ${shininess}, lamp ${height} above`;
    console.log(`${where}: ${summary(errors)}`);
    expectBetter(errors, measured, where);
  }
});

test('changes codes by at most one where no highlight is undersampled, as on a floor', async ({ mount }) => {
  const size = { width: 200, height: 140 };
  const viewer = await mount(
    `<phong-viewer geometry="plane" shininess="32" phi="50" theta="10">
      <phong-light position="-1 2 -1 0" ambient="20" diffuse="90"></phong-light>
      <phong-light position="0.3 1 0 1" diffuse="60" attenuation="1 0.3 0"></phong-light>
    </phong-viewer>`,
    size,
  );
  for (const reflection of ['phong', 'blinn-phong']) {
    await assign(viewer, { reflection, antialias: 'edges' });
    const edges = await pixels(viewer, size);
    await averaged(viewer);
    const { max } = compare(edges, await pixels(viewer, size));
    expect(max, reflection).toBeLessThanOrEqual(1);
  }
});

test('changes no bit under Gouraud shading, and `edges` is the default', async ({ mount }) => {
  const viewer = await mount(
    `<phong-viewer geometry="sphere" shininess="5000"><phong-light></phong-light></phong-viewer>`,
    SIZE,
  );
  for (const shading of ['phong', 'gouraud']) {
    await assign(viewer, { shading, antialias: null });
    const before = await pixels(viewer, SIZE);
    await assign(viewer, { antialias: 'edges' });
    expect(compare(before, await pixels(viewer, SIZE)).max, shading).toBe(0);
    await averaged(viewer);
    const { max } = compare(before, await pixels(viewer, SIZE));
    if (shading === 'gouraud') expect(max).toBe(0);
    else expect(max).toBeGreaterThan(1);
  }
});

test('stays between zero and the full specular light at horizons, slivers and folded triangles', async ({
  mount,
}) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const lights =
    '<phong-light position="0 0.2 -1 0" ambient="40" diffuse="60" specular="200"></phong-light>' +
    '<phong-light position="0 0.001 0" diffuse="60" specular="200"></phong-light>';
  const meshes = {
    'a floor to its horizon': 'geometry="plane" position="0 -0.5 0" scale="1e6 1 1e6"',
    'a sliver': 'geometry="cylinder" segments="3" rotation="0 10 90" scale="1e-3 3 1e-3"',
    'a flattened torus': 'geometry="torus" scale="2 0 2" rotation="80 0 0"',
    'a point': 'geometry="sphere" scale="0"',
    'a far one': 'geometry="sphere" position="0 0 -1e6" scale="1e5"',
  };
  for (const [name, mesh] of Object.entries(meshes)) {
    for (const [shininess, reflection] of [
      [0, 'phong'],
      [1e3, 'blinn-phong'],
      [1e6, 'phong'],
    ] as const) {
      await viewer.evaluate(
        (element, html) => (element.outerHTML = html),
        `<phong-viewer theta="0" phi="89.9" radius="4" target="0 0 0" reflection="${reflection}" antialias="highlights">
          <phong-mesh ka="255" kd="200" ks="255" shininess="${shininess}" ${mesh}></phong-mesh>${lights}</phong-viewer>`,
      );
      const whole = await pixels(viewer, SIZE);
      await assign(viewer, { terms: 'ambient diffuse' });
      const without = await pixels(viewer, SIZE);
      const less = whole.data.findIndex((code, i) => code < without.data[i]! - 1);
      expect(less, `${name}, shininess ${shininess}: where light is lost`).toBe(-1);
      expect(whole.data.filter((_, i) => i % 4 === 3)).toEqual(without.data.filter((_, i) => i % 4 === 3));
    }
  }
});

test('is filtered the same by general and specialised programs', async ({ page, mount }) => {
  test.setTimeout(120_000);
  await logGl(page);
  await mount('<phong-viewer></phong-viewer>', SIZE);
  const names = [
    ...['shininess 32', 'shininess 33.5', 'shininess 1e3', 'blinn-phong', 'blinn-phong, shininess 200'],
    ...['flat', 'linear', 'specular alone'],
  ];
  const markups = names.map((name) => {
    const { scene, shading } = look(name);
    return sceneMarkup(scene, shading).replace('<phong-viewer', '<phong-viewer antialias="highlights"');
  });
  const sum = new DifferenceSum();
  for (const [i, { general, specialised }] of (await bothPictures(page, markups, SIZE)).entries()) {
    const difference = betweenPrograms(general, specialised);
    expect.soft(difference.max, names[i]).toBeLessThanOrEqual(1);
    sum.add(difference);
  }
  console.log(`${names.length} looks with highlights filtered: ${String(sum)}`);
  sum.expectPromise();
});
