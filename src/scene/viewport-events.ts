// What a viewport reports to its owner. Types only.

export interface ViewportEvents {
  /** Before the first frame: size and visibility of the picture are not known yet. Set `near` and call `resize`. */
  needsLayout(): void;
  /** Before each frame; true requests another one. `now` in milliseconds, as animation frames have it. */
  beforeFrame(now: number): boolean;
  /** The scene as it is has been drawn without an exception. */
  painted(): void;
  /** Drawing has thrown. True if new content was to blame and is taken back. `draw` tries to draw, and may throw. */
  undrawable(error: unknown, draw: () => void): boolean;
  drawn(): void;
  /** After {@link drawn}, where drawing threw, and where there is no context: no more frames come by themselves. */
  afterFrame(): void;
  /** `auto` found another target or radius. Not called for the first frame. */
  fitted(): void;
  /** There is no WebGL 2. {@link contextRestored} follows if a later attempt succeeds. */
  contextMissing(error: Error): void;
  contextLost(): void;
  contextRestored(): void;
}
