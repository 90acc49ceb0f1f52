// Which part of a text from outside does a message repeat?

import { expect, it } from 'vitest';
import { clip, clipMessage } from '../../src/fields/clip.js';

it('a text is clipped after 100 characters, never in the middle of a surrogate pair', () => {
  for (const text of ['', 'red', 'x'.repeat(100), '😀'.repeat(50)]) expect(clip(text)).toBe(text);
  expect(clip('x'.repeat(101))).toBe(`${'x'.repeat(100)}...`);
  expect(clip('x'.repeat(1e6))).toHaveLength(103);
  expect(clip(`${'x'.repeat(99)}😀`)).toBe(`${'x'.repeat(99)}...`);
  expect(clip(`${'x'.repeat(98)}😀!`)).toBe(`${'x'.repeat(98)}😀...`);
});

it('a clipped message keeps its sentence around a long word, and is bounded whatever it contains', () => {
  const message = clipMessage(`https://example.test/${'a'.repeat(1e5)} is empty. Check the address.`);
  expect(message).toMatch(/^https:\/\/example\.test\/a{79}\.\.\. is empty\. Check the address\.$/);
  expect(clipMessage('a b '.repeat(1e5))).toHaveLength(503);
  expect(clipMessage(`${'😀'.repeat(60)} `.repeat(1e3)).length).toBeLessThan(520);
});
