// What are the values of a light added by the panel's button? A point light beside the scene, each at a different place. World
// space, scene units. Numbers only.
import type { LightValues } from '../light/light-state.js';
import type { Vec3 } from '../math/vector.js';

/** Points placed around a circle in steps of this angle never come close to one another. */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

/** Dimmer than the default, so that a scene that is lit already does not become white. */
const GREY: Vec3 = [140, 140, 140];

/** `count`: number of lights so far. `reach`: half the range of the sliders around `center`. */
export function newLight(count: number, center: Vec3, reach: number): Partial<LightValues> {
  const angle = GOLDEN_ANGLE * (count + 1);
  const distance = reach / 2;
  const near = (offset: number, middle: number): number =>
    Number((middle + distance * offset).toPrecision(3));
  return {
    position: [
      near(0.8 * Math.sin(angle), center[0]),
      near(0.6, center[1]),
      near(0.8 * Math.cos(angle), center[2]),
      1,
    ],
    diffuse: GREY,
    specular: GREY,
  };
}
