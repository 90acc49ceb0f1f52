// @vitest-environment happy-dom
// Which of a page's texts does a viewer use: its own, those of `PhongViewer.texts`, or those of the
// page's scripts? element/texts/page-texts.spec.ts has what is shown.

import { afterEach, expect, it, vi } from 'vitest';
import { PhongViewer } from '../../../src/viewer/index.js';
import { onPage } from './on-page.js';

const script = (texts: string) =>
  `<script type="application/json" data-phong-viewer-texts>${texts}</script>`;
const viewer = '<phong-viewer alt="" geometry="box"></phong-viewer>';

afterEach(() => {
  PhongViewer.texts = null;
  document.body.innerHTML = '';
});

it('PhongViewer.texts goes before the script, and a viewer’s own texts before both', async () => {
  const first = await onPage(
    `${script('{"Close": "S", "Loading": "S", "Try again": "S"}')}${viewer}${viewer}`,
  );
  const second = document.querySelectorAll('phong-viewer')[1]!;
  await vi.waitFor(() =>
    expect(second.texts).toEqual({ Close: 'S', Loading: 'S', 'Try again': 'S' }),
  );
  first.texts = { Loading: 'V' };
  PhongViewer.texts = { Loading: 'P', Close: 'P' };
  expect(first.texts).toEqual({ Loading: 'V', Close: 'P', 'Try again': 'S' });
  expect(second.texts).toEqual({ Loading: 'P', Close: 'P', 'Try again': 'S' });
  // Read again, it is the same object until something changes.
  expect(first.texts).toBe(first.texts);
  expect(() => {
    PhongViewer.texts = ['no'] as unknown as Record<string, string>;
  }).toThrow('expected an object of texts');
  expect(second.texts).toMatchObject({ Loading: 'P' });
  PhongViewer.texts = null;
  expect(second.texts).toEqual({ Close: 'S', Loading: 'S', 'Try again': 'S' });
});

it('invalid `texts` throw, and the present ones stay', async () => {
  const first = await onPage(viewer);
  first.texts = { Close: 'V' };
  for (const texts of ['V', 1, ['a'], { Loading: 1 }, { Loading: null }]) {
    expect(() => Object.assign(first, { texts }), JSON.stringify(texts)).toThrow(
      '<phong-viewer>.texts: expected an object of texts',
    );
    expect(first.texts).toMatchObject({ Close: 'V' });
  }
});

it('each mistake in the scripts gives one warning; other texts are used', async () => {
  const warn = vi.spyOn(console, 'warn').mockReturnValue();
  const scripts = ['{"Close": "A",}', '["Close"]', '{"Closed": "B", "Loading": "C"}'];
  const first = await onPage(scripts.map(script).join('') + viewer + viewer);
  first.before(first.cloneNode());
  for (const each of document.querySelectorAll('phong-viewer')) {
    await vi.waitFor(() => expect(each.texts).toMatchObject({ Loading: 'C' }));
    expect(each.texts).not.toHaveProperty('Close');
  }
  // What was said is not said again when another script comes.
  document.body.insertAdjacentHTML('beforeend', script('{"Close": "D"}') + viewer);
  await vi.waitFor(() => expect(first.texts).toMatchObject({ Close: 'D' }));
  const about = '<script data-phong-viewer-texts> ';
  expect(warn.mock.calls.map(([text]) => String(text).replace(about, ''))).toEqual([
    expect.stringMatching(/^is not JSON, so it is not used: .*JSON/),
    'must be an object of texts by English text, so it is not used. Write {"Try again": "…"}.',
    'has texts that no viewer shows: "Closed" (did you mean "Close"?). phong-viewer/texts/de has all keys.',
  ]);
  warn.mockRestore();
});
