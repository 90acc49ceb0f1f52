// Makes what a picture shows in place of all lights' shaded colours: one light's, one term's, or a quantity. Fetched with the first use of
// `view` or `view-light`. Knows neither elements nor legends.
import type { LightValues } from '../../light/light-state.js';
import { TERMS } from '../shading-style.js';
import type { PictureView, View } from '../views.js';
import { countLights } from './count-lights.js';
import { quantityUniforms, writeQuantityLight } from './quantity-light.js';
import { isDrawnView, viewVariant } from './view-variant.js';

type Lights = readonly Readonly<LightValues>[];

/** `chosen` gives those of the viewer's lights that the view is limited to, active or not. A quantity takes the first of them. */
export function pictureView(view: View, chosen: (lights: Lights) => Lights): PictureView {
  const term = TERMS.find((name) => name === view) ?? null;
  // The error is measured from the shaded picture.
  if (!isDrawnView(view)) return { term, separate: false, lights: chosen, choose: null };
  const quantity = quantityUniforms();
  const uViewLights = { value: 1 };
  const uViewOpen = { value: 0 };
  const own = { ...quantity, uViewLights, uViewOpen };
  const counts = view === 'light-count';
  return {
    term,
    separate: view === 'triangles',
    lights(lights, space) {
      const all = chosen(lights);
      if (!counts) writeQuantityLight(quantity, all[0], space);
      if (!counts) return [];
      uViewLights.value = scaleEnd(all);
      const counted = countLights(all, space);
      uViewOpen.value = counted.open;
      return counted.lights;
    },
    choose(programs, lighting, mesh, uniforms) {
      Object.assign(uniforms, own);
      const general = programs.general(0);
      const grid = counts ? lighting.gridOf(mesh) : null;
      return { variant: viewVariant(view, general, grid !== null), lights: grid ?? lighting.lightsOf(mesh) };
    },
  };
}

/** The count at the end of the scale: all active lights. */
export const scaleEnd = (lights: Lights): number => Math.max(lights.filter(({ active }) => active).length, 1);
