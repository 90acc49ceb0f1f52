// @ts-check
// What the bench holds the product to, and where a result has the figure for each line. A line is a limit, which fails the nightly
// bench when it is missed, or on some kinds of stack an aim that is not reached yet.

import { CODES, full, PLAIN, pictureValue, RMSE, SSAA, ssaa, TAA, taa, WITHIN } from './pictures.mjs';
import { FIRST_MODELS } from './models.mjs';
import { ratioOf, ratioOverSubjects, rowOf, valueOf } from './results.mjs';
import { spread } from './statistics.mjs';
import {
  firstModelSubject,
  FRAMED_LIGHTS,
  FRAMED_SHAPES,
  framedSubject,
  modelSubjects,
  NETWORKS,
  PICTURES,
  pictureSubject,
  SPHERE_LIGHTS,
} from './subjects.mjs';

/**
 * @typedef {object} Aim
 * @property {string} label
 * @property {string} subject
 * @property {readonly string[]} [subjects] the figure is their median ratio to the better of the other sides; with `against`,
 *   their worst ratio to the best of these sides
 * @property {readonly string[]} [against]
 * @property {string} measure
 * @property {string} [side] default: the first
 * @property {'ratio' | 'value' | 'over usual'} [figure] default: ratio. `over usual`: milliseconds above the usual frame
 * @property {{ software?: number, gpu?: number }} most `least` turns it round
 * @property {boolean} [least]
 */

/** By the number of lights of SPHERE_LIGHTS. */
const FIRST = { gpu: [1, 1, 1, 1, 1, 1.05, 1.05], software: [1.15, 1.15, 1.15, 1, 0.9, 0.9, 0.9] };
const SETTLED = {
  gpu: [1.03, 1.03, 0.82, 0.73, 0.62, 0.9, 0.85],
  software: [0.85, 0.5, 0.3, 0.25, 0.9, 0.9, 0.9],
};
/** How much longer than the usual frame the take-over may make one frame, in milliseconds. */
export const TAKE_OVER_MS = { software: 400, gpu: 50 };

/** @param {number} x */
const both = (x) => ({ software: x, gpu: x });
/** @param {number} count */
const sphere = (count) => `sphere, ${count === 1 ? '1 light' : `${count} lights`}`;

/** Most RMSE, and least share of pixels within one code in %, with so many samples. */
const PICTURE_AIMS = /** @type {const} */ ({
  sphere: { 64: 0.5, 256: 0.35, round: 0.6, within: 98 },
  torus: { 64: 0.5, 256: 0.35, round: 0.6, within: 98 },
  'textured GLB': { 64: 0.5, 256: 0.35, within: 98 },
  'teapot on a floor': { 64: 0.7, 256: 0.4, within: 97 },
});

/** @returns {Aim[]} */
function pictureAims() {
  const ofOne = Object.entries(PICTURE_AIMS).flatMap(([picture, aims]) => {
    const subject = pictureSubject(/** @type {keyof typeof PICTURES} */ (picture));
    /** @param {string} label @param {string} measure @param {number} samples @param {number} most @returns {Aim} */
    const aim = (label, measure, samples, most) => ({
      ...{ label: `${picture}, ${label}, ${samples} samples`, subject, measure, side: full(samples) },
      ...{ figure: 'value', most: both(most), least: measure === WITHIN },
    });
    return [
      aim('RMSE', RMSE.triangles, 64, aims[64]),
      aim('RMSE', RMSE.triangles, 256, aims[256]),
      ...('round' in aims ? [aim('RMSE to the round shape', RMSE.round, 64, aims.round)] : []),
      aim('% of pixels within one code', WITHIN, 64, aims.within),
    ];
  });
  const subjects = Object.keys(PICTURES).map((picture) =>
    pictureSubject(/** @type {keyof typeof PICTURES} */ (picture)),
  );
  /** @param {string} label @param {string} side @param {readonly string[]} passes @returns {Aim} */
  const against = (label, side, passes) => ({
    ...{
      label: `RMSE to three.js’s best pass, worst picture: ${label}`,
      subject: subjects[0] ?? '',
      subjects,
    },
    ...{ measure: RMSE.triangles, side, most: both(1) },
    against: passes.flatMap((pass) => [pass, pass + CODES]),
  });
  return [
    ...ofOne,
    against('first one', PLAIN, [ssaa(1), taa(0)]),
    against('16 samples', full(16), [ssaa(16), taa(16)]),
    against('64 samples to all of theirs', full(64), [...SSAA.map(ssaa), ...TAA.map(taa)]),
  ];
}

/** @type {readonly Aim[]} */
export const AIMS = [
  ...SPHERE_LIGHTS.flatMap((count, i) => [
    {
      label: `${sphere(count)}, first frames`,
      subject: sphere(count),
      measure: 'first frames',
      most: { gpu: FIRST.gpu[i] ?? NaN, software: FIRST.software[i] ?? NaN },
    },
    {
      label: `${sphere(count)}, settled`,
      subject: sphere(count),
      measure: 'settled',
      most: { gpu: SETTLED.gpu[i] ?? NaN, software: SETTLED.software[i] ?? NaN },
    },
  ]),
  ...[...SPHERE_LIGHTS.filter((count) => count >= 8).map(sphere), 'sphere, 1,024 lights'].map(
    (subject) =>
      /** @type {const} */ ({
        label: `${subject}, longest frame over usual`,
        subject,
        measure: 'longest frame',
        figure: 'over usual',
        most: TAKE_OVER_MS,
      }),
  ),
  {
    label: '64 spheres, 8 lights, settled',
    subject: '64 spheres, 8 lights',
    measure: 'settled',
    most: both(0.75),
  },
  {
    label: 'lights that come and go',
    subject: 'lights that come and go',
    measure: 'settled',
    most: both(1.1),
  },
  { label: 'core to element, settled', subject: 'core, 8 lights', measure: 'settled', most: both(1.05) },
  ...FRAMED_LIGHTS.flatMap((count) =>
    FRAMED_SHAPES.map((shape) => ({
      label: `${framedSubject(shape, count)}, to 64 segments, settled`,
      subject: framedSubject(shape, count),
      measure: 'settled',
      most: { gpu: count === 8 ? 1.04 : shape === 'teapot' ? 1.15 : 1.1 },
    })),
  ),
  ...[8, 32].flatMap((count) =>
    ['first frames', 'settled'].map((measure) => ({
      label: `${sphere(count)}, shininess 128, ${measure}`,
      subject: `${sphere(count)}, shininess 128`,
      measure,
      most: { gpu: measure === 'settled' ? 0.95 : 1 },
    })),
  ),
  ...['sphere', 'teapot'].map((shape) => ({
    label: `64 samples of a ${shape}, ms from the change`,
    subject: `still ${shape}`,
    measure: 'change to picture',
    side: 'full, 64 samples',
    figure: /** @type {const} */ ('value'),
    most: { gpu: 75 },
  })),
  ...Object.keys(FIRST_MODELS).map((model) => ({
    label: firstModelSubject(model),
    subject: firstModelSubject(model),
    measure: 'first picture',
    most: both(/PLY|STL|images/.test(model) ? 1.5 : 1.15),
  })),
  {
    label: 'moving one of 10,000 boxes to three.js, script',
    subject: 'script, moving one of 10,000 boxes',
    measure: 'script per frame',
    most: both(2.8),
  },
  { label: 'start, 2,000 boxes', subject: 'start, 2,000 boxes', measure: 'first picture', most: both(1.5) },
  {
    label: 'connecting 5,000 lights, ms',
    subject: 'connecting 5,000 lights',
    measure: 'time',
    figure: 'value',
    most: both(1000),
  },
  {
    label: 'toggling one of 5,000 lights, µs',
    subject: 'script, toggling one of 5,000 lights',
    measure: 'script per frame',
    figure: 'value',
    most: both(2000),
  },
  {
    label: 'moving a mesh beside 1 M triangles, µs',
    subject: 'script, mesh moved beside 1 M triangles',
    measure: 'script per frame',
    figure: 'value',
    most: both(1000),
  },
  {
    label: '20 turning viewers, frame rate to one viewer’s',
    subject: '20 turning viewers',
    measure: 'frame rate',
    most: both(0.7),
    least: true,
  },
  {
    label: 'start, standalone',
    subject: 'start',
    measure: 'first picture',
    side: 'standalone',
    most: both(1.1),
  },
  { label: 'start, bundled', subject: 'start', measure: 'first picture', side: 'bundled', most: both(1.2) },
  { label: 'heap, standalone', subject: 'start', measure: 'heap', side: 'standalone', most: both(1.15) },
  { label: 'heap, bundled', subject: 'start', measure: 'heap', side: 'bundled', most: both(1.35) },
  ...NETWORKS.map((network) => ({
    label: `first picture of a model to the better of two viewers’, ${network}`,
    subject: modelSubjects(network)[0] ?? '',
    subjects: modelSubjects(network),
    measure: 'first picture',
    most: both(0.6),
  })),
  ...pictureAims(),
  { label: 'bytes, standalone', subject: 'bytes', measure: 'brotli', side: 'standalone', most: both(0.8) },
];

/** Labels of what is an aim on a kind of stack, not a limit: it was not reached when it was measured last. */
const UNMET = {
  gpu: new Set([
    `${sphere(32)}, settled`, // 0.84
    `${sphere(128)}, first frames`, // 1.11
    `${sphere(256)}, first frames`, // 1.16
    `${framedSubject('torus', 8)}, to 64 segments, settled`, // 1.08
    `${framedSubject('torus', 32)}, to 64 segments, settled`, // 1.25
    '64 samples of a sphere, ms from the change', // 150 at 1080p
    '64 samples of a teapot, ms from the change', // 133 at 1080p
    'start, 2,000 boxes', // 1.83
    'start, standalone', // 1.20
    'start, bundled', // 1.29
    'heap, standalone', // 1.25
    'heap, bundled', // 1.46
    'first picture of a model to the better of two viewers’, local', // 0.72
    'first picture of a model to the better of two viewers’, 10 Mbit/s', // 0.95
    'bytes, standalone', // 1.19
  ]),
  software: new Set([
    `${sphere(1)}, first frames`, // 1.22
    `${sphere(4)}, first frames`, // 1.20
    firstModelSubject('GLB of 1 MB'), // 1.28
    firstModelSubject('Draco'), // 1.18
    firstModelSubject('.gltf with .bin'), // 1.49
    firstModelSubject('PLY of 0.8 M triangles'), // 2.2
    '20 turning viewers, frame rate to one viewer’s', // 0.37
    'bytes, standalone', // 1.19
  ]),
};

/** @param {import('./results.mjs').BenchResult} result */
export const stackKind = ({ stack }) => (stack.startsWith('software') ? 'software' : 'gpu');

/**
 * What a result says of an aim: median and quartiles, the aim on this stack, whether it is met, and whether it is a limit.
 * Undefined where it was not measured, or where there is no aim for this kind of stack.
 * @param {Aim} aim @param {import('./results.mjs').BenchResult} result
 */
export function judge(aim, result) {
  const kind = stackKind(result);
  const most = aim.most[kind];
  const measured = figureOf(aim, result);
  if (most === undefined || measured === undefined) return undefined;
  const met = aim.least === true ? measured.median >= most : measured.median <= most;
  return { measured, most, met, limit: !UNMET[kind].has(aim.label) };
}

/**
 * A line for each limit that a result misses by more than its noise: even the better quartile lies beyond it.
 * @param {import('./results.mjs').BenchResult} result @returns {string[]}
 */
export const missedLimits = (result) =>
  AIMS.flatMap((aim) => {
    const found = judge(aim, result);
    if (found === undefined || !found.limit) return [];
    const { measured, most } = found;
    const missed = aim.least === true ? measured.high < most : measured.low > most;
    return missed ? [`${aim.label}: ${measured.median.toPrecision(3)}, limit ${most}`] : [];
  });

/**
 * The largest ratio of a side's figure to the least of those that it is held against, over the subjects that were measured.
 * @param {Aim} aim @param {import('./results.mjs').BenchResult} result
 */
function worstRatio({ subjects = [], against = [], measure, side = '' }, result) {
  const ratios = subjects.flatMap((subject) => {
    const ours = pictureValue(result, subject, measure, side);
    const theirs = against.flatMap((other) => pictureValue(result, subject, measure, other) ?? []);
    return ours === undefined || theirs.length === 0 ? [] : [ours / Math.min(...theirs)];
  });
  return ratios.length === 0 ? undefined : spread([Math.max(...ratios)]);
}

/** @param {Aim} aim @param {import('./results.mjs').BenchResult} result */
function figureOf(aim, result) {
  const { subject, subjects, measure, side, figure = 'ratio' } = aim;
  if (aim.against !== undefined) return worstRatio(aim, result);
  if (subjects !== undefined) return ratioOverSubjects(result, subjects, measure);
  const row = rowOf(result, subject, measure);
  if (row === undefined) return undefined;
  if (figure === 'ratio') return ratioOf(row, side);
  if (figure === 'value') return valueOf(row, side);
  const usual = rowOf(result, subject, 'usual frame');
  if (usual === undefined) return undefined;
  const [longest, plain] = [valueOf(row, side), valueOf(usual, side).median];
  return {
    ...longest,
    median: longest.median - plain,
    low: longest.low - plain,
    high: longest.high - plain,
  };
}
