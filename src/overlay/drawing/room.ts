// The free rectangle of the layer over the picture, and its text size. The style sheets lay it out (phong-viewer.css,
// and panel.css for the panel). Observers follow them after layout, so that no frame forces one.
import { create } from '../../element/dom.js';
import type { ViewerTree } from '../../element/viewer/template.js';
import type { Box } from './label-layout.js';

export class Room {
  readonly #tree: ViewerTree;
  /** As wide as the text is high. */
  readonly #em: HTMLElement;
  readonly #observer: ResizeObserver;
  #box: Box = { left: 0, top: 0, right: 0, bottom: 0 };
  #fontSize = 0;

  /** `changed` is called when room or text have another size. `part`: of the text, if the page can style it. */
  constructor(tree: ViewerTree, changed: () => void, part?: string) {
    this.#tree = tree;
    this.#em = create('i', {
      class: 'corner',
      'aria-hidden': 'true',
      ...(part === undefined ? {} : { part }),
    });
    this.#em.style.width = '1em';
    tree.layer.prepend(this.#em);
    this.#read();
    this.#observer = new ResizeObserver(() => {
      this.#read();
      changed();
    });
    for (const each of [this.#em, tree.room, tree.free]) this.#observer.observe(each);
  }

  /** CSS pixels of the layer. Without width or height where nothing is free. */
  get box(): Box {
    return this.#box;
  }

  /** CSS pixels, above 0. */
  get fontSize(): number {
    return this.#fontSize;
  }

  dispose(): void {
    this.#observer.disconnect();
    this.#em.remove();
  }

  #read(): void {
    const { room, free } = this.#tree;
    const left = room.offsetLeft + free.offsetLeft;
    const top = room.offsetTop + free.offsetTop;
    this.#box = { left, top, right: left + free.offsetWidth, bottom: top + free.offsetHeight };
    this.#fontSize = parseFloat(getComputedStyle(this.#em).fontSize);
  }
}
