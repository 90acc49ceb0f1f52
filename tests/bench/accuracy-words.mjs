// @ts-check
// "What does accuracy cost?" as a sentence and rows, of what was measured in one browser: the time of
// a frame and the largest error, for each way to write the light loop. For the site's page and for
// the report. Needs no package. Colours are the page's custom properties.

/** @typedef {'plain' | 'first' | 'settled' | 'schlick' | 'squaring' | 'mediump'} WayName */
/**
 * @typedef {{ readonly way: WayName, readonly exponent: number, readonly ms: number, readonly time:
 * number, readonly error: number }} AccuracyPoint `ms`: of a frame; `time`: the plain loop = 1;
 * `error`: the largest of a picture, in 1/255
 */
/** @typedef {{ readonly way: WayName, readonly png: string }} ErrorPicture a data address */
/**
 * @typedef {object} Accuracy
 * @property {string} renderer
 * @property {string} browser
 * @property {string} date
 * @property {readonly number[]} size of the picture that is timed
 * @property {readonly AccuracyPoint[]} points
 * @property {readonly ErrorPicture[]} pictures
 */

/** @type {WayName} */
export const PLAIN_WAY = 'plain';

/** @type {readonly { way: WayName, label: string, about: string, color: string, fill?: string }[]} */
export const WAYS = [
  {
    way: PLAIN_WAY,
    label: 'plain loop',
    about: 'as textbooks write it, with pow(), for just these lights',
    color: 'var(--ink)',
  },
  {
    way: 'first',
    label: 'phong-viewer, at first',
    about: 'its first frames: a loop for any number of lights',
    color: 'var(--series-1)',
    fill: 'var(--paper)',
  },
  {
    way: 'settled',
    label: 'phong-viewer, settled',
    about: 'after 20 frames: a loop for just these lights',
    color: 'var(--series-1)',
  },
  {
    way: 'schlick',
    label: 'Schlick’s formula',
    about: 't / (n − n t + t) in place of the power',
    color: 'var(--series-2)',
  },
  {
    way: 'squaring',
    label: 'squaring',
    about: 'the power by multiplications, for whole exponents',
    color: 'var(--series-3)',
  },
  {
    way: 'mediump',
    label: 'mediump',
    about: 'the plain loop in 16 bits, where the GPU has them',
    color: 'var(--series-4)',
  },
];

/** Of the highlight. */
export const EXPONENTS = [32, 1000, 100_000];

/** Whose errors are shown as pictures, and how many times larger than they are. */
export const PICTURED = /** @type {const} */ ({
  exponent: 100_000,
  ways: ['plain', 'settled', 'schlick'],
});
export const MAGNIFIED = 50;

/** Where files of results were measured, by their names. @type {Readonly<Record<string, string>>} */
const PLACES = {
  'h200-vulkan': 'On an NVIDIA H200 (Vulkan)',
  'h200-opengl': 'On an NVIDIA H200 (OpenGL)',
  software: 'In software (SwiftShader)',
};

/** As a sentence begins. @param {string} name */
export const placeOf = (name) => PLACES[name] ?? `On ${name}`;

/** Below this a picture in 8 bits differs by one code at most, where a value lies between two. */
export const INVISIBLE = 0.5;

/** @param {number} x */
export const exponentText = (x) => x.toLocaleString('en');

/** Two significant digits, never an exponent. @param {number} x */
export const short = (x) =>
  x === 0 ? '0' : x >= 100 ? x.toFixed(0) : String(Number(x.toPrecision(2)));

/** @param {Accuracy} accuracy @param {WayName} way */
export const pointsOf = ({ points }, way) =>
  points.filter((point) => point.way === way).sort((one, other) => one.exponent - other.exponent);

/** @param {Accuracy} accuracy @param {WayName} way */
const worst = (accuracy, way) => Math.max(...pointsOf(accuracy, way).map(({ error }) => error));

/**
 * What was measured, in one sentence. @param {Accuracy} accuracy @param {string} [where]
 */
export function accuracySentence(accuracy, where = 'On this machine') {
  const ours = [...pointsOf(accuracy, 'first'), ...pointsOf(accuracy, 'settled')];
  const times = ours.map(({ time }) => time);
  const [least, most] = [Math.min(...times), Math.max(...times)].map((time) => time.toFixed(2));
  const error = Math.max(...ours.map((point) => point.error));
  return `${where} exactness costs ${least} to ${most} times the plain loop’s time: phong-viewer is wrong by at most ${short(error)} of a colour’s 256 steps, the plain loop by ${short(worst(accuracy, 'plain'))}, a usual approximation (Schlick’s) by ${short(worst(accuracy, 'schlick'))}.`;
}

/** Cells of a table: a way, then time and error for each exponent. @param {Accuracy} accuracy */
export const accuracyRows = (accuracy) =>
  WAYS.map(({ way, label, about }) => ({
    label,
    about,
    cells: pointsOf(accuracy, way).flatMap(({ time, error }) => [time.toFixed(2), short(error)]),
  }));

/** What stands above the cells. */
export const ACCURACY_HEAD = EXPONENTS.flatMap((exponent) => [
  `exponent ${exponentText(exponent)}: time`,
  'error',
]);
