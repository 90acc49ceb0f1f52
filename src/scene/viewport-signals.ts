// What a viewport reports to the parts around it, and what it asks them.
import { Signal } from '../fields/signal.js';

export class ViewportSignals {
  /** Before the first frame: size and visibility of the picture are not known yet. Set `near` and call `resize`. */
  readonly layoutNeeded = new Signal();
  /** The scene as it is has been drawn without an exception. */
  readonly painted = new Signal();
  /** A frame was drawn, and may still have to be copied to the picture's canvas. */
  readonly drawn = new Signal();
  /** A changed picture is on its canvas, whose pixels can be read until the task ends. Once a frame. */
  readonly shown = new Signal();
  /** After {@link drawn}, where drawing threw, and where there is no context: no more frames come by themselves. */
  readonly frameEnded = new Signal();
  /** `auto` found another target or radius. Not for the first frame. */
  readonly fitted = new Signal();
  /** There is no WebGL 2. {@link contextRestored} follows if a later attempt succeeds. */
  readonly contextMissing = new Signal<Error>();
  readonly contextLost = new Signal();
  readonly contextRestored = new Signal();
  /**
   * Moves what moves by itself to where it is at `now`, the time of an animation frame in ms. True while it keeps
   * moving.
   */
  moveTo: (now: number) => boolean = () => false;
  /** Something that belongs to the first picture, which is not drawn yet, is on its way. */
  awaited: () => boolean = () => false;
  /** Drawing has thrown. True if new content was to blame and is taken back. `draw` tries to draw, and may throw. */
  recover: (error: unknown, draw: () => void) => boolean = () => false;
}
