// The lights that `view` and `view-light` limit a picture to.
import { clipMessage, listed } from '../../fields/clip.js';
import type { LightValues } from '../../light/light-state.js';
import type { View } from '../views.js';
import { viewEntry } from './view-table.js';

/**
 * Indices of the lights: `view-light` by name, without it the first active light where a view is of
 * one light, or all. None if no light has the name: the view is black.
 */
export function chosenLights<L extends { readonly values: Pick<LightValues, 'active'> }>(
  { view, viewLight }: { readonly view: View; readonly viewLight: string },
  lights: readonly L[],
  isNamed: (light: L, index: number) => boolean,
): number[] {
  if (viewLight === '' && viewEntry(view).lights !== 'one') return lights.map((_, i) => i);
  const index = lights.findIndex(viewLight === '' ? ({ values }) => values.active : isNamed);
  return index < 0 ? [] : [index];
}

/** What is wrong with a `view-light` that no light is named, and its cure. */
export const unknownLightText = (viewLight: string, names: readonly string[]): string =>
  clipMessage(
    `<phong-viewer view-light=${JSON.stringify(viewLight)}>: no light has this name, so none is shown. Names of lights: ${listed(names.map((name) => JSON.stringify(name)))}.`,
  );
