// Shows a display list on the page as SVG, which is crisp at any resolution and zoom. Elements are
// kept from list to list, and only what differs is written.
import { coreOf, DASHES, type DrawnItem, HALO, haloWidth, labelFont } from './display-list.js';
import type { Point } from './projection.js';
import { createSvg, set, write } from './dom.js';

const TAGS = { stroke: ['path', 'path'], disc: ['circle', 'circle'], label: ['text'] } as const;

interface ShownItem {
  readonly item: DrawnItem;
  /** The outline first. */
  readonly elements: readonly SVGElement[];
}

export class SvgLayer {
  readonly element = createSvg('svg', {
    width: '100%',
    height: '100%',
    'aria-hidden': 'true',
    focusable: 'false',
  });
  #shown: ShownItem[] = [];

  /** Labels are as large as the text around it. */
  constructor() {
    this.element.style.font = labelFont('1em');
  }

  /**
   * The picture's size, CSS pixels. On paper, which is laid out without scripts, both are scaled
   * alike.
   */
  over({ width, height }: { readonly width: number; readonly height: number }): void {
    set(this.element, { viewBox: `0 0 ${String(width)} ${String(height)}` });
  }

  /**
   * Shows exactly this. What is the same object as before at its place in the list costs nothing.
   */
  show(list: readonly DrawnItem[]): void {
    list.forEach((item, i) => {
      const shown = this.#shown[i];
      if (shown?.item === item) return;
      const elements =
        shown?.item.kind === item.kind ? shown.elements : this.#add(item.kind, shown?.elements);
      this.#shown[i] = { item, elements };
      draw(elements, item);
    });
    for (const { elements } of this.#shown.splice(list.length)) {
      for (const each of elements) {
        each.remove();
      }
    }
  }

  #add(kind: DrawnItem['kind'], replaced: readonly SVGElement[] = []): readonly SVGElement[] {
    const elements = TAGS[kind].map((tag) => createSvg(tag));
    if (replaced[0] === undefined) {
      this.element.append(...elements);
    } else {
      replaced[0].before(...elements);
    }
    for (const each of replaced) {
      each.remove();
    }
    return elements;
  }
}

function draw([halo, core]: readonly SVGElement[], item: DrawnItem): void {
  const opacity = String(item.opacity ?? 1);
  if (item.kind === 'label') {
    const { at, text, color, part = null } = item;
    const place = { part, x: round(at.x), y: round(at.y), fill: color, opacity };
    // As attributes: a style attribute is text that a strict CSP refuses.
    const outline = {
      stroke: HALO,
      'stroke-width': '3',
      'paint-order': 'stroke',
      'stroke-linejoin': 'round',
    };
    write(set(halo!, { ...place, ...outline }), text);
    return;
  }
  const place =
    item.kind === 'disc'
      ? { cx: round(item.center.x), cy: round(item.center.y), r: round(item.radius) }
      : { d: pathOf(item.lines, item.filled === true) };
  const shape = {
    ...place,
    'stroke-linejoin': 'round',
    'stroke-dasharray': item.dashed === true ? DASHES.join(' ') : 'none',
    opacity,
  };
  const { fill, stroke } = coreOf(item);
  set(halo!, { ...shape, fill: 'none', stroke: HALO, 'stroke-width': String(haloWidth(item)) });
  set(core!, {
    ...shape,
    fill: fill ?? 'none',
    stroke: stroke ?? 'none',
    'stroke-width': String(item.width),
  });
}

const pathOf = (lines: readonly (readonly Point[])[], closed: boolean): string =>
  lines
    .map(
      (line) =>
        `M${line.map(({ x, y }) => `${round(x)} ${round(y)}`).join('L')}${closed ? 'Z' : ''}`,
    )
    .join('');

/** A hundredth of a pixel is less than any screen shows. */
const round = (value: number): string => String(Math.round(100 * value) / 100);
