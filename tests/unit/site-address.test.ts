// Does every scene come back from the playground's address, and does every other address give an
// error message?
import { deflateRawSync } from 'node:zlib';
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { fragmentOf, LONGEST_TEXT, readFragment } from '../../demo/playground/address.js';
import { sourceKind } from '../../demo/playground/sources.js';

test('any text comes back unchanged (random texts, seed 17)', async () => {
  await fc.assert(
    fc.asyncProperty(fc.string({ unit: 'grapheme', maxLength: 300 }), async (text) => {
      const fragment = await fragmentOf(text);
      expect(fragment).toMatch(/^#scene=[\w-]*$/);
      expect(await readFragment(fragment)).toEqual({ text });
    }),
    { seed: 17, numRuns: 100 },
  );
});

test('any fragment gives a text, an example or a fault and never throws (random fragments, seed 18)', async () => {
  await fc.assert(
    fc.asyncProperty(fc.string({ maxLength: 60 }), async (letters) => {
      const read = await readFragment(`#scene=${letters}`);
      expect(Object.keys(read ?? {})).toHaveLength(1);
    }),
    { seed: 18, numRuns: 300 },
  );
});

test('the longest text fits, whatever its letters, and an empty fragment is no fault', async () => {
  const text = '😀'.repeat(LONGEST_TEXT / 2);
  expect(await readFragment(await fragmentOf(text))).toEqual({ text });
  expect([await readFragment(''), await readFragment('#')]).toEqual([null, null]);
});

test('a short text that would inflate to a gigabyte is refused', async () => {
  const bomb = deflateRawSync(Buffer.alloc(100_000_000, ' ')).toString('base64url');
  expect(await readFragment(`#scene=${bomb}`)).toEqual({
    fault: expect.stringContaining('too long') as string,
  });
});

test.each([
  ['../assets/a.glb', 'own'],
  ['https://site.example/a.glb', 'own'],
  ['//other.example/a.glb', { host: 'https://other.example' }],
  ['https://site.example@other.example/a.glb', { host: 'https://other.example' }],
  ['http://site.example/a.glb', { host: 'http://site.example' }],
  ['https://site.example:8443/a.glb', { host: 'https://site.example:8443' }],
  [' java\nscript:alert(1)', 'refused'],
  ['blob:https://site.example/1', 'refused'],
  ['data:,x', 'refused'],
  ['file:///etc/passwd', 'refused'],
  ['https://', 'refused'],
])('a source %j is %j', (source, kind) => {
  expect(sourceKind(source, 'https://site.example/playground/')).toEqual(kind);
});
