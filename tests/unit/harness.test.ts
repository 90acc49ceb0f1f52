// Do the browser tests' own instruments detect what they should? A console guard that records
// nothing would pass every test.

import { EventEmitter } from 'node:events';
import type { BrowserContext } from '@playwright/test';
import { describe, expect, it } from 'vitest';
import { ConsoleGuard } from '../support/console-guard.js';
import { compare, pixelAt } from '../support/picture.js';

async function guarded() {
  const context = Object.assign(new EventEmitter(), { addInitScript: () => Promise.resolve() });
  const guard = new ConsoleGuard();
  await guard.watch(context as unknown as BrowserContext);
  const say = (type: string, text: string) => {
    context.emit('console', { type: () => type, text: () => text });
  };
  return { guard, say };
}

describe('ConsoleGuard', () => {
  it.each(['log', 'info', 'warning', 'error', 'debug'])(
    'fails on a stray console line of type %s, and passes without one',
    async (type) => {
      const { guard, say } = await guarded();
      expect(() => guard.check()).not.toThrow();
      say(type, 'boo');
      expect(() => guard.check()).toThrow(`${type}: boo`);
    },
  );

  it('returns claimed lines and fails on the others', async () => {
    const { guard, say } = await guarded();
    const met = guard.allow(/cutoff/);
    guard.allow(/nothing/, 0);
    say('warning', 'cutoff="x"');
    expect(() => guard.check()).not.toThrow();
    say('warning', 'aperture="x"');
    expect(met).toEqual(['warning: cutoff="x"']);
    expect(() => guard.check()).toThrow('aperture');
  });

  it('fails if a claim is not met, or not as often as stated', async () => {
    const { guard, say } = await guarded();
    guard.allow(/never/);
    guard.allow(/twice/, 2);
    say('log', 'twice');
    expect(() => guard.check()).toThrow(/never[^]*twice.*met 1 times/);
  });
});

describe('pictures', () => {
  const picture = (...data: number[]) => ({
    width: data.length / 4,
    height: 1,
    data: new Uint8Array(data),
  });
  const a = picture(10, 20, 30, 255, 0, 0, 0, 255);
  const b = picture(12, 20, 26, 255, 0, 0, 0, 255);

  it('are compared by largest difference, and share of channels beyond the tolerance', () => {
    expect(compare(a, a)).toEqual({ max: 0, share: 0 });
    expect(compare(a, b)).toEqual({ max: 4, share: 2 / 8 });
    expect(compare(a, b, 2).share).toBe(1 / 8);
    expect(() => compare(a, picture(0, 0, 0, 0))).toThrow('sizes differ');
  });

  it('are read by column and row, and not outside', () => {
    expect(pixelAt(picture(1, 2, 3, 4, 5, 6, 7, 8), 1, 0)).toEqual([5, 6, 7, 8]);
    expect(() => pixelAt(a, 2, 0)).toThrow(RangeError);
  });
});
