// Does one animation frame serve all pictures of the page, phase by phase?
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { type Framed, type FrameLoop, frameLoopOf, type FrameSource } from '../../src/scene/frame-loop.js';

let callbacks: Map<number, FrameRequestCallback>;
let requests: number;
let frameLoop: FrameLoop;

beforeEach(() => {
  callbacks = new Map();
  requests = 0;
  frameLoop = frameLoopOf({
    requestAnimationFrame(callback) {
      callbacks.set(++requests, callback);
      return requests;
    },
    cancelAnimationFrame: (id) => callbacks.delete(id),
  });
});

afterEach(() => {
  vi.unstubAllGlobals();
});

function runFrame(now = 0): void {
  const due = [...callbacks.values()];
  callbacks.clear();
  for (const callback of due) callback(now);
}

/** Logs its phases; requests another frame while `moving`. */
function picture(name: string, log: string[], moving = false): Framed {
  return {
    prepare: () => log.push(`prepare ${name}`),
    advance: (now) => {
      log.push(`advance ${name} ${String(now)}`);
      return moving;
    },
    draw: () => log.push(`draw ${name}`),
    resized: false,
  };
}

describe('the frame loop', () => {
  test('finishes each phase for all pictures before the next phase starts', () => {
    const log: string[] = [];
    for (const name of ['a', 'b']) frameLoop.request(picture(name, log));
    runFrame(7);
    expect(log).toEqual(['prepare a', 'prepare b', 'advance a 7', 'advance b 7', 'draw a', 'draw b']);
  });

  test('makes one frame of any number of requests, and none after it', () => {
    const a = picture('a', []);
    const b = picture('b', []);
    for (const one of [a, b, a, a, b]) frameLoop.request(one);
    expect(requests).toBe(1);
    runFrame();
    expect(callbacks.size).toBe(0);
  });

  test('repeats for a moving picture until its request is withdrawn', () => {
    const moving = picture('a', [], true);
    frameLoop.request(moving);
    runFrame();
    expect(callbacks.size).toBe(1);
    frameLoop.cancel(moving);
    expect(callbacks.size).toBe(0);
  });

  test('serves a request made during a frame in the next one', () => {
    const log: string[] = [];
    const late = picture('late', log);
    const first = picture('first', []);
    frameLoop.request({ ...first, draw: () => frameLoop.request(late) });
    runFrame();
    expect(log).toEqual([]);
    runFrame();
    expect(log).toContain('draw late');
  });

  test('draws waiting pictures of another size before the browser paints, and no second time', () => {
    const log: string[] = [];
    const larger = { ...picture('larger', log), resized: true };
    frameLoop.request(larger);
    frameLoop.drawResized();
    expect(log).toEqual(['draw larger']);
    expect(callbacks.size).toBe(0);
    for (const one of [larger, picture('b', log)]) frameLoop.request(one);
    frameLoop.drawResized();
    runFrame(7);
    expect(log.slice(1)).toEqual(['draw larger', 'prepare b', 'advance b 7', 'draw b']);
  });

  test('takes the frames of each picture from the window that shows it', () => {
    const frozen: FrameSource = { requestAnimationFrame: () => 1, cancelAnimationFrame: () => undefined };
    expect(frameLoopOf(frozen)).toBe(frameLoopOf(frozen));
    frameLoopOf(frozen).request(picture('hidden', []));
    const log: string[] = [];
    frameLoop.request(picture('shown', log));
    runFrame();
    expect(log).toContain('draw shown');
  });

  test('reports a broken picture and goes on with the others', () => {
    const report = vi.fn();
    vi.stubGlobal('reportError', report);
    const log: string[] = [];
    const failure = new Error('broken');
    const broken = { ...picture('broken', []), prepare: (): never => { throw failure; } }; // prettier-ignore
    for (const one of [broken, picture('b', log)]) frameLoop.request(one);
    runFrame();
    expect(report).toHaveBeenCalledExactlyOnceWith(failure);
    expect(log).toContain('draw b');
  });
});
