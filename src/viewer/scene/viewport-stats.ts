// What `viewer.stats` says of drawing. A file of its own: the package ships the types that this one
// reaches, and picture.ts reaches those of the whole scene.

/** What drawing costs. Counts since the viewport was created unless stated otherwise. */
export interface ViewportStats {
  readonly frames: number;
  /**
   * Frames of these that had fewer pixels, as something moved and drawing took too long. None where
   * `pixel-ratio` is written.
   */
  readonly reducedFrames: number;
  /**
   * Samples per pixel of the picture that is shown now: with `antialias="full"` up to `samples`, 0
   * before its first ones are shown. Stays 0 where the GPU has no float targets: `full` is like
   * `edges` there.
   */
  readonly samples: number;
  readonly lightsActive: number;
  /**
   * Lights that the shader loops over for at least one mesh; the others add ambient light only, or
   * nothing.
   */
  readonly lightsSent: number;
  /**
   * The same for each mesh: the viewer's own, if it has one, then `meshes` in the order they were
   * added.
   */
  readonly lightsSentByMesh: readonly number[];
  /** Programs of the page's WebGL context. */
  readonly programs: number;
  /** In the last frame. */
  readonly drawCalls: number;
  /** Uploads of light data. */
  readonly uploads: number;
  /** Viewers that the page's last frame has drawn: those in view that had changed. */
  readonly viewersDrawn: number;
}
