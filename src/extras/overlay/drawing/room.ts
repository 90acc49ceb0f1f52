// The free rectangle of the layer over the picture, the boxes in it, and its text size. The style
// sheets lay it out (phong-viewer.css, and panel.css for the panel). Observers follow them after
// layout, so that no frame forces one.
import type { ExtraHost } from '../../../viewer/extra.js';
import type { Rect } from './label-layout.js';
import { createElement } from './dom.js';

export class Room {
  /** CSS pixels of the layer. Without width or height where nothing is free. */
  box: Rect = { left: 0, top: 0, right: 0, bottom: 0 };
  /** The legend and the probe's table, where names are placed. CSS pixels of the layer. */
  boxes: readonly Rect[] = [];
  /** CSS pixels, above 0. */
  fontSize = 0;
  readonly #tree: ExtraHost['tree'];
  /** As wide as the text is high. */
  readonly #em: HTMLElement;
  readonly #observer: ResizeObserver;
  /** Follows what changes the boxes' places but not their sizes. */
  readonly #arrivals = new MutationObserver(() => this.#observeBoxes());

  /**
   * `changed`: room, boxes or text have another size or place. `namePart`: of names outside {@link
   * boxes}, if any.
   */
  constructor(tree: ExtraHost['tree'], changed: () => void, namePart: string | null = null) {
    this.#tree = tree;
    this.#em = createElement('i', { class: 'corner', 'aria-hidden': 'true', part: namePart });
    this.#em.style.width = '1em';
    tree.layer.prepend(this.#em);
    this.#read();
    this.#observer = new ResizeObserver(() => {
      this.#read();
      changed();
    });
    for (const each of [this.#em, tree.room, tree.free]) {
      this.#observer.observe(each);
    }
    this.#observeBoxes();
  }

  dispose(): void {
    this.#observer.disconnect();
    this.#arrivals.disconnect();
    this.#em.remove();
  }

  /** Each extra has a place in the free part, which holds its box. */
  #observeBoxes(): void {
    const { free } = this.#tree;
    this.#arrivals.observe(free, { childList: true });
    for (const place of free.children) {
      this.#arrivals.observe(place, { childList: true });
      for (const box of place.children) {
        this.#arrivals.observe(box, { attributeFilter: ['class', 'hidden'] });
        this.#observer.observe(box);
      }
    }
    // Observed anew, it is reported after the next layout.
    this.#observer.unobserve(free);
    this.#observer.observe(free);
  }

  #read(): void {
    const { room, free } = this.#tree;
    this.box = rectOf(free, room.offsetLeft, room.offsetTop);
    const { left, top } = this.box;
    this.fontSize = parseFloat(getComputedStyle(this.#em).fontSize);
    const boxes = free.querySelectorAll<HTMLElement>(':scope > * > *');
    this.boxes = Array.from(boxes, (box) => rectOf(box, left, top));
  }
}

/** `x` and `y`: of what holds the box. */
function rectOf(box: HTMLElement, x: number, y: number): Rect {
  const [left, top] = [x + box.offsetLeft, y + box.offsetTop];
  return { left, top, right: left + box.offsetWidth, bottom: top + box.offsetHeight };
}
