// Shows a display list on the page as SVG, which is crisp at any resolution and zoom. Elements are
// kept from list to list, and only what differs is written.
import { coreOf, DASHES, type DrawnItem, HALO, haloWidth, labelFont } from './display-list.js';
import type { Point } from './projection.js';
import { createSvg, set, write } from './dom.js';

const TAGS = { stroke: ['path', 'path'], disc: ['circle', 'circle'], label: ['text'] } as const;

interface ShownItem {
  readonly item: DrawnItem;
  /**
   * Holds the elements, the outline first. It moves its disc or label: a text that itself has
   * another place is laid out and painted again, 0.04 ms for each name in each frame (H200).
   */
  readonly group: SVGGElement;
}

export class SvgLayer {
  readonly element = createSvg('svg', {
    width: '100%',
    height: '100%',
    'aria-hidden': 'true',
    focusable: 'false',
    'stroke-linejoin': 'round',
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
      const group =
        shown?.item.kind === item.kind ? shown.group : this.#add(item.kind, shown?.group);
      this.#shown[i] = { item, group };
      draw(group, item);
    });
    for (const { group } of this.#shown.splice(list.length)) {
      group.remove();
    }
  }

  #add(kind: DrawnItem['kind'], replaced?: SVGGElement): SVGGElement {
    const group = createSvg('g');
    group.append(...TAGS[kind].map((tag) => createSvg(tag)));
    this.element.insertBefore(group, replaced ?? null);
    replaced?.remove();
    return group;
  }
}

function draw(group: SVGGElement, item: DrawnItem): void {
  const [halo, core] = group.children;
  const opacity = String(item.opacity ?? 1);
  if (item.kind === 'label') {
    const { at, text, color, part = null } = item;
    moveTo(group, at);
    // As attributes: a style attribute is text that a strict CSP refuses.
    const outline = { stroke: HALO, 'stroke-width': '3', 'paint-order': 'stroke' };
    write(set(halo!, { part, fill: color, opacity, ...outline }), text);
    return;
  }
  if (item.kind === 'disc') {
    moveTo(group, item.center);
  }
  const shape = {
    ...(item.kind === 'disc'
      ? { r: round(item.radius) }
      : { d: pathOf(item.lines, item.filled === true) }),
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

const moveTo = (group: SVGGElement, { x, y }: Point): unknown =>
  set(group, { transform: `translate(${round(x)} ${round(y)})` });

const pathOf = (lines: readonly (readonly Point[])[], closed: boolean): string =>
  lines
    .map(
      (line) =>
        `M${line.map(({ x, y }) => `${round(x)} ${round(y)}`).join('L')}${closed ? 'Z' : ''}`,
    )
    .join('');

/** A hundredth of a pixel is less than any screen shows. */
const round = (value: number): string => String(Math.round(100 * value) / 100);
