// Is every equation that a reader sees the one that is computed? Formulas of the site and of the
// README are evaluated, light from behind included, and compared with the reference.

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { runInNewContext } from 'node:vm';
import { describe, expect, it } from 'vitest';
import { dot } from '../../src/phong/math/vector.js';
import { shade } from '../../src/phong/reference/equation.js';
import { lightWith } from '../stress/case.js';
import { Random } from '../stress/random.js';

const files = execFileSync('git', ['ls-files', '*.md', 'demo/*.html', 'demo/*.ts'], {
  encoding: 'utf8',
})
  .split('\n')
  .filter((path) => path !== 'CHANGELOG.md' && existsSync(path));
const documents = files.map((path) => ({ path, text: readFileSync(path, 'utf8') }));

interface Node {
  readonly tag: string;
  readonly parts: (Node | string)[];
}

/** MathML as one line: fractions and powers as / and ^. */
function line(math: string): string {
  const root: Node = { tag: '', parts: [] };
  const open = [root];
  for (const [, end, tag, text] of math.matchAll(/<(\/?)(\w+)[^>]*>|([^<]+)/g)) {
    if (end === '/') {
      open.pop();
    } else if (tag !== undefined) {
      const node: Node = { tag, parts: [] };
      open.at(-1)!.parts.push(node);
      open.push(node);
    } else if (text!.trim() !== '') {
      open.at(-1)!.parts.push(text!.trim().replace('&InvisibleTimes;', '·'));
    }
  }
  const say = (node: Node | string): string => {
    if (typeof node === 'string') return node;
    const parts = node.parts.map(say);
    if (node.tag === 'msub') return parts.join('');
    if (node.tag === 'msup') return parts.join('^');
    if (node.tag === 'mfrac') return `((${parts.join(')/(')}))`;
    return node.tag === 'munder' || node.tag === 'mtext' ? '' : parts.join(' ');
  };
  return say(root);
}

/** The text of a page; powers as ^. */
const plain = (html: string) =>
  html
    .replaceAll(/<math[^]*?<\/math\s*>/g, '')
    .replaceAll('<sup>', '^')
    .replaceAll(/<[^>]+>/g, '')
    .replaceAll(/\s+/g, ' ');

const COEFFICIENTS = /K[ads]|\bk[clq]\b|\bcutoff\b/;

/** Whether its equations are HTML. */
const isPage = (path: string) => path.endsWith('.html') || path.startsWith('demo/guide/');

/** What a document has of the equation, each as one line without its left side. */
function formulasOf(path: string, text: string): readonly string[] {
  const found = isPage(path)
    ? [
        ...Array.from(text.matchAll(/<math[^]*?<\/math\s*>/g), ([math]) => line(math)),
        ...Array.from(
          text.matchAll(/<span class="(?:ambient|diffuse|specular)">([^]*?)<\/span>/g),
          ([, span = '']) => plain(span),
        ),
      ]
    : Array.from(
        text.matchAll(/^(?:spec|att|decay|colour) [ +]*= (.*?)(?: {3}.*)?$/gm),
        ([, right = '']) => right,
      );
  return found
    .map((formula) => formula.replace(/^.*?\+?=/, '').trim())
    .filter((formula) => COEFFICIENTS.test(formula) || /\^ ?shininess/.test(formula));
}

/** The value of a formula, in which factors may stand side by side. */
function valueOf(formula: string, values: Readonly<Record<string, number>>) {
  const code = formula
    .replaceAll(/([NR]) ?· ?([LVH])/g, '$1o$2')
    .replaceAll('²', '^2')
    .replaceAll('·', '*')
    .replaceAll('−', '-')
    .replaceAll(/([\w)]) +(?=[\w(])/g, '$1*')
    .replaceAll('max*(', 'max(')
    .replaceAll('max', 'Math.max')
    .replaceAll(/\b(att|decay|[a-zA-Z]{1,2})\(/g, '$1*(')
    .replaceAll('^', '**');
  return Number(runInNewContext(code, { ...values, Math }));
}

const grey = (x: number) => [x, x, x] as const;

/**
 * A fragment under a light from anywhere: what formulas name, and what the reference makes of it.
 */
function sample(random: Random) {
  const full = () => random.from(1, 255);
  const [ka, kd, ks, ambient, diffuse, specular] = [1, 2, 3, 4, 5, 6].map(full) as number[];
  const attenuation = random.vector(0, 1);
  const cutoff = random.from(1, 8);
  const shininess = random.pick([1, 2, 3, 8]);
  const light = lightWith({
    position: [...random.vector(-2, 2), 1],
    axis: random.unit(),
    cutoff,
    attenuation,
    ambient: grey(ambient!),
    diffuse: grey(diffuse!),
    specular: grey(specular!),
  });
  const { N, shares } = shade(
    { p: [0, 0, 0], normal: random.unit(), eye: random.unit() },
    { ka: grey(ka!), kd: grey(kd!), ks: grey(ks!), shininess },
    [light],
  );
  const [share] = shares;
  const { NoL, RoV, att, decay, c, d } = share!;
  expect(dot(N, share!.L)).toBe(NoL);
  const [kc, kl, kq] = attenuation;
  const coefficients = { Ka: ka! / 255, Kd: kd! / 255, Ks: ks! / 255 };
  const intensities = { Ia: ambient! / 255, Id: diffuse! / 255, Is: specular! / 255 };
  const spec = NoL > 0 ? Math.max(RoV, 0) ** shininess : 0;
  const values = { ...coefficients, ...intensities, n: shininess, shininess, spec, NoL, RoV, att, decay, c, cutoff, kc, kl, kq, d }; // oxfmt-ignore
  return { share: share!, values };
}

/** What the reference has for a formula with these names. */
function expected(formula: string, { share, values }: ReturnType<typeof sample>) {
  if (/\bk ?c\b/.test(formula)) return share.att;
  if (formula.includes('cutoff')) return share.decay;
  if (/\^ ?shininess/.test(formula)) return values.spec;
  const terms = { Ka: share.ambient, Kd: share.diffuse, Ks: share.specular };
  let sum = 0;
  for (const [name, [term]] of Object.entries(terms)) {
    if (!formula.includes(name)) continue;
    const factor = name === 'Ka' || formula.includes('att') ? 1 : share.att;
    sum += term / factor / (formula.includes('decay') ? 1 : share.decay);
  }
  return sum;
}

const pages = documents
  .filter(({ path }) => isPage(path) || path === 'README.md')
  .flatMap(({ path, text }) => formulasOf(path, text).map((formula) => ({ path, text, formula })));

describe('equations that readers see', () => {
  it('are found on the home page, in the lesson, the guide and the README', () => {
    const counts = new Map<string, number>();
    for (const { path } of pages) {
      counts.set(path, (counts.get(path) ?? 0) + 1);
    }
    expect(Object.fromEntries(counts)).toMatchObject({
      'README.md': 4,
      'demo/index.html': 1,
      'demo/guide/light.md': 3,
      'demo/lesson/index.html': 5,
    });
  });

  it('are worked out right in the example by hand', () => {
    const page = readFileSync('demo/guide/light.md', 'utf8').split('## One point by hand')[1]!;
    const written = Array.from(
      page.matchAll(/^(?:ambient|diffuse|specular|sum) \|.*\| ([\d.]+)$/gm),
      ([, number]) => number,
    );
    const light = lightWith({
      position: [1, 1, 0, 0],
      ambient: grey(20),
      diffuse: grey(180),
      specular: grey(90),
    });
    const { color, shares } = shade(
      { p: [0, 0, 0], normal: [0, 1, 0], eye: [-1, 2, 0] },
      { ka: grey(200), kd: grey(200), ks: grey(128), shininess: 32 },
      [light],
    );
    const { ambient, diffuse, specular, NoL, RoV } = shares[0]!;
    const terms = [ambient[0], diffuse[0], specular[0], color[0]];
    expect(written).toEqual(terms.map((term) => (255 * term).toFixed(1)));
    expect(page).toContain(`N·L = ${NoL.toFixed(3)} and R·V = ${RoV.toFixed(3)}`);
  });

  it.each(pages)('$path: $formula', ({ text, formula }) => {
    const random = new Random(18);
    for (let i = 0; i < 200; i++) {
      const one = sample(random);
      const gated = /Ks|shininess/.test(formula) && !formula.includes('spec');
      // Beside the equation the page says in words where the highlight ends.
      if (gated && one.values.NoL <= 0) continue;
      const exact = expected(formula, one);
      expect(Math.abs(valueOf(formula, one.values) - exact)).toBeLessThan(1e-9 * (1 + exact));
    }
    if (/Ks/.test(formula)) {
      expect(plain(text)).toMatch(/N·L ?(?:> 0|≤ 0)/);
    }
  });

  it.each(documents)(
    '$path has no cosine to a power, or in a product, that can be negative',
    ({ text }) => {
      // oxfmt-ignore
      const words = plain(text);
      // The law of the mirror takes the cosine as it is: R = 2 (N·L) N − L.
      expect(words.match(/.{20}(?<!2 ?)\((?:N·L|R·V|N·H)\).{9}/g) ?? []).toEqual([]);
      expect(words.match(/.{20}(?:N·L|R·V|N·H)(?:\^|ⁿ).{9}/g) ?? []).toEqual([]);
      expect(words.match(/1 ?\/ ?\(kc.{9}/g) ?? []).toEqual([]);
    },
  );
});
