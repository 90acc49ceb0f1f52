// Which part of a text from outside does a message repeat?

import { describe, expect, it } from 'vitest';
import { clip, clipMessage } from '../../src/fields/clip.js';

describe('a clipped text', () => {
  it('is the text itself up to 100 characters', () => {
    for (const text of ['', 'red', 'x'.repeat(100), '😀'.repeat(50)]) expect(clip(text)).toBe(text);
  });

  it('is its first 100 characters and an ellipsis beyond', () => {
    expect(clip('x'.repeat(101))).toBe(`${'x'.repeat(100)}...`);
    expect(clip('x'.repeat(1e6))).toHaveLength(103);
  });

  it('never ends in the middle of a surrogate pair', () => {
    expect(clip(`${'x'.repeat(99)}😀`)).toBe(`${'x'.repeat(99)}...`);
    expect(clip(`${'x'.repeat(98)}😀!`)).toBe(`${'x'.repeat(98)}😀...`);
  });
});

describe('a clipped message', () => {
  it('keeps its sentence around a long word', () => {
    const message = clipMessage(`https://example.test/${'a'.repeat(1e5)} is empty. Check the address.`);
    expect(message).toMatch(/^https:\/\/example\.test\/a{79}\.\.\. is empty\. Check the address\.$/);
  });

  it('is bounded whatever it contains', () => {
    expect(clipMessage('a b '.repeat(1e5))).toHaveLength(503);
    expect(clipMessage(`${'😀'.repeat(60)} `.repeat(1e3)).length).toBeLessThan(520);
  });
});
