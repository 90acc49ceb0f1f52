import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Batches } from '../../src/scene/samples/batches.js';

/** A GPU that takes so many milliseconds for each sample. */
class Gpu {
  cost = 1;
  fences = 0;
  #end = 0;
  readonly gl = {
    ...{ SYNC_GPU_COMMANDS_COMPLETE: 1, SYNC_STATUS: 2, SIGNALED: 3 },
    fenceSync: () => ((this.fences += 1), {}),
    deleteSync: () => (this.fences -= 1),
    flush: () => undefined,
    getSyncParameter: () => (performance.now() >= this.#end ? 3 : 4),
  } as unknown as WebGL2RenderingContext;

  draw(): void {
    this.#end = Math.max(this.#end, performance.now()) + this.cost;
  }
}

describe('batches of samples', () => {
  beforeEach(() => {
    vi.useFakeTimers();
    vi.stubGlobal('window', globalThis);
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  /** Sizes of the batches in so many animation frames of 16 ms. */
  function sizes(gpu: Gpu, frames: number, left = Infinity): number[] {
    const batches = new Batches(gpu.gl);
    const drawn: number[] = [];
    for (let frame = 0; frame < frames; frame++) {
      if (batches.ended) {
        let count = 0;
        batches.send(left, () => {
          gpu.draw();
          count += 1;
        });
        drawn.push(count);
      }
      vi.advanceTimersByTime(16);
    }
    batches.cancel();
    expect(gpu.fences).toBe(0);
    return drawn;
  }

  it('grow from one sample to what the GPU draws in 8 ms', () => {
    const gpu = new Gpu();
    expect(sizes(gpu, 6)).toEqual([1, 2, 4, 8, 16, 8]);
  });

  it('stay at one sample that takes longer, and wait for its end', () => {
    const gpu = new Gpu();
    gpu.cost = 40;
    expect(sizes(gpu, 9)).toEqual([1, 1, 1]);
  });

  it('grow after a slow first sample, which allocates and compiles', () => {
    const gpu = new Gpu();
    gpu.cost = 20;
    const draw = gpu.draw.bind(gpu);
    gpu.draw = () => {
      draw();
      gpu.cost = 1;
    };
    expect(sizes(gpu, 6)).toEqual([1, 1, 2, 4, 8]);
  });

  it('reach what the GPU draws in 8 ms again after one that was late, and try more once in a while', () => {
    const gpu = new Gpu();
    const draw = gpu.draw.bind(gpu);
    let drawn = 0;
    gpu.draw = () => {
      drawn += 1;
      gpu.cost = drawn === 4 ? 15 : 1; // in the batch of 4: something else kept the GPU busy
      draw();
    };
    const found = sizes(gpu, 30);
    expect(found.slice(0, 4)).toEqual([1, 2, 4, 2]);
    expect(found.slice(-15)).toContain(8);
    const late = found.filter((size) => size > 8).length;
    expect(late / found.length).toBeLessThan(0.1);
  });

  it('grow again after a script that was late once', () => {
    const gpu = new Gpu();
    gpu.cost = 0.5;
    const draw = gpu.draw.bind(gpu);
    let drawn = 0;
    gpu.draw = () => {
      drawn += 1;
      if (drawn === 5) vi.advanceTimersByTime(9);
      draw();
    };
    expect(Math.max(...sizes(gpu, 20).slice(-4))).toBe(16);
  });

  it('leave no fence behind where one is sent before the last has ended', () => {
    const gpu = new Gpu();
    const batches = new Batches(gpu.gl);
    for (let i = 0; i < 3; i++)
      batches.send(1, () => {
        gpu.draw();
      });
    expect(gpu.fences).toBe(1);
    batches.cancel();
    expect(gpu.fences).toBe(0);
  });

  it('have no more samples than are left', () => {
    expect(sizes(new Gpu(), 4, 3)).toEqual([1, 2, 3, 3]);
  });

  it('follow each other between animation frames, and leave no timer behind', () => {
    const gpu = new Gpu();
    const drawn: [time: number, count: number][] = [];
    const start = performance.now();
    let left = 63;
    const send = (): void => {
      if (!batches.ended) return;
      let count = 0;
      batches.send(left, () => {
        gpu.draw();
        count += 1;
      });
      left -= count;
      drawn.push([performance.now() - start, count]);
    };
    const batches = new Batches(gpu.gl, () => {
      if (left > 0) send();
    });
    send();
    const frames = setInterval(() => {
      if (left > 0) send();
    }, 16);
    vi.advanceTimersByTime(200);
    clearInterval(frames);
    expect(left).toBe(0);
    const [last] = drawn.at(-1)!;
    expect(last, `63 ms of drawing: ${JSON.stringify(drawn)}`).toBeLessThan(90);
    expect(vi.getTimerCount()).toBe(0);
    left = 1;
    send();
    batches.cancel();
    expect(vi.getTimerCount()).toBe(0);
  });

  it('do not ask for the next one after a late one: that begins in an animation frame', () => {
    const gpu = new Gpu();
    gpu.cost = 9;
    const next = vi.fn();
    new Batches(gpu.gl, next).send(1, () => {
      gpu.draw();
    });
    vi.advanceTimersByTime(100);
    expect(next).not.toHaveBeenCalled();
    expect(vi.getTimerCount()).toBe(0);
  });

  it('end where the script alone takes 8 ms', () => {
    const gpu = new Gpu();
    const batches = new Batches(gpu.gl);
    for (let frame = 0; frame < 4; frame++) {
      batches.send(Infinity, () => undefined);
      vi.advanceTimersByTime(16);
      expect(batches.ended).toBe(true);
    }
    let drawn = 0;
    batches.send(Infinity, () => {
      vi.advanceTimersByTime(3);
      drawn += 1;
    });
    expect(drawn).toBe(3);
    batches.cancel();
  });
});
