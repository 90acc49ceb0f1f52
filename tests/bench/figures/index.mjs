// @ts-check
// Which figures there are: what each compares, and the ratio it is to stay under.

import { figure } from '../report.mjs';
import { frameTimes } from './frame-time.mjs';
import { interleaved } from '../statistics.mjs';
import { differences, scriptTimes, total } from './script-time.mjs';
import { allShown, startOf } from './start.mjs';

/**
 * @typedef {import('./frame-time.mjs').FrameOptions & { counts: number[], software: boolean }} Settings
 * @typedef {(session: import('../session.mjs').Session, settings: Settings) => AsyncGenerator<import('../report.mjs').Figure>} Measure
 */

/** @type {Record<string, Measure>} */
export const FIGURES = { frame, loop, raw, idle, script, start, viewers };

/** The ratio to MeshPhong to stay under. @param {number} lights @param {boolean} software */
function frameAim(lights, software) {
  if (!software) return lights === 1 ? 0.9 : lights >= 8 ? 0.5 : undefined;
  if (lights <= 4 || (lights > 64 && lights <= 128)) return 0.5;
  return lights <= 64 ? 0.7 : 0.3;
}

/** @param {number} lights @param {import('./frame-time.mjs').Scene['kind']} [kind] @returns {import('./frame-time.mjs').Scene} */
const sceneOf = (lights, kind = 'mixed') => ({
  name: `${lights} ${kind}`,
  lights,
  active: lights,
  kind,
});

const ELEMENT = { name: 'element', peer: 'element' };

/** @param {readonly number[]} counts */
const mixedScenes = (counts) =>
  counts.flatMap((lights) =>
    lights === 1 ? [sceneOf(1, 'directional'), sceneOf(1, 'point'), sceneOf(1, 'spot')] : [sceneOf(lights)],
  );

/** @type {Measure} */
async function* frame(session, settings) {
  const peers = [
    { name: 'MeshPhong', peer: 'mesh-phong' },
    { name: 'MeshPhong unencoded', peer: 'mesh-phong-linear' },
    // What a frame costs before any light: no ratio to MeshPhong can fall below its share.
    { name: 'unlit', peer: 'unlit' },
  ];
  yield* againstPhong(session, settings, [ELEMENT, ...peers]);
}

/** The programs alone: at one sample a pixel little is left besides them. @type {Measure} */
async function* loop(session, settings) {
  /** @type {readonly import('./frame-time.mjs').Subject[]} */
  const subjects = [
    { name: 'core', peer: 'core', samples: 1 },
    { name: 'MeshPhong', peer: 'mesh-phong', samples: 1 },
    { name: 'unlit', peer: 'unlit', samples: 1 },
  ];
  yield* againstPhong(session, settings, subjects);
}

/**
 * The first subject against each other one.
 * @param {import('../session.mjs').Session} session @param {Settings} settings
 * @param {readonly import('./frame-time.mjs').Subject[]} subjects
 */
async function* againstPhong(session, settings, subjects) {
  for (const scene of mixedScenes(settings.counts)) {
    const [ours, ...others] = await frameTimes(session, scene, subjects, settings);
    for (const other of others) {
      // The aim is for three.js as it comes; without its encoding it does a little less than a page asks of it.
      const atMost = other.name === 'MeshPhong' ? frameAim(scene.lights, settings.software) : undefined;
      const note = `programs ${ours?.settled.map(({ programs }) => programs).join()}`;
      const name = `${scene.name}: ${ours?.name} / ${other.name}`;
      yield figure(name, 'ms', ours?.ms ?? [], other.ms, { atMost, note });
    }
  }
}

/** @type {Measure} */
async function* raw(session, settings) {
  for (const lights of settings.counts) {
    const subjects = [ELEMENT, { name: 'raw', peer: 'raw' }];
    const [ours, bare] = await frameTimes(session, sceneOf(lights), subjects, settings);
    yield figure(`${lights} mixed: element / raw WebGL 2`, 'ms', ours?.ms ?? [], bare?.ms ?? [], {
      atMost: 1.05,
    });
  }
}

/** @type {Measure} */
async function* idle(session, settings) {
  const few = sceneOf(8);
  const many = { ...few, name: '8 of 1,000', lights: 1000 };
  const subjects = [{ ...ELEMENT, name: many.name, scene: many }, ELEMENT];
  const [ours, bare] = await frameTimes(session, few, subjects, settings);
  const most = Math.max(...(ours?.settled ?? []).map((settled) => settled.most));
  yield figure('8 active of 1,000 / 8 of 8', 'ms', ours?.ms ?? [], bare?.ms ?? [], {
    atMost: 1.02,
    note: `programs ${most}`,
  });
}

/** @type {Measure} */
async function* script(session, settings) {
  for (const lights of [1, 8, 32, 128]) {
    const { times, calls } = await scriptTimes(session, lights, settings);
    const { moving = {}, still = {}, unlit = {} } = calls;
    const extra = total(moving) - total(still);
    yield figure(`${lights} moving lights / three.js, one unlit mesh`, 'µs', times.moving, times.unlit, {
      atMost: 1.15,
      note: `WebGL calls ${total(moving)}, still ${total(still)} (at most 4 more: ${extra <= 4 ? 'met' : 'MISSED'}; ${differences(moving, still)})`,
    });
    yield figure(`${lights} moving lights / three.js, the mesh turning`, 'µs', times.moving, times.turning);
    yield figure(`${lights} lights: setting positions alone`, 'µs', times.setting, times.unlit);
    yield figure(`${lights} lights: a still frame`, 'µs', times.still, times.unlit, {
      note: `WebGL calls against three.js's ${total(unlit)}: ${differences(still, unlit)}`,
    });
  }
}

/**
 * Starts of pages in turns, one after another.
 * @param {import('../session.mjs').Session} session @param {Pick<Settings, 'launches' | 'rounds'>} settings
 * @param {readonly { path: string, tag?: string, count?: number }[]} pages
 */
export async function startsOf(session, { launches, rounds }, pages) {
  /** @type {import('./start.mjs').Start[][]} */
  const starts = pages.map(() => []);
  const indices = pages.map((_, i) => i);
  await interleaved(indices, launches * rounds, async (i) => {
    const { path, tag, count = 1 } = pages[i] ?? { path: '' };
    const check =
      tag === undefined
        ? {}
        : { check: (/** @type {import('playwright-core').Page} */ page) => allShown(page, tag, count) };
    const start = await startOf(session, path, check);
    starts[i]?.push(start);
    return start.ms;
  });
  /** @param {number} i @param {keyof import('./start.mjs').Start} key */
  return (i, key) => (starts[i] ?? []).map((start) => start[key]);
}

/** @type {Measure} */
async function* start(session, settings) {
  const of = await startsOf(session, settings, [
    { path: 'start-element.html', tag: 'phong-viewer' },
    { path: 'start-three.html', tag: '#holder' },
  ]);
  yield figure('navigation to first frame: element / plain three.js', 'ms', of(0, 'ms'), of(1, 'ms'), {
    atMost: 1.05,
  });
  yield figure('the same, CPU time of the page', 'ms', of(0, 'pageMs'), of(1, 'pageMs'));
  yield figure('the same, CPU time of the GPU process', 'ms', of(0, 'gpuMs'), of(1, 'gpuMs'));
  yield figure('heap after garbage collection', 'KiB', of(0, 'heap'), of(1, 'heap'), { atMost: 1.25 });
  yield figure('fetched, uncompressed', 'KiB', of(0, 'bytes'), of(1, 'bytes'));
}

/** @type {Measure} */
async function* viewers(session, settings) {
  const counts = [1, 16, 64];
  /** @type {Record<number, number>} */
  const aims = { 16: 0.2, 64: 0.35 };
  const ours = counts.map((count) => ({
    path: `viewers-element.html?count=${count}`,
    tag: 'phong-viewer',
    count,
  }));
  const theirs = counts.map((count) => ({
    path: `viewers-model-viewer.html?count=${count}`,
    tag: 'model-viewer',
    count,
  }));
  const of = await startsOf(session, settings, [...ours, ...theirs]);
  for (const [i, count] of counts.entries()) {
    const [us, them] = [i, i + counts.length];
    const name = `${count} viewers: element / <model-viewer>`;
    yield figure(`${name}, to all lit`, 'ms', of(us, 'ms'), of(them, 'ms'), { atMost: aims[count] });
    yield figure(`${name}, CPU time of the page`, 'ms', of(us, 'pageMs'), of(them, 'pageMs'));
    yield figure(`${name}, CPU time of the GPU process`, 'ms', of(us, 'gpuMs'), of(them, 'gpuMs'));
  }
  yield figure('16 elements / 1 element, to all lit', 'ms', of(1, 'ms'), of(0, 'ms'), { atMost: 1.3 });
  yield figure('16 elements / 1 element, CPU time of the page', 'ms', of(1, 'pageMs'), of(0, 'pageMs'));
  yield figure('16 elements / 1 element, CPU time of the GPU process', 'ms', of(1, 'gpuMs'), of(0, 'gpuMs'));
}
