// @ts-check
// Which figures there are: what each compares, and the ratio it is to stay under.

import { figure } from '../report.mjs';
import { frameTimes } from './frame-time.mjs';
import { differences, scriptTimes, total } from './script-time.mjs';

/**
 * @typedef {import('./frame-time.mjs').FrameOptions & { counts: number[], software: boolean }} Settings
 * @typedef {(session: import('../session.mjs').Session, settings: Settings) => AsyncGenerator<import('../report.mjs').Figure>} Measure
 */

/** @type {Record<string, Measure>} */
export const FIGURES = { frame, raw, idle, script };

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

/** @type {Measure} */
async function* frame(session, settings) {
  const scenes = settings.counts.flatMap((lights) =>
    lights === 1 ? [sceneOf(1, 'directional'), sceneOf(1, 'point'), sceneOf(1, 'spot')] : [sceneOf(lights)],
  );
  const peers = [
    { name: 'MeshPhong', peer: 'mesh-phong' },
    { name: 'MeshPhong unencoded', peer: 'mesh-phong-linear' },
  ];
  for (const scene of scenes) {
    const [ours, ...others] = await frameTimes(session, scene, [ELEMENT, ...peers], settings);
    for (const other of others) {
      // The aim is for three.js as it comes; without its encoding it does a little less than a page asks of it.
      const atMost = other.name === 'MeshPhong' ? frameAim(scene.lights, settings.software) : undefined;
      const note = `programs ${ours?.settled.map(({ programs }) => programs).join()}`;
      yield figure(`${scene.name}: element / ${other.name}`, 'ms', ours?.ms ?? [], other.ms, {
        atMost,
        note,
      });
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
