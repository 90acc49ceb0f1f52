// Places of the dividers between viewers that lie over each other, in percent from the start, ascending. Plain
// functions of numbers.

/**
 * The places of `count` − 1 dividers. Those that `at` leaves out divide the rest evenly; more than there are dividers
 * are ignored.
 */
export function placesOf(at: readonly number[] | 'auto', count: number): readonly number[] {
  const dividers = Math.max(count - 1, 0);
  const given = at === 'auto' ? [] : at.slice(0, dividers);
  const from = given.at(-1) ?? 0;
  const parts = count - given.length;
  const rest = Array.from({ length: dividers - given.length }, (_, i) => from + ((100 - from) * (i + 1)) / parts);
  return [...given, ...rest];
}

/** How far a divider can move: to its neighbours. */
export const rangeOf = (places: readonly number[], index: number): readonly [min: number, max: number] => [
  places[index - 1] ?? 0,
  places[index + 1] ?? 100,
];

/** The places with one divider moved as near to `place` as its neighbours let it. */
export function withMoved(places: readonly number[], index: number, place: number): readonly number[] {
  const [min, max] = rangeOf(places, index);
  return places.map((each, i) => (i === index ? Math.min(Math.max(place, min), max) : each));
}

/** Percent that a key moves a divider by; `'min'` and `'max'`: all the way. Undefined for other keys. */
export function dividerStep(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  vertical: boolean,
  rtl: boolean,
): number | 'min' | 'max' | undefined {
  const [back, forth] = vertical
    ? ['ArrowUp', 'ArrowDown']
    : rtl
      ? ['ArrowRight', 'ArrowLeft']
      : ['ArrowLeft', 'ArrowRight'];
  const step = shiftKey ? LARGE_STEP : STEP;
  const steps: Readonly<Record<string, number | 'min' | 'max'>> = {
    [back]: -step,
    [forth]: step,
    PageUp: -LARGE_STEP,
    PageDown: LARGE_STEP,
    Home: 'min',
    End: 'max',
  };
  return steps[key];
}

/** Percent. As sliders of browsers and of ARIA's authoring practices step. */
const STEP = 1;
const LARGE_STEP = 10;
