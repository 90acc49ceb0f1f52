// One way to draw a scene: what the element, its core and plain three.js have in common for the bench.
import type { Scene } from './scenes.js';

export interface Side {
  /** Changes the scene to its state at this frame and draws it. */
  frame(i: number): Promise<void>;
}

/** Opens a scene in an element that has its final size. Resolves once one frame is drawn. */
export type OpenSide = (holder: HTMLElement, scene: Scene) => Promise<Side>;
