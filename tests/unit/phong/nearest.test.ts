// Which part of a text from outside does a message repeat, and which known word does a misspelled
// one mean?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { clip, clipMessage, listed } from '../../../src/phong/fields/clip.js';
import { nearest } from '../../../src/phong/fields/nearest.js';

it('a text is clipped after 100 characters, never in the middle of a surrogate pair', () => {
  for (const text of ['', 'red', 'x'.repeat(100), '😀'.repeat(50)]) {
    expect(clip(text)).toBe(text);
  }
  expect(clip('x'.repeat(101))).toBe(`${'x'.repeat(100)}...`);
  expect(clip('x'.repeat(1e6))).toHaveLength(103);
  expect(clip(`${'x'.repeat(99)}😀`)).toBe(`${'x'.repeat(99)}...`);
  expect(clip(`${'x'.repeat(98)}😀!`)).toBe(`${'x'.repeat(98)}😀...`);
});

it('a clipped message keeps its sentence around a long word, and is bounded whatever it contains', () => {
  const message = clipMessage(
    `https://example.test/${'a'.repeat(1e5)} is empty. Check the address.`,
  );
  expect(message).toMatch(/^https:\/\/example\.test\/a{79}\.\.\. is empty\. Check the address\.$/);
  expect(clipMessage('a b '.repeat(1e5))).toHaveLength(503);
  expect(clipMessage(`${'😀'.repeat(60)} `.repeat(1e3)).length).toBeLessThan(520);
});

it('a list names its first ten entries, each clipped, and counts the rest', () => {
  const names = Array.from({ length: 12 }, (_, i) => `n${i}`);
  expect(listed(['a', 'x'.repeat(101)])).toBe(`a, ${'x'.repeat(100)}...`);
  expect(listed(names.slice(0, 10))).toBe('n0, n1, n2, n3, n4, n5, n6, n7, n8, n9');
  expect(listed(names)).toBe('n0, n1, n2, n3, n4, n5, n6, n7, n8, n9 and 2 more');
});

/** The optimal string alignment distance, by the textbook's table. */
function distance(a: string, b: string) {
  const table: number[][] = [];
  const at = (i: number, j: number) => table[i]?.[j] ?? Infinity;
  for (let i = 0; i <= a.length; i++) {
    table.push([]);
    for (let j = 0; j <= b.length; j++) {
      const swapped = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      const steps = [
        at(i - 1, j) + 1,
        at(i, j - 1) + 1,
        at(i - 1, j - 1) + (a[i - 1] === b[j - 1] ? 0 : 1),
      ];
      table[i]!.push(
        i + j === 0 ? 0 : Math.min(...steps, swapped ? at(i - 2, j - 2) + 1 : Infinity),
      );
    }
  }
  return at(a.length, b.length);
}

describe('the nearest word', () => {
  it('is the one with fewer edits, whatever the order', () => {
    expect(nearest('ambien', ['ambit', 'ambient'])).toBe('ambient');
    expect(nearest('torus-knt', ['torus', 'torus-knot'])).toBe('torus-knot');
    expect(nearest('torus-knt', ['torus-knot', 'torus'])).toBe('torus-knot');
  });

  it('is the same as by the textbook’s table, in both directions (seed 7)', () => {
    const word = fc.string({ unit: fc.constantFrom('a', 'b', 'c'), maxLength: 8 });
    fc.assert(
      fc.property(word, word, (a, b) => {
        expect(nearest(a, [b]) === b).toBe(distance(a, b) <= (b.length < 6 ? 1 : 2));
      }),
      { seed: 7, numRuns: 3000 },
    );
  });
});
