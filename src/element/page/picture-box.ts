// Where does a picture lie on the page, as a pointer's travel is measured? Asks the browser where three corners are, so all that
// moves or turns an element counts: transforms of any ancestor, zoom, scrolling. Knows no camera.
import type { PictureBox } from '../../camera/gesture.js';

export class PictureCorners {
  readonly #surface: HTMLElement;
  readonly #corners: readonly HTMLElement[];

  /** Adds elements without size to the top left, top right and bottom left corner of `surface`; its style sheet places them. */
  constructor(surface: HTMLElement) {
    this.#surface = surface;
    this.#corners = ['corner', 'corner right', 'corner low'].map((className) =>
      Object.assign(document.createElement('i'), { className }),
    );
    surface.append(...this.#corners);
  }

  /** As it is now. Under a perspective, where pixels differ in size, the top and left edges count. */
  get box(): PictureBox {
    const { clientWidth: width, clientHeight: height } = this.#surface;
    const [start, right, down] = this.#corners.map((corner) => corner.getBoundingClientRect());
    if (start === undefined || right === undefined || down === undefined) return { width, height };
    const rightward = [(right.left - start.left) / width, (right.top - start.top) / width] as const;
    const downward = [(down.left - start.left) / height, (down.top - start.top) / height] as const;
    return { width, height, axes: [...rightward, ...downward] };
  }
}
