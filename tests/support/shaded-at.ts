// The reference equation where a ray of the caster meets a surface without textures.
import type { CastScene } from '../../src/extras/still/cast-scene.js';
import type { Tracer } from '../../src/extras/still/tracer.js';
import { add, scale } from '../../src/phong/math/vector.js';
import { shade, type Shaded } from '../../src/phong/reference/index.js';

/** At a place in the picture; null where nothing is met. */
export function shadedAt(tracer: Tracer, scene: CastScene, x: number, y: number): Shaded | null {
  const { t, normal: outward, front, object } = tracer.hitAt(x, y);
  if (t === Infinity) return null;
  const { eye } = scene.camera;
  const p = add(eye, scale(tracer.screen.direction(x, y), t));
  const normal = scale(outward, front ? 1 : -1);
  return shade({ p, normal, eye }, scene.objects[object]!.material, scene.lights, scene);
}
