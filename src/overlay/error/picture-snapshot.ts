// What a picture's error is measured against: the scene at the picture's size, and copies of the lights that it is
// drawn with: the code of the measurement may still have to be fetched, and both change meanwhile.
import type { LightValues } from '../../light/light-state.js';
import type { SceneSnapshot } from '../../scene/snapshot/scene-snapshot.js';
import type { Viewport } from '../../scene/viewport.js';

export interface PictureSnapshot {
  readonly scene: SceneSnapshot;
  readonly lights: readonly Readonly<LightValues>[];
}

/** Sizes in pixels. `lights` are those that the picture is drawn with. */
export function snapshotOf(
  viewport: Pick<Viewport, 'snapshot'>,
  { width, height }: { readonly width: number; readonly height: number },
  lights: readonly Readonly<LightValues>[],
): PictureSnapshot {
  const scene = viewport.snapshot(() => true);
  const { camera } = scene;
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  return { scene: { ...scene, width, height }, lights: lights.map((light) => ({ ...light })) };
}
