// Which lights is a view limited to, and how is that said? `view-light` by name; otherwise the first active light where a view is of one
// light, or all. Knows no programs.
import type { LightState, LightValues } from '../../light/light-state.js';
import type { View } from '../../material/views.js';
import type { ExtraHost } from '../../element/viewer/extras.js';
import { phrase } from '../../element/fields/texts.js';
import { lightName } from '../../element/viewer/viewer-snapshot.js';

/** Views of a number that every light has its own of. */
const OF_ONE_LIGHT: ReadonlySet<View> = new Set(['n-dot-l', 'r-dot-v', 'attenuation', 'decay']);

/** Views that no light has a part in. */
const OF_NO_LIGHT: ReadonlySet<View> = new Set(['normals', 'triangles']);

/** Indices of the viewer's lights. An unknown name is ignored. */
export function chosenIndices({ values, viewport, children, viewer }: ExtraHost): number[] {
  const { lights } = viewport.lighting.lights;
  const { view, viewLight } = values;
  // Lights without a name have an English one, and one by the page's texts.
  const isNamed = (state: LightState, i: number): boolean =>
    [null, viewer.texts].some((texts) => lightName(children.lightOf(state), state, i, texts) === viewLight);
  const named = viewLight === '' ? -1 : lights.findIndex(isNamed);
  if (named >= 0) return [named];
  if (!OF_ONE_LIGHT.has(view)) return lights.map((_, i) => i);
  const first = lights.findIndex((light) => light.values.active);
  return first < 0 ? [] : [first];
}

/** The values of the lights that the view is limited to. */
export const chosenLights = (host: ExtraHost): Readonly<LightValues>[] =>
  chosenIndices(host).map((i) => host.viewport.lighting.lights.values[i]!);

/** The line under a legend's title; empty where no light has a part in the view. */
export function lightsText(host: ExtraHost): string {
  const { values, viewport, children, viewer } = host;
  if (OF_NO_LIGHT.has(values.view)) return '';
  const { lights } = viewport.lighting.lights;
  const chosen = chosenIndices(host);
  const [index] = chosen;
  const isOne = OF_ONE_LIGHT.has(values.view) || (values.viewLight !== '' && chosen.length === 1);
  if (!isOne) return phrase(viewer.texts, 'all lights');
  if (index === undefined) return phrase(viewer.texts, 'no light is active');
  const state = lights[index]!;
  const light = lightName(children.lightOf(state), state, index, viewer.texts);
  return state.values.active ? light : phrase(viewer.texts, '{light} (not active)', { light });
}
