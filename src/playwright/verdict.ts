// Says in words what a judgement has found. Runs in Node.
import type { Judgement } from './judge-in-page.js';
import type { Kind } from './judge-means.js';
import { codesOff } from './subpixel.js';

export interface Verdict {
  readonly pass: boolean;
  /** What was judged. */
  readonly summary: string;
  /** The summary, what is wrong, and the first wrong pixels. */
  readonly message: string;
}

export interface Limits {
  /** Largest difference of a channel. */
  readonly codes: number;
  /** Least share of the surfaces' pixels. */
  readonly share: number;
}

/** Failed pixels that a message lists. */
const LISTED = 5;

interface Wrong {
  readonly x: number;
  readonly y: number;
  readonly kind: Kind;
  readonly drawn: readonly number[];
  readonly expected: readonly number[];
}

/** `seed`: what the pixels were chosen by. */
export function verdictOf(judgement: Judgement, { codes, share }: Limits, seed: number): Verdict {
  const { judged, surface, edges, means, suspects, suspectCount } = judgement;
  const wrong: readonly Wrong[] =
    means?.wrong ??
    suspects
      .filter((suspect) => codesOff(suspect, judgement) > codes)
      .map((suspect) => ({ ...suspect, kind: 'inside' }));
  const failed = wrong.length + suspectCount - suspects.length;
  const judgeable = means === null ? judged : judged + edges;
  const enough = judged + (means?.outlines ?? 0) > 0 && judgeable >= share * surface;
  const summary = summaryOf(judgement, seed);
  const limit = `${count(codes, 'code')}${means === null ? '' : `, or ${count(means.limit, 'code')} in outlines`}`;
  const reason = enough
    ? `${String(failed)}${means?.ended === true ? ' or more' : ''} of them differ by more than ${limit}.`
    : `At least ${percent(share)} are needed: make the viewer larger, move the camera closer, or lower \`share\`.`;
  return {
    pass: enough && failed === 0,
    summary,
    message: [`${summary} ${reason}`, ...wrong.slice(0, LISTED).map(line)].join('\n'),
  };
}

function summaryOf(
  { judged, surface, edges, translucent, minified, means, sampled }: Judgement,
  seed: number,
): string {
  if (surface === 0) return 'The picture shows no surface.';
  const part =
    sampled === 1 ? '' : ` in a sample of ${percent(sampled)} of the picture (seed ${String(seed)})`;
  const left = Object.entries({
    'at edges': means === null ? edges : 0,
    translucent,
    'with minified textures': minified,
  })
    .filter(([, number]) => number > 0)
    .map(([name, number]) => `${String(number)} ${name}`);
  const rest = left.length === 0 ? '' : `; not judged: ${left.join(', ')}`;
  const outlines =
    means === null
      ? ''
      : `, and ${String(means.outlines)} of ${String(means.outlinesFound)} in outlines, by the mean of ${count(means.samples, 'sample')} (at most ${count(means.largest, 'code')} off)`;
  return `${String(judged)} of ${String(surface)} pixels of surfaces${part} were judged (${percent(judged / surface)}${rest})${outlines}.`;
}

/** Where a wrong pixel is; nothing is said of most. */
const PLACES: Readonly<Record<Kind, string>> = {
  inside: '',
  contour: ', in an outline',
  crease: ', at an edge between triangles',
  steep: ', where the colour changes fast',
};

const line = ({ x, y, kind, drawn, expected }: Wrong): string =>
  `  pixel ${String(x)}, ${String(y)}${PLACES[kind]}: ${drawn.join(' ')} is drawn, ${expected.map((code) => code.toFixed(2)).join(' ')} is the equation's`;

const count = (number: number, noun: string): string => `${String(number)} ${noun}${number === 1 ? '' : 's'}`;

const percent = (share: number): string => `${String(Math.round(100 * share))} %`;
