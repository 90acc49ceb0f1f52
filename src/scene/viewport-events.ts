// What a viewport tells whoever made it. Types only.

export interface ViewportEvents {
  /** Nobody knows yet whether the picture can be seen and how large it is: call `place`. */
  locate(): void;
  /** Before each frame; true asks for another one. `now` as animation frames have it, in milliseconds. */
  beforeFrame(now: number): boolean;
  drawn(): void;
  /** After {@link drawn}, and also where drawing has thrown: nothing more is coming of itself. */
  tried(): void;
  /** Since the first frame, `auto` has found another target or radius. */
  fitted(): void;
  /** There is no WebGL 2: nothing will be drawn. */
  contextMissing(error: Error): void;
  contextLost(): void;
  contextRestored(): void;
}
