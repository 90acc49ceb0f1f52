// What a bench of time against error asks of an axis and a scene: ways to draw the same picture, each to be timed, and what the
// picture ought to be. Knows neither how pictures are drawn nor who asks.
import type { ColorPicture } from '../error/error-figures.js';

export type Size = readonly [width: number, height: number];

/** One way to draw the picture. */
export interface Subject {
  readonly id: string;
  readonly label: string;
  readonly gl: WebGL2RenderingContext;
  /** Draws one frame of the timed size, at once. */
  draw(): void;
  /** The frame that errors are taken of. */
  picture(): Promise<ColorPicture> | ColorPicture;
}

/** One axis with one scene, opened. */
export interface Stand {
  readonly title: string;
  /** What errors are taken against, in words. */
  readonly truth: string;
  /** Of the subject that the others' times are compared with. */
  readonly base: string;
  /** Of the subject that the element draws with when nothing else is asked for. */
  readonly shipped: string;
  readonly size: Size;
  readonly errorSize: Size;
  readonly subjects: readonly Subject[];
  reference(pace: Pace): Promise<ColorPicture>;
  close(): void;
}

export interface StandOptions {
  /** What is timed; stands that need another aspect take as many pixels. */
  readonly size: Size;
  readonly seed: number;
  /** How many shaded points a reference may cost: its picture is as large as that allows. */
  readonly evaluations: number;
  /** Fewer variants and coarser references: for somebody who waits. Default false. */
  readonly quick?: boolean;
}

export interface Axis {
  readonly title: string;
  readonly scenes: readonly string[];
  open(scene: string, options: StandOptions, holder: HTMLElement): Promise<Stand>;
}

/** Lets the page live while something long is computed: awaited often, it waits only when it is time. */
export type Pace = () => Promise<void>;

/** A task's length that nobody notices, in milliseconds. */
const NOTICED = 12;

export function pace(): Pace {
  let last = performance.now();
  return async () => {
    if (performance.now() - last < NOTICED) return;
    await new Promise((resolve) => setTimeout(resolve));
    last = performance.now();
  };
}

/** The largest power of two, up to `most`, whose square times `lights` is at most `evaluations`; at least 32. */
export function squareSide(evaluations: number, lights: number, most = 256): number {
  const side = 2 ** Math.floor(Math.log2(Math.sqrt(evaluations / Math.max(lights, 1))));
  return Math.min(Math.max(side, 32), most);
}
