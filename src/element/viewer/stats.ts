// What a viewer tells of its own cost. Types only.

/** A plain snapshot of what drawing costs; counts since the viewer was made unless said otherwise. */
export interface ViewerStats {
  readonly frames: number;
  readonly lightsDeclared: number;
  readonly lightsActive: number;
  /** Lights that the shader loops over for any mesh; the others bring ambient light only, or nothing. */
  readonly lightsSent: number;
  /** The same for each mesh by itself: the viewer's own, if it has one, and then `meshes` in the order they came. */
  readonly lightsSentByMesh: readonly number[];
  /** Programs of the page's WebGL context. */
  readonly programs: number;
  /** In the last frame. */
  readonly drawCalls: number;
  /** Of light data. */
  readonly uploads: number;
  /** How many viewers of the page its last frame has drawn: those on screen that had changed. */
  readonly viewersDrawn: number;
}
