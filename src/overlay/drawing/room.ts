// The free rectangle of the layer over the picture, the boxes in it, and its text size. The style sheets lay it out
// (phong-viewer.css, and panel.css for the panel). Observers follow them after layout, so that no frame forces one.
import { create } from '../../element/dom.js';
import type { ViewerTree } from '../../element/viewer/template.js';
import type { Rect } from './label-layout.js';

interface RoomOptions {
  /** The part of the text, if the page can style it. */
  readonly textPart?: string;
  /** {@link Room.boxes} are wanted. */
  readonly followsBoxes?: boolean;
}

export class Room {
  readonly #tree: ViewerTree;
  /** As wide as the text is high. */
  readonly #em: HTMLElement;
  readonly #observer: ResizeObserver;
  /** Follows what changes the boxes' places but not their sizes. */
  readonly #arrivals: MutationObserver | null;
  #box: Rect = { left: 0, top: 0, right: 0, bottom: 0 };
  #boxes: readonly Rect[] = [];
  #fontSize = 0;

  /** `changed` is called when room, boxes or text have another size or place. */
  constructor(tree: ViewerTree, changed: () => void, { textPart, followsBoxes }: RoomOptions = {}) {
    this.#tree = tree;
    this.#em = create('i', {
      class: 'corner',
      'aria-hidden': 'true',
      ...(textPart === undefined ? {} : { part: textPart }),
    });
    this.#em.style.width = '1em';
    tree.layer.prepend(this.#em);
    this.#read();
    this.#observer = new ResizeObserver(() => {
      this.#read();
      changed();
    });
    for (const each of [this.#em, tree.room, tree.free]) this.#observer.observe(each);
    this.#arrivals = followsBoxes === true ? new MutationObserver(this.#observeBoxes) : null;
    this.#observeBoxes();
  }

  /** CSS pixels of the layer. Without width or height where nothing is free. */
  get box(): Rect {
    return this.#box;
  }

  /** The legend and the probe's table, where they are followed. CSS pixels of the layer. */
  get boxes(): readonly Rect[] {
    return this.#boxes;
  }

  /** CSS pixels, above 0. */
  get fontSize(): number {
    return this.#fontSize;
  }

  dispose(): void {
    this.#observer.disconnect();
    this.#arrivals?.disconnect();
    this.#em.remove();
  }

  /** Each extra has a place in the free part, which holds its box. */
  readonly #observeBoxes = (): void => {
    const { free } = this.#tree;
    this.#arrivals?.observe(free, { childList: true });
    for (const place of this.#arrivals === null ? [] : free.children) {
      this.#arrivals?.observe(place, { childList: true });
      for (const box of place.children) {
        this.#arrivals?.observe(box, { attributeFilter: ['class', 'hidden'] });
        this.#observer.observe(box);
      }
    }
    // Observed anew, it is reported after the next layout.
    this.#observer.unobserve(free);
    this.#observer.observe(free);
  };

  #read(): void {
    const { room, free } = this.#tree;
    const left = room.offsetLeft + free.offsetLeft;
    const top = room.offsetTop + free.offsetTop;
    this.#box = { left, top, right: left + free.offsetWidth, bottom: top + free.offsetHeight };
    this.#fontSize = parseFloat(getComputedStyle(this.#em).fontSize);
    if (this.#arrivals === null) return;
    const boxes = free.querySelectorAll<HTMLElement>(':scope > * > *');
    this.#boxes = Array.from(boxes, (box) => {
      const [x, y] = [left + box.offsetLeft, top + box.offsetTop];
      return { left: x, top: y, right: x + box.offsetWidth, bottom: y + box.offsetHeight };
    });
  }
}
