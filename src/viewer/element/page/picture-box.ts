// Where a picture lies on the page, by three corners of it: all transforms of any ancestor, zoom
// and scrolling count.
import { html } from 'lit';
import type { PictureBox } from '../../../phong/camera/gesture.js';

/** Styles as properties: a strict CSP refuses style attributes. */
const corner = (left: string, top: string) =>
  html`<i class="corner" .style=${`position: absolute; left: ${left}; top: ${top}`}></i>`;

/**
 * Elements without size in the top left, top right and bottom left corner of the element around
 * them.
 */
export const CORNER_MARKS = [corner('0', '0'), corner('100%', '0'), corner('0', '100%')];

/**
 * The box of a surface that contains {@link CORNER_MARKS}, as it is now. Under a perspective, where
 * pixels differ in size, the top and left edges count. No axes while it is hidden.
 */
export function pictureBox(surface: HTMLElement): PictureBox {
  const { clientWidth: width, clientHeight: height } = surface;
  const corners = [...surface.querySelectorAll(':scope > .corner')];
  const [start, right, down] = corners.map((corner) => corner.getBoundingClientRect());
  if (
    start === undefined ||
    right === undefined ||
    down === undefined ||
    width === 0 ||
    height === 0
  ) {
    return { width, height };
  }
  const rightward = [(right.left - start.left) / width, (right.top - start.top) / width] as const;
  const downward = [(down.left - start.left) / height, (down.top - start.top) / height] as const;
  return { width, height, axes: [...rightward, ...downward] };
}
