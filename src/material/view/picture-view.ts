// What a picture shows in place of all lights' shaded colours: one light's, one term's, or a quantity. Fetched with the
// first use of `view` or `view-light`.
import type { LightValues } from '../../light/light-state.js';
import { packLights, packNothing } from '../../light/pack-lights.js';
import type { View } from '../views.js';
import type { PictureView } from '../picture-view.js';
import { packCounted } from './count-lights.js';
import { quantityUniforms, writeQuantityLight } from './quantity-light.js';
import { viewEntry } from './view-table.js';
import { type OwnProgram, viewVariant } from './view-variant.js';

type Lights = readonly Readonly<LightValues>[];
/** The lights that a view is limited to, of the viewer's, active or not. A quantity takes the first of them. */
type Chosen = (lights: Lights) => Lights;

export function pictureView(view: View, chosen: Chosen): PictureView {
  const { shows } = viewEntry(view);
  if (shows.by !== 'equation') return ownView(shows, chosen);
  return {
    term: shows.term,
    separate: false,
    pack(lights, space, into) {
      packLights(chosen(lights), space, into);
    },
    program: null,
  };
}

function ownView(shows: OwnProgram, chosen: Chosen): PictureView {
  const quantity = quantityUniforms();
  const uViewLights = { value: 1 };
  const uViewOpen = { value: 0 };
  const counts = shows.by === 'count';
  return {
    term: null,
    separate: shows.by === 'triangles',
    pack(lights, space, into) {
      const all = chosen(lights);
      if (counts) {
        uViewLights.value = scaleEnd(all);
        uViewOpen.value = packCounted(all, space, into);
      } else {
        writeQuantityLight(quantity, all[0], space);
        packNothing(into);
      }
    },
    program: {
      uniforms: { ...quantity, uViewLights, uViewOpen },
      usesGrid: counts,
      variant: (general, grid) => viewVariant(shows, general, grid),
    },
  };
}

/** The count at the end of the scale: all active lights. */
export const scaleEnd = (lights: Lights): number => Math.max(lights.filter(({ active }) => active).length, 1);
