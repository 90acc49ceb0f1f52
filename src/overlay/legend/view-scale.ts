// The title and the scale of a view's legend, as data.
import type { ViewerText } from '../../element/fields/text-list.js';
import type { ViewerTexts } from '../../element/fields/texts.js';
import { localNumber } from '../../element/page/local-number.js';
import { VIEW_TABLE, type ViewEntry, viewEntry } from '../../material/view/view-table.js';
import type { View } from '../../material/views.js';
import type { Vec3 } from '../../math/vector.js';

/** A bar from its first colour to its last, with marks at places from 0 to 1. Colours are codes of 255. */
export interface Bar {
  /** Beside the bar; empty for none. */
  readonly label: string;
  readonly colors: readonly Vec3[];
  readonly marks: readonly { readonly at: number; readonly text: string }[];
}

const BLACK: Vec3 = [0, 0, 0];
const UNIT_MARKS = ['0', '0.5', '1'].map((text, i) => ({ at: i / 2, text }));

/** The title of a view's legend: a key of `texts`. */
export function viewTitle(view: View, blinn: boolean): ViewerText {
  const { blinnTitle, title }: LegendTitle = VIEW_TABLE[view];
  return (blinn ? blinnTitle : undefined) ?? title;
}

interface LegendTitle {
  readonly title: ViewerText;
  readonly blinnTitle?: ViewerText;
}

export const barsOf = (view: View, texts: ViewerTexts | null): readonly Bar[] =>
  SCALES[viewEntry(view).scale].map((bar) => ({
    ...bar,
    marks: bar.marks.map(({ at, text }) => ({ at, text: localNumber(text, texts) })),
  }));

const GREY: readonly Bar[] = [{ label: '', colors: [BLACK, [255, 255, 255]], marks: UNIT_MARKS }];

const AXES: readonly Bar[] = (['x', 'y', 'z'] as const).map((label, axis) => ({
  label,
  colors: [BLACK, [axis === 0 ? 255 : 0, axis === 1 ? 255 : 0, axis === 2 ? 255 : 0]],
  marks: axis < 2 ? [] : ['−1', '0', '1'].map((text, i) => ({ at: i / 2, text })),
}));

const SCALES: Readonly<Record<ViewEntry['scale'], readonly Bar[]>> = {
  none: [],
  unit: GREY,
  axes: AXES,
};
