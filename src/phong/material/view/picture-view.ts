// What a picture shows in place of all lights' shaded colours. Fetched with the first use of `view`
// or `view-light`.
import type { LightValues } from '../../light/light-state.js';
import { packLights, packNothing, type PackSpace } from '../../light/pack-lights.js';
import type { View, PictureView } from '../views.js';
import { type Shows, viewEntry, viewValue } from './view-table.js';
import { Vector4 } from 'three';
import { normalize, transformed, type Vec3 } from '../../math/vector.js';
import quantityText from '../../../../shaders/view_quantity.glsl?raw';
import trianglesText from '../../../../shaders/view_triangles.glsl?raw';
import trianglesVertex from '../../../../shaders/view_triangles.vert.glsl?raw';
import { type Variant, variantOf } from '../program/variant.js';

type Lights = readonly Readonly<LightValues>[];
/**
 * The lights that a view is limited to, of the viewer's, active or not. A quantity takes the first
 * of them.
 */
type Chosen = (lights: Lights) => Lights;

export function pictureView(view: View, chosen: Chosen): PictureView {
  const { shows } = viewEntry(view);
  if (shows.by === 'equation') {
    return {
      term: shows.term,
      separate: false,
      pack: (lights, space, into) => packLights(chosen(lights), space, into),
      program: null,
    };
  }
  const uniforms = quantityUniforms();
  return {
    term: null,
    separate: shows.by === 'triangles',
    pack(lights, space, into) {
      writeQuantityLight(uniforms, chosen(lights)[0], space);
      packNothing(into);
    },
    program: { uniforms, variant: (general) => viewVariant(view, shows, general) },
  };
}

/**
 * The light of a view of one quantity, in shading space; shaders/view_quantity.glsl declares it.
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
  uViewPosition.value.set(...transformed(matrix, ...place, w), w);
  uViewAxis.value.set(...transformed(matrix, ...normalize(light.axis), 0), light.cutoff);
  uViewAttenuation.value.set(...light.attenuation, 1);
}

/** Quantities are not encoded, and the same whether a surface is lit or emits light. */
const DROPPED = ['SHADING_GOURAUD', 'IS_LINEAR', 'IS_UNLIT', 'HAS_EMISSIVE', 'HAS_EMISSIVE_MAP'];

/** What stands in place of surface_color. */
const TEXTS = { quantity: quantityText, triangles: trianglesText };

const made = new Map<string, Variant>();

/**
 * A material's general program with another text for the colour, and without what only colours
 * need.
 */
function viewVariant(
  view: View,
  shows: Exclude<Shows, { by: 'equation' }>,
  general: Variant,
): Variant {
  const key = `${view} ${general.key}`;
  const present = made.get(key);
  if (present !== undefined) return present;
  const defines: Record<string, string> = { ...general.defines };
  for (const name of DROPPED) {
    Reflect.deleteProperty(defines, name);
  }
  // Programs are told apart by their defines.
  defines['VIEW'] = shows.by;
  if (shows.by === 'quantity') {
    defines['VIEW_VALUE'] = viewValue(view);
  }
  const variant = variantOf(defines, TEXTS[shows.by]);
  const vertex = ['#define main shadedMain', variant.vertexShader, '#undef main', trianglesVertex];
  const shown = shows.by === 'quantity' ? variant : { ...variant, vertexShader: vertex.join('\n') };
  made.set(key, shown);
  return shown;
}
