// Small files after public bug reports of viewers and loaders: does each show what its format says?
// A check is a point of the plane z = 0, seen from +z at a distance of 4. The first file of each
// kind, all of them in a release run.

import { readFileSync } from 'node:fs';
import { expect, test } from '../../support/test.js';
import { firstOf } from '../../support/repeats.js';
import type { PhongViewer } from '../../element/support/viewer.js';

/** Files of which each has a kind of its own; they come first. */
const FIRST = 100;

interface Check {
  readonly x: number;
  readonly y: number;
  /** Whether anything is there. */
  readonly hit: boolean;
  /** The colour of `view`, by default of the ambient term, under white ambient light. */
  readonly rgb?: readonly number[];
  readonly view?: PhongViewer['view'];
  readonly tol: number;
  /** The N of `shadeAt`. */
  readonly n?: readonly number[];
}

interface Case {
  readonly id: string;
  readonly file: string;
  readonly kind: string;
  readonly why: string;
  readonly event: 'load' | 'error';
  readonly attributes?: { readonly ka?: string; readonly nolight?: string };
  readonly checks: readonly Check[];
  /** What a warning says. */
  readonly says?: string;
}

const cases = JSON.parse(
  readFileSync(new URL('../../fixtures/cases/cases.json', import.meta.url), 'utf8'),
) as readonly Case[];

/** What differs from the case's checks, in words. Runs in the page. */
async function differences({ file, event, attributes = {}, checks }: Case) {
  const size = 200;
  const found: string[] = [];
  const viewer = document.createElement('phong-viewer');
  Object.assign(viewer, { alt: 'A case', loading: 'eager', theta: 0, phi: 90 });
  viewer.style.width = viewer.style.height = `${String(size)}px`;
  if (attributes.nolight === undefined) {
    if (attributes.ka !== undefined) {
      viewer.setAttribute('ka', attributes.ka);
    }
    const light = document.createElement('phong-light');
    Object.assign(light, {
      space: 'camera',
      position: [0, 0, 1, 0],
      ambient: 255,
      diffuse: 0,
      specular: 0,
    });
    viewer.append(light);
  }
  const outcome = new Promise<CustomEvent<{ readonly message?: string }>>((resolve) => {
    for (const type of ['load', 'error'] as const) {
      viewer.addEventListener(type, resolve as () => void);
    }
  });
  viewer.src = `/fixtures/cases/${file.split('/').map(encodeURIComponent).join('/')}`;
  document.body.replaceChildren(viewer);
  const { type, detail } = await outcome;
  if (type !== event) {
    found.push(`${type}: ${detail.message ?? ''}`);
  }
  if (type !== 'load') return found;
  await viewer.ready;
  viewer.target = [0, 0, 0];
  viewer.radius = 4;
  const halfWidth = 4 * Math.tan(Math.PI / 8);
  for (const { x, y, hit, rgb, view, tol, n } of checks) {
    const [left, top] = [(size / 2) * (1 + x / halfWidth), (size / 2) * (1 - y / halfWidth)];
    viewer.view = view ?? 'ambient';
    const bitmap = await createImageBitmap(await viewer.toBlob({ width: size, height: size }), {
      premultiplyAlpha: 'none',
    });
    const context = new OffscreenCanvas(size, size).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const [...pixel] = context.getImageData(Math.floor(left), Math.floor(top), 1, 1).data;
    const at = `(${String(x)}, ${String(y)})`;
    if (pixel[3]! > 0 !== hit) {
      found.push(`${at}: ${pixel.join(' ')}, expected ${hit ? 'a hit' : 'nothing'}`);
    } else if (hit && rgb?.some((code, i) => Math.abs(code - pixel[i]!) > tol) === true) {
      found.push(`${at}: colour ${pixel.join(' ')}, expected ${rgb.join(' ')}`);
    }
    const N = hit && n !== undefined ? (await viewer.shadeAt(left, top))?.N : n;
    if (n?.some((component, i) => !(Math.abs(component - (N?.[i] ?? NaN)) <= 0.02)) === true) {
      found.push(`${at}: N ${String(N)}, expected ${n.join()}`);
    }
  }
  return found;
}

for (const format of ['gltf', 'obj', 'ply', 'stl']) {
  test(`${format}: each file shows what its format says`, async ({ page, mount, consoleGuard }) => {
    test.setTimeout(120_000);
    // Each file that is left out is named; a missing one is the browser's error too.
    const said = consoleGuard.allow(/^warning: |Failed to load resource/);
    await mount('');
    for (const one of firstOf(cases, FIRST).filter(({ file }) => file.startsWith(`${format}/`))) {
      expect.soft(await page.evaluate(differences, one), `${one.id} (${one.why})`).toEqual([]);
      expect.soft(said.join('\n')).toContain(one.says ?? '');
    }
  });
}
