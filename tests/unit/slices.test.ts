// Do long loops cover every item once, let other tasks run, and end with an abort?
import { afterEach, describe, expect, it, vi } from 'vitest';
import { Slices } from '../../src/model/slices.js';

afterEach(() => {
  vi.restoreAllMocks();
});

describe('a loop in slices', () => {
  it.each([0, 1, 24_576, 24_577, 100_000])('covers %d items, each once and in order', async (count) => {
    let next = 0;
    await new Slices(new AbortController().signal).over(count, (from, to) => {
      expect(from).toBe(next);
      expect(from % 3).toBe(0);
      next = to;
    });
    expect(next).toBe(count);
  });

  it('lets other tasks run when its time slice is over', async () => {
    let now = 0;
    vi.spyOn(performance, 'now').mockImplementation(() => (now += 100));
    const order: string[] = [];
    setImmediate(() => order.push('other'));
    await new Slices(new AbortController().signal).over(100_000, () => order.push('slice'));
    expect(order.indexOf('other')).toBeGreaterThan(0);
    expect(order.indexOf('other')).toBeLessThan(order.length - 1);
  });

  it('ends with the reason of an abort', async () => {
    let now = 0;
    vi.spyOn(performance, 'now').mockImplementation(() => (now += 100));
    const controller = new AbortController();
    const slice = vi.fn(() => {
      controller.abort(new Error('enough'));
    });
    await expect(new Slices(controller.signal).over(100_000, slice)).rejects.toThrow('enough');
    expect(slice).toHaveBeenCalledTimes(1);
  });
});
