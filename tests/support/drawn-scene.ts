// What a viewer draws, for the ray caster: its meshes' triangles, its camera and its lights.
import type { Vec3 } from '../../src/phong/math/vector.js';
import type { Locator } from '@playwright/test';
import { basisOf } from '../../src/phong/camera/orbit.js';
import type { PhongViewer } from '../../src/viewer/index.js';
import { LIGHT_FIELDS, type LightValues } from '../../src/phong/light/light-state.js';
import type { CastScene, CastTexture } from '../../src/extras/still/cast-scene.js';

/** What a mesh of a viewer's scene has, and other objects have not. */
interface DrawnMesh {
  readonly geometry: {
    readonly attributes: Readonly<Record<string, { readonly array: Float32Array } | undefined>>;
    readonly index: { readonly array: Uint16Array | Uint32Array } | null;
  };
  readonly material: {
    readonly surface: CastScene['objects'][number]['material'];
    readonly look: { readonly baseColor: Vec3 };
  };
}

/**
 * What a viewer shows now, but for textures. Runs in its page, by itself; `lightKeys` are those of
 * LIGHT_FIELDS.
 */
function shownIn(element: PhongViewer, lightKeys: readonly string[]) {
  const { fov, reflection, terms, colorInterpolation } = element;
  const { eye, theta, phi } = element.camera;
  const objects: CastScene['objects'][number][] = [];
  element.scene.updateMatrixWorld();
  element.scene.traverse((object) => {
    const { geometry, material } = object as unknown as Partial<DrawnMesh>;
    if (geometry === undefined || material === undefined) return;
    const { position, normal, uv } = geometry.attributes;
    objects.push({
      shape: {
        positions: position!.array,
        normals: normal!.array,
        ...(uv && { uvs: [uv.array] }),
        ...(geometry.index && { index: geometry.index.array }),
      },
      matrix: [...object.matrixWorld.elements],
      material: { ...material.surface, baseColor: material.look.baseColor },
    });
  });
  const lights = element.lights.map((light) =>
    Object.fromEntries(lightKeys.map((key) => [key, Reflect.get(light, key) as unknown])),
  );
  const linear = colorInterpolation === 'linear';
  return { camera: { eye, theta, phi, fov }, lights, objects, reflection, terms, linear };
}

const LIGHT_KEYS = Object.keys(LIGHT_FIELDS);

const castScene = ({ camera, lights, ...shown }: ReturnType<typeof shownIn>): CastScene => {
  const { eye, theta, phi, fov } = camera;
  return {
    ...shown,
    camera: { eye, ...basisOf({ theta, phi }), fov },
    lights: lights as unknown as LightValues[],
  };
};

/**
 * For a script of the viewer's own page: the triangles of the picture that is shown now, without
 * textures.
 */
export const sceneOnPage = (viewer: PhongViewer): CastScene =>
  castScene(shownIn(viewer, LIGHT_KEYS));

/**
 * The triangles of the picture that is shown now. Every mesh has an exponent of its own. `texture`:
 * the base colour of all meshes.
 */
export async function drawnScene(viewer: Locator, texture?: CastTexture): Promise<CastScene> {
  const { objects, ...scene } = castScene(await viewer.evaluate(shownIn, LIGHT_KEYS));
  return {
    ...scene,
    objects: objects.map(({ material, ...object }) => ({
      ...object,
      material: texture === undefined ? material : { ...material, texture },
    })),
  };
}
