// Opens one axis with one scene at a time, tells each subject's error and takes its samples: what both the bench's driver and
// the demo's page do. Times are milliseconds for all frames of a sample.
import { type ErrorFigures, errorOf } from '../error/error-figures.js';
import { rendererName } from '../../glsl/float-pass.js';
import { clockFrames, finish, timeFrames } from '../pages/peers/peer.js';
import { AXES, GROWTHS } from './axes.js';
import { pace, type Stand, type StandOptions, type Subject } from './stand.js';

/** A stand as it is told to whoever cannot hold it. */
export type StandFacts = Pick<Stand, 'title' | 'truth' | 'base' | 'shipped' | 'size' | 'errorSize'> & {
  readonly renderer: string;
  readonly hasTimer: boolean;
  readonly subjects: readonly Pick<Subject, 'id' | 'label'>[];
};

export class Runner {
  readonly #holder: HTMLElement;
  #stand: Stand | null = null;

  /** `holder` shows what is drawn. */
  constructor(holder: HTMLElement) {
    this.#holder = holder;
  }

  /** All axes' names and scenes. */
  get axes(): { name: string; title: string; scenes: readonly string[] }[] {
    return Object.entries(AXES).map(([name, { title, scenes }]) => ({ name, title, scenes }));
  }

  async open(axis: string, scene: string, options: StandOptions): Promise<StandFacts> {
    this.close();
    const opener = AXES[axis] ?? GROWTHS[axis];
    if (opener?.scenes.includes(scene) !== true)
      throw new RangeError(`no axis ${axis} with a scene ${scene}`);
    const stand = await opener.open(scene, options, this.#holder);
    this.#stand = stand;
    const { title, truth, base, shipped, size, errorSize, subjects } = stand;
    const { gl } = subjects[0]!;
    return {
      ...{ title, truth, base, shipped, size, errorSize },
      renderer: rendererName(gl),
      hasTimer: gl.getExtension('EXT_disjoint_timer_query_webgl2') !== null,
      subjects: subjects.map(({ id, label }) => ({ id, label })),
    };
  }

  /** Of each subject, in order; `told` hears of each as it is found. */
  async errors(told: (done: number) => void = () => undefined): Promise<ErrorFigures[]> {
    const { subjects, reference } = this.#open;
    const breathe = pace();
    const truth = await reference(breathe);
    const errors: ErrorFigures[] = [];
    for (const subject of subjects) {
      errors.push(errorOf(await subject.picture(), truth));
      told(errors.length);
      await breathe();
    }
    return errors;
  }

  /** By the clock, closed by reading a pixel back. */
  clock(subject: number, frames: number): number {
    return clockFrames(this.#subject(subject), frames);
  }

  /** By the GPU's own timer. */
  async time(subject: number, frames: number): Promise<number> {
    const one = this.#subject(subject);
    finish(one.gl);
    return timeFrames(one, frames);
  }

  close(): void {
    this.#stand?.close();
    this.#stand = null;
    this.#holder.replaceChildren();
  }

  get #open(): Stand {
    if (this.#stand === null) throw new Error('nothing is open');
    return this.#stand;
  }

  #subject(i: number): Subject {
    const subject = this.#open.subjects[i];
    if (subject === undefined) throw new RangeError(`there is no subject ${String(i)}`);
    return subject;
  }
}
