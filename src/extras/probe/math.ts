// Equations such as "Kd · max(N · L, 0)^8" as MathML, and as LaTeX for the clipboard.
import { html, mathml, type TemplateResult } from 'lit';

const NUMBER = String.raw`[\p{Nd}.,\u066b]*\p{Nd}(?:e[+\u2212]?\p{Nd}+)?%?`;
const TOKENS = new RegExp(String.raw`[KI][ads](?![a-z])|\p{L}+|${NUMBER}|\S`, 'gu');
const IS_NUMBER = /^\p{Nd}/u;

/** In pieces, because a line of MathML does not break: at each operator but those of N · L. */
export const mathOf = (text: string) =>
  html`${text
    .split(/ (?=[·+=≈] (?![LHV]))/)
    .map((piece) => html`<math alttext=${piece}>${rowOf(piece.match(TOKENS) ?? [])}</math> `)}`;

function rowOf(tokens: readonly string[]): TemplateResult {
  const parts: TemplateResult[] = [];
  const open: number[] = [];
  // What a power is of: the last token, or the last parentheses with the function before them.
  let base = 0;
  for (let i = 0; i < tokens.length; i++) {
    const token = tokens[i]!;
    if (token === '^') {
      const power = atomOf(tokens[++i] ?? '');
      parts.push(mathml`<msup><mrow>${parts.splice(base)}</mrow>${power}</msup>`);
      continue;
    }
    if (IS_NUMBER.test(token) && IS_NUMBER.test(tokens[i - 1] ?? '')) {
      parts.push(mathml`<mspace width="0.4em"></mspace>`); // red, green and blue
    }
    base = parts.length;
    if (token === '(') {
      open.push(/^m(ax|in)$/.test(tokens[i - 1] ?? '') ? base - 1 : base);
    }
    if (token === ')') {
      base = open.pop() ?? base;
    }
    // As wide a space on the right as between pieces.
    parts.push(
      /^[·+=≈]$/.test(token)
        ? mathml`<mo form="infix" lspace="${Math.min(parts.length, 0.25)}em" rspace="0.25em">${token}</mo>`
        : atomOf(token),
    );
  }
  return mathml`<mrow>${parts}</mrow>`;
}

function atomOf(token: string): TemplateResult {
  if (/^[KI][ads]$/.test(token)) {
    return mathml`<msub><mi>${token[0]}</mi><mi>${token[1]}</mi></msub>`;
  }
  if (IS_NUMBER.test(token)) return mathml`<mn>${token}</mn>`;
  return /^\p{L}/u.test(token) ? mathml`<mi>${token}</mi>` : mathml`<mo>${token}</mo>`;
}

export const latexOf = (text: string) =>
  text
    .replace(/\b([KI])([ads])\b/g, '$1_$2')
    .replace(/\b(max|min)\b/g, '\\$1')
    .replace(/\b(att|decay|sRGB)\b/g, '\\mathrm{$1}')
    .replace(/(\p{Nd}) (?=\p{Nd})/gu, '$1\\;')
    .replace(/(\p{Nd}),(\p{Nd})/gu, '$1{,}$2')
    .replace(/\^([\p{L}\p{Nd}.{},]+)/gu, '^{$1}')
    .replace(/·/g, '\\cdot')
    .replace(/≈/g, '\\approx')
    .replace(/Σ/g, '\\Sigma')
    .replace(/−/g, '-');
