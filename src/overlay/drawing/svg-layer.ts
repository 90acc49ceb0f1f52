// Shows a display list on the page as SVG, which is crisp at any resolution and zoom. Elements are kept from list to
// list, and only what differs is written.
import { createSvg, set, write } from '../../element/dom.js';
import { DASHES, labelFont, outlineOf, type DrawnItem } from './display-list.js';
import { HALO } from './contrast.js';
import type { Point } from './projection.js';

const TAGS = { stroke: ['path', 'path'], disc: ['circle', 'circle'], label: ['text'] } as const;

interface DrawnPrimitive {
  readonly primitive: DrawnItem;
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
  #shown: DrawnPrimitive[] = [];

  /** Labels are as large as the text around it. */
  constructor() {
    this.element.style.font = labelFont('1em');
  }

  /**
   * What is shown belongs to a picture of this size, CSS pixels. On paper, which is laid out without scripts, both are
   * scaled alike.
   */
  over({ width, height }: { readonly width: number; readonly height: number }): void {
    set(this.element, { viewBox: `0 0 ${String(width)} ${String(height)}` });
  }

  /**
   * Shows exactly this. A shape that is the same object as before at its place in the list, or an equal label, costs
   * nothing.
   */
  show(list: readonly DrawnItem[]): void {
    list.forEach((primitive, i) => {
      const shown = this.#shown[i];
      if (shown !== undefined && isSame(shown.primitive, primitive)) return;
      const elements = shown?.primitive.kind === primitive.kind ? shown.elements : this.#replace(shown, primitive.kind);
      this.#shown[i] = { primitive, elements };
      draw(elements, primitive);
    });
    for (const { elements } of this.#shown.splice(list.length)) for (const each of elements) each.remove();
  }

  #replace(shown: DrawnPrimitive | undefined, kind: DrawnItem['kind']): readonly SVGElement[] {
    const tags = TAGS[kind];
    const elements = tags.map((tag) => createSvg(tag));
    const [first] = shown?.elements ?? [];
    if (first === undefined) this.element.append(...elements);
    else {
      first.before(...elements);
      for (const each of shown?.elements ?? []) each.remove();
    }
    return elements;
  }
}

/** Labels are placed again for each list, but few of them move. */
const isSame = (a: DrawnItem, b: DrawnItem): boolean =>
  a === b || (a.kind === 'label' && JSON.stringify(a) === JSON.stringify(b));

function draw(elements: readonly SVGElement[], primitive: DrawnItem): void {
  const opacity = String(primitive.opacity ?? 1);
  const [halo, core] = elements;
  if (halo === undefined) return;
  if (primitive.kind === 'label') {
    const { at, text, color, part = null } = primitive;
    set(halo, {
      part,
      x: round(at.x),
      y: round(at.y),
      fill: color,
      stroke: HALO,
      'stroke-width': '3',
      opacity,
    });
    // As attributes: a style attribute is text that a strict CSP refuses.
    set(halo, { 'paint-order': 'stroke', 'stroke-linejoin': 'round' });
    write(halo, text);
    return;
  }
  const { color, width } = primitive;
  const dashes = primitive.dashed === true ? DASHES.join(' ') : 'none';
  const line = { 'stroke-linejoin': 'round', 'stroke-dasharray': dashes, opacity };
  const shape =
    primitive.kind === 'disc'
      ? { cx: round(primitive.center.x), cy: round(primitive.center.y), r: round(primitive.radius) }
      : { d: pathOf(primitive.lines, primitive.filled === true) };
  const filled = primitive.kind === 'stroke' && primitive.filled === true;
  const inner = primitive.kind === 'disc' ? (primitive.fill ?? 'none') : filled ? color : 'none';
  set(halo, {
    ...shape,
    ...line,
    fill: 'none',
    stroke: HALO,
    'stroke-width': String(width + 2 * outlineOf(primitive)),
  });
  if (core !== undefined)
    set(core, {
      ...shape,
      ...line,
      fill: inner,
      stroke: filled ? 'none' : color,
      'stroke-width': String(width),
    });
}

const pathOf = (lines: readonly (readonly Point[])[], closed: boolean): string =>
  lines.map((line) => `M${line.map(({ x, y }) => `${round(x)} ${round(y)}`).join('L')}${closed ? 'Z' : ''}`).join('');

/** A hundredth of a pixel is less than any screen shows. */
const round = (value: number): string => String(Math.round(100 * value) / 100);
