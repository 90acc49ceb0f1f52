// Whose turn is it to converge? One picture at a time: those in view first, otherwise in the order in which they asked.

import { afterEach, describe, expect, it } from 'vitest';
import { release, seize, take, type Waiting } from '../../src/scene/samples/turns.js';

class Picture implements Waiting {
  inView: boolean;
  woken = 0;

  constructor(inView = true) {
    this.inView = inView;
    all.push(this);
  }

  wake(): void {
    this.woken += 1;
  }

  pause(): void {
    release(this);
  }
}

const all: Picture[] = [];
afterEach(() => {
  for (const one of all.splice(0)) release(one);
});

/** Everybody asks, in each round, until all have ended: those whose turn it is end at once. */
function orderOf(pictures: readonly Picture[]): number[] {
  const order: number[] = [];
  for (let round = 0; round <= pictures.length; round++) {
    pictures.forEach((one, i) => {
      if (!order.includes(i) && take(one)) order.push(i);
    });
    const last = pictures[order.at(-1)!]!;
    release(last);
  }
  return order;
}

describe('turns', () => {
  it('come in the order of the first question', () => {
    const pictures = Array.from({ length: 5 }, () => new Picture());
    expect(orderOf(pictures)).toEqual([0, 1, 2, 3, 4]);
  });

  it('belong to one picture at a time, and wake the next one', () => {
    const [a, b, c] = [new Picture(), new Picture(), new Picture()];
    expect([take(a), take(b), take(c), take(a)]).toEqual([true, false, false, true]);
    release(a);
    expect([b.woken, c.woken]).toEqual([1, 0]);
    expect([take(c), take(b)], 'the woken one goes first').toEqual([false, true]);
  });

  it('go to pictures in view before those near it', () => {
    const near = [new Picture(false), new Picture(false)];
    const seen = [new Picture(), new Picture()];
    expect([take(near[0]!), take(near[1]!), take(seen[0]!), take(seen[1]!)]).toEqual([
      true,
      false,
      true,
      false,
    ]);
    expect(take(near[0]!)).toBe(false);
    release(seen[0]!);
    expect(seen[1]!.woken).toBeGreaterThan(0);
    expect(take(seen[1]!)).toBe(true);
    release(seen[1]!);
    expect([take(near[1]!), take(near[0]!)], 'first the one that was interrupted').toEqual([false, true]);
  });

  it('pass on when the picture that converges leaves the view', () => {
    const [a, b] = [new Picture(), new Picture()];
    expect([take(a), take(b)]).toEqual([true, false]);
    a.inView = false;
    expect(take(a)).toBe(false);
    expect(b.woken).toBeGreaterThan(0);
    expect(take(b)).toBe(true);
    release(b);
    expect(take(a)).toBe(true);
  });

  it('wake another one when the next one has left the view', () => {
    const [a, b, c] = [new Picture(), new Picture(), new Picture()];
    for (const one of [a, b, c]) take(one);
    release(a);
    b.inView = false;
    expect(take(b)).toBe(false);
    expect(c.woken).toBe(1);
    expect(take(c)).toBe(true);
  });

  it('come back after being seized', () => {
    const [a, b] = [new Picture(), new Picture()];
    take(a);
    seize(b);
    expect(take(a)).toBe(false);
    release(b);
    expect(a.woken).toBe(1);
    expect(take(a)).toBe(true);
  });
});
