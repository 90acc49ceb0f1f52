// A row for a colour: a picker, text as in HTML (`200 80 60`, `#c85`, `orange`), and a slider for
// its brightness. 255 is full, more is brighter.
import type { GUI } from 'lil-gui';
import { cssColor, type ViewerText } from '../../viewer/extra.js';
import { sameValue } from '../../phong/fields/field-store.js';
import { LIGHT_FIELDS, LIMITS } from '../../phong/light/light-state.js';
import { clamp, map, type Vec3 } from '../../phong/math/vector.js';
import { accepted, bound, type Bound } from './bound.js';
import { InputRow, nameInput, TextField } from './input-row.js';
import { explain } from './label.js';
import { Slider } from './number-controls.js';
import { linear, numberText } from './travel.js';
import { parseText } from '../../phong/fields/attribute-text.js';

const COLOR = LIGHT_FIELDS.diffuse;

/** `usual`: the end of the brightness slider; 1 is 255. */
export function addColor(folder: GUI, value: Bound<Vec3>, name: ViewerText, usual: number): void {
  const mix = new ColorMix();
  const picker = document.createElement('input');
  picker.type = 'color';
  picker.addEventListener(
    'input',
    () => (value.value = mix.recolor(value.value, colorOf(picker.value))),
  );
  const updatePicker = (): void => {
    const hex = hexOf(mix.split(value.value).color);
    if (picker.value !== hex) {
      picker.value = hex;
    }
  };
  /** Text that the user typed, shown while the value stays the same. */
  let typed: { readonly text: string; readonly value: Vec3 } | null = null;
  const field = new TextField(
    () =>
      typed !== null && sameValue(typed.value, value.value)
        ? typed.text
        : value.value.map((channel) => numberText(channel)).join(' '),
    (text) =>
      accepted(() => {
        value.value = COLOR.check(parseText(text, COLOR, cssColor));
        typed = { text: text.trim(), value: value.value };
      }),
  );
  const brightness = bound(
    () => brightnessOf(value.value),
    (factor) => (value.value = mix.brighten(value.value, factor)),
  );
  const scale = linear(0, usual, 0.01);
  const slider = new Slider(brightness, () => scale);
  new InputRow(folder, value, 'color', name, [
    { input: picker, update: updatePicker },
    field,
    slider,
  ]);
  nameInput(picker, (say) => say('{color} picker', { color: say(name) }));
  nameInput(slider.input, (say) => say('{color} brightness', { color: say(name) }));
  explain(field.input, 'r g b, #rgb or a name; 255 is full');
}

interface Tint {
  /** 0–255 per channel, not rounded. */
  readonly color: Vec3;
  /**
   * 1, or more for values that are brighter than the picker can show. Colour times factor is the
   * value.
   */
  readonly factor: number;
}

const WHITE: Vec3 = [255, 255, 255];

export class ColorMix {
  #picked: Tint | null = null;
  #hue: Vec3 = WHITE;

  /**
   * Splits a value the way it was picked here, or with the smallest factor if it came from
   * elsewhere.
   */
  split(value: Vec3): Tint {
    if (this.#picked !== null && sameValue(times(this.#picked.color, this.#picked.factor), value)) {
      return this.#picked;
    }
    const factor = Math.max(brightnessOf(value), 1);
    return { color: map(value, (c) => c / factor), factor };
  }

  /**
   * The value after picking a colour: the colour itself, or times the factor of a value above 255.
   */
  recolor(value: Vec3, color: Vec3): Vec3 {
    this.#picked = { color, factor: this.split(value).factor };
    return times(color, this.#picked.factor);
  }

  /**
   * The value with another brightness and the same hue, also after it was black; white if it has
   * always been black.
   */
  brighten(value: Vec3, brightness: number): Vec3 {
    if (brightnessOf(value) > 0) {
      this.#hue = value;
    }
    return times(this.#hue, brightness / brightnessOf(this.#hue));
  }
}

/** The largest channel; 1 is 255. */
export const brightnessOf = (value: Vec3): number => Math.max(...value) / 255;

/** Rounded to six digits: finer than any screen, and short in markup. Factor 1 changes nothing. */
function times(color: Vec3, factor: number): Vec3 {
  if (factor === 1) return color;
  return map(color, (c) => Math.min(Number((c * factor).toPrecision(6)), LIMITS.color));
}

/** `#rrggbb`, channels rounded and clamped. */
export function hexOf(color: Vec3): string {
  const digits = color.map((c) =>
    Math.round(clamp(c, 0, 255))
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${digits.join('')}`;
}

export const colorOf = (hex: string): Vec3 =>
  map([1, 3, 5], (at) => parseInt(hex.slice(at, at + 2), 16));
