// Where does a picture lie on the page, as a pointer's travel is measured? Asks the browser where three corners are, so all that
// moves or turns an element counts: transforms of any ancestor, zoom, scrolling. Knows no camera.
import type { PictureBox } from '../../camera/gesture.js';

/**
 * The box of `surface`. `corners` are elements without size at its top left, top right and bottom left corner. Under a
 * perspective, where pixels differ in size, the top and left edges count.
 */
export function pictureBox(surface: HTMLElement, corners: ArrayLike<Element>): PictureBox {
  const { clientWidth: width, clientHeight: height } = surface;
  const [start, right, down] = Array.from(corners, (corner) => corner.getBoundingClientRect());
  if (start === undefined || right === undefined || down === undefined) return { width, height };
  const rightward = [(right.left - start.left) / width, (right.top - start.top) / width] as const;
  const downward = [(down.left - start.left) / height, (down.top - start.top) / height] as const;
  return { width, height, axes: [...rightward, ...downward] };
}
