// The lights that a view is limited to, and the text that says so. `view-light` by name; without it the first active
// light where a view is of one light, or all.
import { clipMessage, listed } from '../../fields/clip.js';
import type { LightState, LightValues } from '../../light/light-state.js';
import { viewEntry } from '../../material/view/view-table.js';
import type { ExtraHost } from '../../element/viewer/extra.js';
import { phrase } from '../../element/fields/texts.js';
import { lightName } from '../../element/viewer/viewer-snapshot.js';

/** Index of the light that `view-light` names; -1 if it is empty or no light has this name. */
function namedIndex({ values, viewport, children, viewer }: ExtraHost): number {
  const { viewLight } = values;
  // Lights without a name have an English one, and one by the page's texts.
  const isNamed = (state: LightState, i: number): boolean =>
    [null, viewer.texts].some((texts) => lightName(children.lightOf(state), state, i, texts) === viewLight);
  return viewLight === '' ? -1 : viewport.picture.lighting.lights.lights.findIndex(isNamed);
}

/** Indices of the viewer's lights. None if `view-light` names no light: the view is black. */
function chosenIndices(host: ExtraHost): number[] {
  const { lights } = host.viewport.picture.lighting.lights;
  const { view, viewLight } = host.values;
  const named = namedIndex(host);
  if (viewLight !== '') return named < 0 ? [] : [named];
  if (viewEntry(view).lights !== 'one') return lights.map((_, i) => i);
  const first = lights.findIndex((light) => light.values.active);
  return first < 0 ? [] : [first];
}

/** The values of the lights that the view is limited to. */
export const chosenLights = (host: ExtraHost): Readonly<LightValues>[] =>
  chosenIndices(host).map((i) => host.viewport.picture.lighting.lights.values[i]!);

/** The line under a legend's title; empty where no light has a part in the view. */
export function chosenLightsText(host: ExtraHost): string {
  const { values, viewport, children, viewer } = host;
  const entry = viewEntry(values.view);
  if (entry.lights === 'none') return '';
  const { lights } = viewport.picture.lighting.lights;
  const chosen = chosenIndices(host);
  const [index] = chosen;
  const { viewLight } = values;
  if (viewLight === '' && entry.lights !== 'one') return phrase(viewer.texts, 'all lights');
  if (index === undefined) {
    if (viewLight === '') return phrase(viewer.texts, 'no light is active');
    return phrase(viewer.texts, 'no light has the name {name}', { name: viewLight });
  }
  const state = lights[index]!;
  const light = lightName(children.lightOf(state), state, index, viewer.texts);
  return state.values.active ? light : phrase(viewer.texts, '{light} (not active)', { light });
}

/** What is wrong with `view-light`, and its cure; null where it names a light or is empty. */
export function unknownLightText(host: ExtraHost): string | null {
  const { values, viewport, children } = host;
  if (values.viewLight === '' || namedIndex(host) >= 0) return null;
  const { lights } = viewport.picture.lighting.lights;
  const names = lights.map((state, i) => JSON.stringify(lightName(children.lightOf(state), state, i)));
  const value = JSON.stringify(values.viewLight);
  return clipMessage(
    `<phong-viewer view-light=${value}>: no light has this name, so none is shown. Names of lights: ${listed(names)}.`,
  );
}
