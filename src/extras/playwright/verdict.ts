// Says in words what a judgement has found. Runs in Node.
import type { Judgement, WrongPixel } from './judge-in-page.js';

export interface Limits {
  /** Largest difference of a channel. */
  readonly codes: number;
  /** Least share of the surfaces' pixels. */
  readonly share: number;
}

/**
 * `summary`: what was judged. `message`: also what is wrong, and the first wrong pixels. `seed`
 * chose the pixels.
 */
export function verdictOf(
  judgement: Judgement,
  { codes, share }: Limits,
  seed: number,
): { readonly pass: boolean; readonly summary: string; readonly message: string } {
  const { counts, surface, wrong, wrongCount } = judgement;
  const enough = counts.judged > 0 && counts.judged >= share * surface;
  const summary = summaryOf(judgement, seed);
  const reason = enough
    ? `${String(wrongCount)} of them differ by more than ${String(codes)} code${codes === 1 ? '' : 's'}.`
    : `At least ${percent(share)} are needed: make the viewer larger, move the camera closer, or lower \`share\`.`;
  return {
    pass: enough && wrongCount === 0,
    summary,
    message: [`${summary} ${reason}`, ...(enough ? wrong.map(line) : [])].join('\n'),
  };
}

function summaryOf({ counts, surface, sampled }: Judgement, seed: number): string {
  if (surface === 0) return 'The picture shows no surface.';
  const { judged, edges, steep, translucent, filtered } = counts;
  const part =
    sampled === 1
      ? ''
      : ` in a sample of ${percent(sampled)} of the picture (seed ${String(seed)})`;
  const left = Object.entries({
    'at edges': edges,
    'where the colour changes fast': steep,
    translucent,
    'with textures drawn smaller than they are': filtered,
  })
    .filter(([, number]) => number > 0)
    .map(([name, number]) => `${String(number)} ${name}`);
  const rest = left.length === 0 ? '' : `; not judged: ${left.join(', ')}`;
  return `${String(judged)} of ${String(surface)} pixels of surfaces${part} were judged (${percent(judged / surface)}${rest}).`;
}

function line({ x, y, drawn, least, greatest }: WrongPixel): string {
  const range = least.map((low, k) => `${low.toFixed(1)}–${greatest[k]!.toFixed(1)}`).join(' ');
  return `  pixel ${String(x)}, ${String(y)}: ${drawn.join(' ')} is drawn, ${range} is the equation's`;
}

const percent = (share: number): string => `${String(Math.round(100 * share))} %`;
