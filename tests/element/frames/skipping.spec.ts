// Does unneeded work cost nothing, and does a change cost only itself? Counts WebGL calls beside
// the viewer's own `stats`, and compares pictures with the float64 equation over all declared
// lights.

import { HEADER, ROWS } from '../../../src/phong/light/light-layout.js';
import type { LightValues } from '../../../src/phong/light/light-state.js';
import { lightWith } from '../../stress/case.js';
import { type ViewerLocator, expect, pixels, test } from '../../support/test.js';
import { compareWithReference } from '../../visual/against-reference.js';
import { sceneMarkup } from '../../visual/random-scene.js';
import type { CastMesh, DeclaredScene } from '../../visual/ray-cast.js';
import { glSpent, logGl, type GlSpent } from '../support/gl-log.js';
import { nextFrame, settled, statsOf } from '../support/viewer.js';
import { RELEASE } from '../../support/repeats.js';

const size = { width: 60, height: 42 };

const LAMP = lightWith({
  diffuse: [150, 120, 90],
  specular: [60, 60, 60],
  position: [0.4, 1.5, 0.3, 1],
});
const SUN: LightValues = { ...LAMP, position: [1, 2, 1, 0] };
const SPOT: LightValues = { ...LAMP, axis: [0, -1, 0], aperture: 30 };

const FLOOR: CastMesh = {
  geometry: 'plane',
  position: [0, 0, 0],
  rotation: [0, 0, 0],
  scale: [2, 2, 2],
  ka: [200, 200, 200],
  kd: [220, 200, 180],
  ks: [90, 90, 90],
  shininess: 20,
};

const sceneOf = (lights: readonly LightValues[]): DeclaredScene => ({
  pose: { theta: 20, phi: 35, radius: 3.5, target: [0, 0, 0] },
  fov: 45,
  meshes: [FLOOR],
  lights,
  options: { reflection: 'phong', terms: ['ambient', 'diffuse', 'specular'], linear: false },
});

/** Replaces the viewer with this scene. */
async function show(viewer: ViewerLocator, scene: DeclaredScene) {
  await viewer.evaluate((element, html) => (element.outerHTML = html), sceneMarkup(scene));
  await settled(viewer);
}

/** Shows this scene and holds it against the equation. Returns the viewer's `stats`. */
async function showsTheEquation(viewer: ViewerLocator, scene: DeclaredScene, which: string) {
  await show(viewer, scene);
  const errors = compareWithReference(await pixels(viewer, size), scene);
  expect(errors.max, `${which}: ${errors.at}`).toBeLessThanOrEqual(1);
  expect(errors.compared, which).toBeGreaterThan(1000);
  return statsOf(viewer);
}

const DARK: Partial<LightValues> = { diffuse: [0, 0, 0], specular: [0, 0, 0] };
const AWAY: LightValues = { ...SPOT, axis: [0, 1, 0] };
const OFF: LightValues = { ...LAMP, active: false };

const WITHOUT_EFFECT: readonly LightValues[] = [
  { ...LAMP, ...DARK },
  { ...LAMP, ...DARK, ambient: [20, 30, 40] }, // summed beforehand
  { ...SPOT, axis: [1, -0.3, 0], aperture: 10 }, // its cone passes by
  { ...SUN, axis: [1, 2, 1], aperture: 60 }, // a cone that misses a sun
  { ...SUN, position: [0, 0, 0, 0] },
];

test('a light without effect is not sent, and the picture is the same', async ({ mount }) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  for (const [lights, sent, active] of [
    [[SUN, AWAY, ...WITHOUT_EFFECT], 1, 7],
    [[SUN, LAMP, OFF, SPOT, AWAY, ...WITHOUT_EFFECT], 3, 9],
  ] as const) {
    const stats = await showsTheEquation(viewer, sceneOf(lights), `${sent} sent`);
    expect(stats).toMatchObject({
      lightsSent: sent,
      lightsSentByMesh: [sent],
      lightsActive: active,
      lightsDeclared: lights.length,
    });
  }
});

/**
 * Ten directional lights, fifteen points and fifteen spots, in this order; together they declare
 * every feature.
 */
const CROWD: readonly LightValues[] = Array.from({ length: 40 }, (_, i): LightValues => {
  const dim: LightValues = { ...LAMP, ambient: [1, 1, 1], diffuse: [5, 4, 3], specular: [2, 2, 2] };
  const turn = (i / 40) * 2 * Math.PI;
  const round = (x: number) => Number(x.toFixed(3));
  if (i < 10) return { ...dim, position: [round(Math.cos(turn)), 1, round(Math.sin(turn)), 0] };
  const place = [round(Math.cos(turn)), 1.5, round(Math.sin(turn)), 1] as const;
  if (i < 25) return { ...dim, position: place, attenuation: [1, 0.1, 0.1] };
  return { ...dim, position: place, axis: [0, -1, 0], aperture: 50, cutoff: 2 };
});

/** Bytes of a row, a vec4 of floats. */
const ROW = 16;
const firstRow = (light: number) =>
  HEADER.rows +
  Math.min(light, 10) * ROWS.directional.rows +
  Math.min(Math.max(light - 10, 0), 15) * ROWS.point.rows +
  Math.max(light - 25, 0) * ROWS.spot.rows;
const ALL_ROWS = firstRow(40);

type Change = 'move' | 'recolour' | 'toggle' | 'remove' | 'add';

interface Cost extends GlSpent {
  readonly frames: number;
  readonly sent: number;
  readonly viewerUploads: number;
}

/**
 * Changes this many evenly spaced lights in one task, and returns the cost until the page is at
 * rest.
 */
function costOf(viewer: ViewerLocator, change: Change, count: number): Promise<Cost> {
  return viewer.evaluate(
    async (element, [what, some]) => {
      const rest = () =>
        new Promise<void>((resolve) =>
          requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve))),
        );
      await rest();
      const before = element.stats;
      window.glLog.take();
      const all = element.lights;
      for (let i = 0; i < some; i++) {
        const light = all[Math.floor((i * all.length) / some)]!;
        const [x, y, z, w] = light.position;
        if (what === 'move') {
          light.position = [x + 0.01, y + 0.01, z + 0.01, w];
        }
        if (what === 'recolour') {
          light.diffuse = [light.diffuse[0] === 5 ? 6 : 5, 4, 3];
        }
        if (what === 'toggle') {
          light.active = !light.active;
        }
        if (what === 'remove') {
          light.remove();
        }
        // Clones declare no new features.
        if (what === 'add') {
          element.append(light.cloneNode());
        }
      }
      await rest();
      const { frames, uploads, lightsSent: sent } = element.stats;
      const viewerUploads = uploads - before.uploads;
      return { ...window.glLog.take(), frames: frames - before.frames, viewerUploads, sent };
    },
    [change, count] as const,
  );
}

const COUNTS = RELEASE ? Array.from({ length: 40 }, (_, i) => i + 1) : [1, 7, 40];

test('one to forty lights that change together cost a frame, an upload and no program', async ({
  page,
  mount,
}) => {
  test.setTimeout(300_000);
  await logGl(page);
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  for (const count of COUNTS) {
    await show(viewer, sceneOf(CROWD));
    expect((await statsOf(viewer)).lightsSent).toBe(40);
    const last = Math.floor(((count - 1) * 40) / count);
    /** From the first changed light to the last one. */
    const span = (firstRow(last + 1) - HEADER.rows) * ROW;
    const steps: readonly (readonly [Change, bytes: number, sent: number])[] = [
      ['move', span, 40],
      ['recolour', span, 40],
      ['toggle', ALL_ROWS * ROW, 40 - count],
      ['toggle', ALL_ROWS * ROW, 40],
      ['add', (ALL_ROWS + count * ROWS.spot.rows) * ROW, 40 + count],
      ['move', (ALL_ROWS + count * ROWS.spot.rows) * ROW, 40 + count],
      ['remove', (ALL_ROWS + count * ROWS.spot.rows) * ROW, 40],
    ];
    for (const [change, bytes, sent] of steps) {
      const cost = await costOf(viewer, change, count);
      expect(cost, `${change} ${count}`).toMatchObject({
        frames: 1,
        draws: 1,
        links: 0,
        compiles: 0,
        uploads: 1,
        allocations: 0,
        viewerUploads: 1,
        sent,
      });
      expect(cost.bytes, `${change} ${count}`).toBeLessThanOrEqual(bytes);
      expect(cost.bytes, `${change} ${count}`).toBeGreaterThan(0);
    }
  }
});

test('the first light of a new kind or feature compiles one program at most, the next 0', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const viewer = await mount(
    '<phong-viewer geometry="plane"><phong-light></phong-light></phong-viewer>',
    size,
  );
  const needs: Readonly<Record<string, string>> = {
    'attenuated point': 'position="0 1 0 1" attenuation="1 1 1"',
    'spot with decay': 'position="0 1 0 1" axis="0 -1 0" aperture="40" cutoff="3"',
    ambient: 'ambient="9"',
    'narrow cone': 'position="0 1 0 1" axis="0 -1 0" aperture="5"',
    'spot with all of it':
      'ambient="9" position="0 1 0 1" axis="0 -1 0" aperture="40" cutoff="3" attenuation="1 1 1"',
  };
  for (const [which, attributes] of Object.entries(needs)) {
    const links: number[] = [];
    for (let i = 0; i < 2; i++) {
      await glSpent(page);
      await viewer.evaluate(
        (element, html) => element.insertAdjacentHTML('beforeend', html),
        `<phong-light ${attributes}></phong-light>`,
      );
      await nextFrame(page);
      links.push((await glSpent(page)).links);
    }
    expect([which, ...links]).toEqual([which, which === 'spot with all of it' ? 0 : 1, 0]);
  }
});

test('the first pictures of equal spheres send one level of them, once', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const sphere = '<phong-viewer geometry="sphere"></phong-viewer>';
  await mount(sphere + sphere, { width: 120, height: 120 });
  const [around, rows] = [64, 32];
  // Of a vertex the place, normal and texture coordinates as floats; indices of 16 bits.
  const bufferBytes = 4 * (3 + 3 + 2) * (around + 1) * (rows + 1) + 2 * 3 * 2 * around * (rows - 1);
  expect(await glSpent(page)).toMatchObject({ draws: 2, bufferBytes });
});
