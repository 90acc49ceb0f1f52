// @ts-check
// "What does accuracy cost?" as a plot, a sentence and rows, of what was measured in one browser:
// the time of a frame against the largest error, for each way to write the light loop. Text in and
// out, for the site's page and for the report. Colours are the page's custom properties.

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

/** @type {readonly { way: WayName, label: string, about: string, color: string }[]} */
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
  'h100-vulkan': 'On an NVIDIA H100 (Vulkan)',
  'h100-opengl': 'On an NVIDIA H100 (OpenGL)',
  software: 'In software (SwiftShader)',
};

/** As a sentence begins. @param {string} name */
export const placeOf = (name) => PLACES[name] ?? `On ${name}`;

/** Below this a picture in 8 bits differs by one code at most, where a value lies between two. */
const INVISIBLE = 0.5;

/** @param {number} x */
const exponentText = (x) => x.toLocaleString('en');

/** Two significant digits, never an exponent. @param {number} x */
export const short = (x) =>
  x === 0 ? '0' : x >= 100 ? x.toFixed(0) : String(Number(x.toPrecision(2)));

/** @param {Accuracy} accuracy @param {WayName} way */
const pointsOf = ({ points }, way) =>
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

const FONT = 12;
/** Of a letter, on average. */
const LETTER = 5.6;
const LINE = 15;
/** On a phone. @param {string} label @param {number} width */
const named = (label, width) => (width < 500 ? label.replace('phong-', '') : label);

const RADII = [3, 4.5, 6];

/**
 * The plot, with the pictures of errors below it. @param {Accuracy} accuracy @param {number} width
 */
export function accuracySvg(accuracy, width) {
  const frame = { left: 46, right: width - 8, top: 26, bottom: width < 500 ? 300 : 330 };
  const { points } = accuracy;
  const x = linear(
    points.map(({ time }) => time),
    frame.left,
    frame.right,
  );
  const y = logarithmic(
    points.map(({ error }) => error),
    frame.bottom,
    frame.top,
  );
  const parts = [
    rect(frame.left, y.at(INVISIBLE), frame.right - frame.left, frame.bottom - y.at(INVISIBLE)),
    text(0, 12, '↓ more exact: largest error, in steps (a colour has 256)'),
    ...y.ticks.map((tick) => gridLine(frame.left, y.at(tick), frame.right, y.at(tick))),
    ...y.ticks.map((tick) => text(frame.left - 6, y.at(tick) + 4, String(tick), 'end')),
    ...x.ticks.map((tick) => gridLine(x.at(tick), frame.top, x.at(tick), frame.bottom)),
    ...x.ticks.map((tick) => text(x.at(tick), frame.bottom + 16, String(tick), 'middle')),
    text(frame.right, frame.bottom + 33, '← faster: time of a frame, the plain loop = 1', 'end'),
    text(0, frame.bottom + 54, 'A dot is a program drawing one highlight: the larger the'),
    text(0, frame.bottom + 69, 'dot, the smaller and sharper the highlight (exponent n).'),
  ];
  const band = 'nobody can see this: less than half a step';
  parts.push(text(frame.right - 4, frame.bottom - 6, band, 'end', 'var(--quiet)'));
  /** @type {Box[]} */
  const taken = [
    box(frame.right - 4 - LETTER * band.length, frame.bottom - 6, LETTER * band.length),
  ];
  /** @param {number} cx @param {number} cy @param {number} r */
  const cover = (cx, cy, r) =>
    taken.push({ left: cx - r, right: cx + r, top: cy - r, bottom: cy + r, line: r === 1 });
  for (const { way, color } of WAYS) {
    const dots = pointsOf(accuracy, way).map(({ time, error }) => [x.at(time), y.at(error)]);
    dots.forEach(([cx = 0, cy = 0], i) => {
      cover(cx, cy, 6);
      const [toX = cx, toY = cy] = dots[i + 1] ?? [];
      for (let k = 1; k < 12; k++) {
        cover(cx + ((toX - cx) * k) / 12, cy + ((toY - cy) * k) / 12, 1);
      }
    });
    parts.push(
      `<polyline fill="none" stroke="${color}" stroke-width="1.5" points="${dots.map((dot) => dot.map(fixed).join()).join(' ')}"/>`,
      ...dots.map(([cx = 0, cy = 0], i) => {
        const fill = way === 'first' ? 'var(--paper)' : color;
        return `<circle cx="${fixed(cx)}" cy="${fixed(cy)}" r="${String(RADII[i])}" fill="${fill}" stroke="${color}" stroke-width="1.5"/>`;
      }),
    );
  }
  for (const { way, label, color } of WAYS) {
    const last = pointsOf(accuracy, way).at(-1);
    if (last !== undefined) {
      parts.push(
        placed(named(label, width), x.at(last.time), y.at(last.error), color, frame, taken),
      );
    }
  }
  for (const { time, error, exponent } of pointsOf(accuracy, PLAIN_WAY)) {
    const label = `n = ${exponentText(exponent)}`;
    parts.push(placed(label, x.at(time), y.at(error), 'var(--quiet)', frame, taken));
  }
  const below = picturesPart(accuracy, width, frame.bottom + 94);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${String(width)} ${String(below.height)}" width="${String(width)}" height="${String(below.height)}" role="img" aria-label="${escapedXml(accuracySentence(accuracy))}" font-family="Helvetica, Arial, sans-serif" font-size="${String(FONT)}" fill="var(--ink)">${[...parts, ...below.parts].join('')}</svg>`;
}

/**
 * A file of its own: what a page says of colours stands in it. @param {Accuracy} accuracy @param
 * {number} width
 */
export const accuracyFile = (accuracy, width) =>
  accuracySvg(accuracy, width).replace(
    '>',
    `><style>svg{background:var(--paper);--paper:#fff;--ink:#15171a;--quiet:#565c64;--hairline:#d4d7db;--band:#eceef0;--series-1:#0072b2;--series-2:#d55e00;--series-3:#009e73;--series-4:#cc79a7}
@media (prefers-color-scheme:dark){svg{--paper:#131417;--ink:#e3e4e6;--quiet:#a0a5ad;--hairline:#34373c;--band:#25282d;--series-1:#56b4e9;--series-2:#e8803a;--series-3:#2fbf95}}</style>`,
  );

/** @param {Accuracy} accuracy @param {number} width @param {number} top */
function picturesPart(accuracy, width, top) {
  const { pictures } = accuracy;
  if (pictures.length === 0) return { parts: [], height: top - 16 };
  const gap = 12;
  const side = Math.min(170, (width - gap * (pictures.length - 1)) / pictures.length);
  const parts = pictures.flatMap(({ way, png }, i) => {
    const left = i * (side + gap);
    const label = WAYS.find((one) => one.way === way)?.label ?? way;
    const error = pointsOf(accuracy, way).find(({ exponent }) => exponent === PICTURED.exponent);
    return [
      `<image x="${fixed(left)}" y="${fixed(top + 10)}" width="${fixed(side)}" height="${fixed(side)}" href="${png}"/>`,
      `<rect x="${fixed(left)}" y="${fixed(top + 10)}" width="${fixed(side)}" height="${fixed(side)}" fill="none" stroke="var(--hairline)"/>`,
      text(left, top + side + 26, named(label, width)),
      text(left, top + side + 41, `${short(error?.error ?? 0)} steps`, 'start', 'var(--quiet)'),
    ];
  });
  const title = `The error × ${String(MAGNIFIED)} where n = ${exponentText(PICTURED.exponent)}: black is exact`;
  return { parts: [text(0, top, title), ...parts], height: Math.ceil(top + side + 48) };
}

/**
 * @typedef {{ left: number, right: number, top: number, bottom: number, line?: boolean }} Box
 * @param {number} left @param {number} baseline @param {number} width @returns {Box}
 */
const box = (left, baseline, width) => ({
  left,
  right: left + width,
  top: baseline - 11,
  bottom: baseline + 3,
});

/**
 * A label beside a dot, where it covers nothing if there is such a place, and a line between them. @param {string} label @param {number} x @param {number} y @param {string}
 * color @param {Box} frame @param {Box[]} taken gets its place
 */
function placed(label, x, y, color, frame, taken) {
  const width = LETTER * label.length;
  const inside = [0, -1, 1, -2, 2, -3, 3, -4, 4, -5, 5]
    .flatMap((line) =>
      [x + 10, x - 10 - width].map((left) => box(left, y + 4 + line * LINE, width)),
    )
    .filter(
      ({ left, right, top, bottom }) =>
        left >= frame.left && right <= frame.right && top >= frame.top && bottom <= frame.bottom,
    );
  /** @param {readonly Box[]} boxes */
  const away = (boxes) =>
    inside.find((one) =>
      boxes.every(
        (other) =>
          one.right <= other.left ||
          one.left >= other.right ||
          one.bottom <= other.top ||
          one.top >= other.bottom,
      ),
    );
  // Rather on a line than on a dot or on another label.
  const place =
    away(taken) ?? away(taken.filter(({ line }) => line !== true)) ?? box(frame.left, y, width);
  taken.push(place);
  const isLeft = place.left < x;
  const [end, dot] = isLeft ? [place.right, x - 6] : [place.left, x + 6];
  const line = `M${fixed(end)} ${fixed(place.bottom - 7)}L${fixed(dot)} ${fixed(y)}`;
  return `<path stroke="${color}" stroke-width="0.75" d="${line}"/>${text(end, place.bottom - 3, label, isLeft ? 'end' : 'start', color)}`;
}

/**
 * @param {number} x @param {number} y @param {string} words @param {'start' | 'middle' | 'end'}
 * [anchor] @param {string} [fill]
 */
const text = (x, y, words, anchor = 'start', fill = 'var(--ink)') =>
  `<text x="${fixed(x)}" y="${fixed(y)}" text-anchor="${anchor}" fill="${fill}">${escapedXml(words)}</text>`;

/** @param {number} x @param {number} y @param {number} width @param {number} height */
const rect = (x, y, width, height) =>
  `<rect x="${fixed(x)}" y="${fixed(y)}" width="${fixed(width)}" height="${fixed(Math.max(0, height))}" fill="var(--band)"/>`;

/** @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
const gridLine = (x1, y1, x2, y2) =>
  `<line x1="${fixed(x1)}" y1="${fixed(y1)}" x2="${fixed(x2)}" y2="${fixed(y2)}" stroke="var(--hairline)"/>`;

/** @param {number} x */
const fixed = (x) => String(Number(x.toFixed(1)));

/** @param {string} words */
const escapedXml = (words) =>
  words.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/** @param {readonly number[]} values @param {number} from @param {number} to pixels */
function linear(values, from, to) {
  const [least, most] = [Math.min(1, ...values), Math.max(1, ...values)];
  // Round numbers, four to eight of them.
  const step =
    [0.1, 0.2, 0.25, 0.5, 1, 2, 5, 10, 50].find((one) => (most - least) / one <= 5) ?? 100;
  const first = Math.max(0, Math.floor((least - 0.2 * step) / step) * step);
  const last = most + 0.6 * step;
  const ticks = [];
  for (let tick = first; tick <= last; tick += step) {
    ticks.push(Number(tick.toFixed(2)));
  }
  const at = (/** @type {number} */ value) =>
    from + ((value - first) / (last - first)) * (to - from);
  return { ticks, at };
}

/** Least error that is shown as it is. */
const LEAST = 1e-4;

/** @param {readonly number[]} values @param {number} from @param {number} to pixels */
function logarithmic(values, from, to) {
  const shown = values.map((value) => Math.log10(Math.max(value, LEAST)));
  const first = Math.floor(Math.min(-1, ...shown) - 0.1);
  const last = Math.ceil(Math.max(1, ...shown) + 0.1);
  const ticks = Array.from({ length: last - first + 1 }, (_, i) =>
    Number((10 ** (first + i)).toPrecision(1)),
  );
  const at = (/** @type {number} */ value) =>
    from + ((Math.log10(Math.max(value, LEAST)) - first) / (last - first)) * (to - from);
  return { ticks, at };
}
