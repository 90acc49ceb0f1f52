// The title and the scale of a view's legend, as data.
import type { ViewerText } from '../../element/fields/text-list.js';
import { localNumber } from '../../element/page/local-number.js';
import { scaleColor } from '../../material/view/scale.js';
import { VIEW_TABLE, type ViewEntry, viewEntry } from '../../material/view/view-table.js';
import type { View } from '../../material/views.js';
import type { Vec3 } from '../../math/vector.js';

/** A bar from its first colour to its last, with marks at places from 0 to 1. Colours are codes of 255. */
export interface Bar {
  /** Beside the bar; empty for none. */
  readonly label: string;
  readonly colors: readonly Vec3[];
  /** Each colour is a field of its own, with a mark in its middle; otherwise colours blend. */
  readonly fields: boolean;
  readonly marks: readonly { readonly at: number; readonly text: string }[];
}

const BLACK: Vec3 = [0, 0, 0];
const UNIT_MARKS = ['0', '0.5', '1'].map((text, i) => ({ at: i / 2, text }));

/** The scale's colours from 0 to 1, close enough to be blended in straight lines. */
const SCALE: readonly Vec3[] = Array.from({ length: 17 }, (_, i) => codes(scaleColor(i / 16)));

/** Largest count with a field for each value. Beyond, fields would be narrower than 3 pixels. */
const MOST_FIELDS = 48;

/** Most marks that fit beside each other. */
const MOST_MARKS = 8;

/** Differences of this many codes of 255, and larger ones, have the error scale's last colour. */
export const ERROR_END = 2;

/** The title of a view's legend: a key of `texts`. */
export function titleOf(view: View, blinn: boolean): ViewerText {
  const { blinnTitle, title }: LegendTitle = VIEW_TABLE[view];
  return (blinn ? blinnTitle : undefined) ?? title;
}

interface LegendTitle {
  readonly title: ViewerText;
  readonly blinnTitle?: ViewerText;
}

/** `most`: the count at the end of the scale of `light-count`, at least 1. */
export const barsOf = (view: View, most: number): readonly Bar[] =>
  SCALES[viewEntry(view).scale](most).map((bar) => ({
    ...bar,
    marks: bar.marks.map(({ at, text }) => ({ at, text: localNumber(text) })),
  }));

const GREY: readonly Bar[] = [
  { label: '', colors: [BLACK, [255, 255, 255]], fields: false, marks: UNIT_MARKS },
];

const AXES: readonly Bar[] = (['x', 'y', 'z'] as const).map((label, axis) => ({
  label,
  colors: [BLACK, [axis === 0 ? 255 : 0, axis === 1 ? 255 : 0, axis === 2 ? 255 : 0]],
  fields: false,
  marks: axis < 2 ? [] : ['−1', '0', '1'].map((text, i) => ({ at: i / 2, text })),
}));

const ERROR_MARKS = ['0', '0.5', '1', '1.5', `${String(ERROR_END)}+`].map((text, i) => ({ at: i / 4, text }));

const SCALES: Readonly<Record<ViewEntry['scale'], (most: number) => readonly Bar[]>> = {
  none: () => [],
  unit: () => GREY,
  axes: () => AXES,
  count: (most) => [countBar(most)],
  error: () => [{ label: '', colors: SCALE, fields: false, marks: ERROR_MARKS }],
};

function countBar(most: number): Bar {
  const fields = most < MOST_FIELDS;
  const step = roundStep(most / (MOST_MARKS - 1));
  const counts = Array.from({ length: Math.floor(most / step) + 1 }, (_, i) => i * step);
  // The last one is the scale's end; one right before it would touch it.
  if (most - counts.at(-1)! < step / 2 && counts.length > 1) counts.pop();
  if (counts.at(-1) !== most) counts.push(most);
  return {
    label: '',
    colors: fields ? Array.from({ length: most + 1 }, (_, i) => codes(scaleColor(i / most))) : SCALE,
    fields,
    marks: counts.map((count) => ({
      at: fields ? (count + 0.5) / (most + 1) : count / most,
      text: String(count),
    })),
  };
}

function codes([r, g, b]: Vec3): Vec3 {
  return [Math.round(r * 255), Math.round(g * 255), Math.round(b * 255)];
}

/** The next of 1, 2, 5, 10, 20 and so on. */
function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(least, 1)));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= least)!;
}
