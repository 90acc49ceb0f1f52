// The notation of equations ("Kd · max(N · L, 0)^8") as MathML and as LaTeX.
import { html, mathml, type TemplateResult } from 'lit';

const TOKENS = /[KI][ads](?![a-z])|[\p{L}]+|[\d.,\u066b]*\d(?:e[+−]?\d+)?%?|\S/gu;

export function mathOf(text: string): TemplateResult {
  return html`<math alttext=${text}>${rowOf(text.match(TOKENS) ?? [])}</math>`;
}

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
    base = parts.length;
    if (token === '(') open.push(/^m(ax|in)$/.test(tokens[i - 1] ?? '') ? base - 1 : base);
    if (token === ')') base = open.pop() ?? base;
    parts.push(atomOf(token));
  }
  return mathml`<mrow>${parts}</mrow>`;
}

function atomOf(token: string): TemplateResult {
  if (/^[KI][ads]$/.test(token)) return mathml`<msub><mi>${token[0]}</mi><mi>${token[1]}</mi></msub>`;
  if (/^\d/.test(token)) return mathml`<mn>${token}</mn>`;
  return /^\p{L}/u.test(token) ? mathml`<mi>${token}</mi>` : mathml`<mo>${token}</mo>`;
}

export const latexOf = (text: string): string =>
  text
    .replace(/\b([KI])([ads])\b/g, '$1_$2')
    .replace(/\b(max|min)\b/g, '\\$1')
    .replace(/\b(att|decay|sRGB)\b/g, '\\mathrm{$1}')
    .replace(/(\d),(\d)/g, '$1{,}$2')
    .replace(/\^([\w.{},]+)/g, '^{$1}')
    .replace(/·/g, '\\cdot')
    .replace(/Σ/g, '\\Sigma')
    .replace(/−/g, '-');
