// What do a view's colours mean? The title and the scale of its legend, as data. Knows no DOM.
import type { ViewerText } from '../../element/fields/text-list.js';
import { scaleColor } from '../../material/view/scale.js';
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

/** English; `blinn`: highlights are of Blinn's half vector. */
export function titleOf(view: View, blinn: boolean): ViewerText {
  return view === 'r-dot-v' && blinn ? 'N · H' : TITLES[view];
}

const TITLES: Readonly<Record<View, ViewerText>> = {
  shaded: 'Shaded',
  ambient: 'Ambient term',
  diffuse: 'Diffuse term',
  specular: 'Specular term',
  normals: 'Normals',
  'n-dot-l': 'N · L',
  'r-dot-v': 'R · V',
  attenuation: 'Attenuation',
  decay: 'Decay',
  'light-count': 'Lights that add something',
  triangles: 'Triangles',
  error: 'Error in steps of 1/255',
};

/** `most`: the count at the end of the scale of `light-count`, at least 1. */
export function barsOf(view: View, most: number): readonly Bar[] {
  switch (view) {
    case 'n-dot-l':
    case 'r-dot-v':
    case 'attenuation':
    case 'decay':
      return [{ label: '', colors: [BLACK, [255, 255, 255]], fields: false, marks: UNIT_MARKS }];
    case 'normals':
      return (['x', 'y', 'z'] as const).map((label, axis) => ({
        label,
        colors: [BLACK, [axis === 0 ? 255 : 0, axis === 1 ? 255 : 0, axis === 2 ? 255 : 0]],
        fields: false,
        marks: axis < 2 ? [] : ['−1', '0', '1'].map((text, i) => ({ at: i / 2, text })),
      }));
    case 'light-count':
      return [countBar(most)];
    case 'error': {
      const marks = ['0', '0.5', '1', '1.5', `${String(ERROR_END)}+`].map((text, i) => ({ at: i / 4, text }));
      return [{ label: '', colors: SCALE, fields: false, marks }];
    }
    default:
      return [];
  }
}

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
