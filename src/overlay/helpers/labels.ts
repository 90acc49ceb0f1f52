// Names in the picture, and their places. Places the names of all helpers together, so that none covers another. CSS
// pixels of the layer.
import type { PlacedName } from '../../element/viewer/extra.js';
import type { Label, DrawnItem } from '../drawing/display-list.js';
import { type Rect, labelBox, placeLabels, shortened, textWidth } from '../drawing/label-layout.js';
import type { Point } from '../drawing/projection.js';

export interface Name {
  readonly text: string;
  readonly center: Point;
  /** Around the centre, CSS pixels. */
  readonly gap: number;
  /** Its part on the page. */
  readonly part?: string;
  readonly opacity?: number;
}

/** What some helpers draw. */
export interface Drawing {
  readonly list: readonly DrawnItem[];
  readonly names: readonly Name[];
  /** What names do not cover if they can go elsewhere. */
  readonly covered: readonly Rect[];
}

export const NO_DRAWING: Drawing = { list: [], names: [], covered: [] };

const COLOR = '#fff';

/**
 * One list of several drawings, with their names on top. The first drawings are lowest, and their names come last.
 * Names keep to `room`, outside the boxes in it.
 */
export function listOf(
  drawings: readonly Drawing[],
  room: Rect,
  fontSize: number,
  boxes: readonly Rect[] = [],
): { readonly list: readonly DrawnItem[]; readonly placed: readonly PlacedName[] } {
  const names = [...drawings].reverse().flatMap((each) => each.names);
  const texts = names.map(({ text }) => shortened(text));
  const places = placeLabels(
    names.map(({ center, gap }, i) => ({ center, gap, width: textWidth(texts[i]!, fontSize) })),
    room,
    drawings.flatMap(({ covered }) => covered),
    fontSize,
    boxes,
  );
  const labels = names.flatMap(({ part, opacity = 1 }, i): Label[] => {
    const at = places[i];
    const shown = part === undefined ? {} : { part };
    return at ? [{ kind: 'label', at, text: texts[i]!, color: COLOR, opacity, ...shown }] : [];
  });
  const placed = labels.map(({ at, text }) => ({
    text,
    ...labelBox(at, textWidth(text, fontSize), fontSize),
  }));
  return { list: [...drawings.flatMap(({ list }) => list), ...labels], placed };
}
