// What a picture shows in place of all lights' shaded colours: one light's, one term's, or a quantity. Fetched with the
// first use of `view` or `view-light`.
import type { LightValues } from '../../light/light-state.js';
import { packLights, packNothing, type PackSpace } from '../../light/pack-lights.js';
import type { View, PictureView } from '../views.js';
import { packCounted } from './count-lights.js';
import { viewEntry } from './view-table.js';
import { type OwnProgram, viewVariant } from './view-variant.js';
import { Vector4 } from 'three';
import { type Mat4, normalize, type Vec3 } from '../../math/vector.js';

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

/**
 * The one light of a view of a single quantity, in shading space. From float64, as packed lights are. Declared in
 * shaders/view_quantity.glsl.
 */
const quantityUniforms = () => ({
  uViewPosition: { value: new Vector4() },
  uViewAxis: { value: new Vector4() },
  uViewAttenuation: { value: new Vector4() },
});

/** Writes the light; without one, or with an inactive one, every quantity is 0. */
function writeQuantityLight(
  into: ReturnType<typeof quantityUniforms>,
  light: Readonly<LightValues> | undefined,
  space: PackSpace,
): void {
  const { uViewPosition, uViewAxis, uViewAttenuation } = into;
  if (light?.active !== true) {
    uViewAttenuation.value.set(1, 0, 0, 0);
    return;
  }
  const matrix = light.space === 'camera' ? space.cameraToShading : space.worldToShading;
  const [x, y, z, w] = light.position;
  const place: Vec3 = w === 0 ? normalize([x, y, z]) : [x, y, z];
  uViewPosition.value.set(...through(matrix, place, w), w);
  uViewAxis.value.set(...through(matrix, normalize(light.axis), 0), light.cutoff);
  uViewAttenuation.value.set(...light.attenuation, 1);
}

const through = (m: Mat4, [x, y, z]: Vec3, w: number): Vec3 => [
  m[0]! * x + m[4]! * y + m[8]! * z + m[12]! * w,
  m[1]! * x + m[5]! * y + m[9]! * z + m[13]! * w,
  m[2]! * x + m[6]! * y + m[10]! * z + m[14]! * w,
];
