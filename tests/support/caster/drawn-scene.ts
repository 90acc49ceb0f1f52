// What a viewer draws, for the ray caster: its meshes' triangles, its camera and its lights.
import type { Locator } from '@playwright/test';
import { basisOf } from '../../../src/camera/orbit.js';
import type { PhongViewer } from '../../../src/index.js';
import { LIGHT_FIELDS, type LightValues } from '../../../src/light/light-state.js';
import type { CastScene, CastTexture } from './scene.js';

/** What a mesh of a viewer's scene has, and other objects have not. */
interface DrawnMesh {
  readonly geometry: {
    readonly attributes: Readonly<Record<string, { readonly array: Float32Array } | undefined>>;
    readonly index: { readonly array: Uint16Array | Uint32Array };
  };
  readonly material: {
    readonly surface: CastScene['objects'][number]['material'];
    readonly look: { readonly baseColor: readonly [number, number, number] };
  };
}

/**
 * The triangles of the picture that is shown now. Every mesh has an exponent of its own. `texture`: the base colour of
 * all meshes.
 */
export async function drawnScene(viewer: Locator, texture?: CastTexture): Promise<CastScene> {
  const { objects, lights, camera, ...options } = await viewer.evaluate((element: PhongViewer, keys) => {
    const { camera, fov, reflection, terms, colorInterpolation } = element;
    const objects: CastScene['objects'][number][] = [];
    element.scene.traverse((object) => {
      const { geometry, material } = object as unknown as Partial<DrawnMesh>;
      if (geometry === undefined || material === undefined) return;
      const { position, normal, uv } = geometry.attributes;
      objects.push({
        shape: {
          kind: 'triangles',
          positions: position!.array,
          normals: normal!.array,
          ...(uv === undefined ? {} : { uvs: uv.array }),
          index: geometry.index.array,
        },
        matrix: [...object.matrixWorld.elements],
        material: { ...material.surface, baseColor: material.look.baseColor },
      });
    });
    return {
      objects,
      lights: element.lights.map((light) =>
        Object.fromEntries(keys.map((key) => [key, Reflect.get(light, key) as unknown])),
      ),
      camera: { eye: camera.eye, theta: camera.theta, phi: camera.phi, fov },
      reflection,
      terms,
      linear: colorInterpolation === 'linear',
    };
  }, Object.keys(LIGHT_FIELDS));
  const { eye, theta, phi, fov } = camera;
  return {
    ...options,
    camera: { eye, ...basisOf({ theta, phi }), fov },
    lights: lights as unknown as LightValues[],
    objects: objects.map(({ material, ...object }) => ({
      ...object,
      material: texture === undefined ? material : { ...material, texture },
    })),
  };
}
