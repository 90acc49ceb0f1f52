// What a viewer shows, as plain data for the ray caster: its triangles, or the true shapes that they stand for.
import {
  type BufferGeometry,
  ClampToEdgeWrapping,
  type Material,
  Mesh,
  MirroredRepeatWrapping,
  type Texture,
  type Wrapping,
} from 'three';
import { LIGHT_FIELDS, type LightValues, type Vec3 } from 'phong-viewer/core';
import type {
  CastMaterial,
  CastObject,
  CastScene,
  CastShape,
  CastTexture,
  TrueShape,
  Wrap,
} from '../../support/caster/scene.js';
import type { Viewer } from './element-side.js';
import { pictureOf, type ShownMaterial } from './equation-material.js';

type ShownMesh = Mesh<BufferGeometry, Material & ShownMaterial>;

/** `round`: the shape that the viewer's one mesh stands for, in place of its triangles. */
export function castSceneOf(viewer: Viewer, round: TrueShape | null): CastScene {
  const objects: CastObject[] = [];
  for (const mesh of shownMeshes(viewer))
    objects.push({
      shape: round ?? trianglesOf(mesh.geometry),
      matrix: mesh.matrixWorld.toArray(),
      material: materialOf(mesh.material),
    });
  const { eye, target, up, radius } = viewer.camera;
  const back = eye.map((x, i) => (x - target[i]!) / radius) as unknown as Vec3;
  const right: Vec3 = [
    up[1] * back[2] - up[2] * back[1],
    up[2] * back[0] - up[0] * back[2],
    up[0] * back[1] - up[1] * back[0],
  ];
  return { camera: { eye, right, up, back, fov: viewer.fov }, lights: lightsOf(viewer), objects };
}

/** In the order in which they are drawn. */
export function shownMeshes(viewer: Viewer): ShownMesh[] {
  const meshes: ShownMesh[] = [];
  viewer.scene.updateMatrixWorld();
  viewer.scene.traverse((object) => {
    if (object instanceof Mesh) meshes.push(object as ShownMesh);
  });
  return meshes;
}

/** The lights' values without their elements. */
export const lightsOf = (viewer: Viewer): LightValues[] =>
  viewer.lights.map(
    (light) =>
      Object.fromEntries(
        Object.keys(LIGHT_FIELDS).map((key) => [key, Reflect.get(light, key) as unknown]),
      ) as unknown as LightValues,
  );

function trianglesOf({ attributes, index }: BufferGeometry): CastShape {
  const { position, normal, uv } = attributes;
  return {
    kind: 'triangles',
    positions: position!.array,
    normals: normal!.array,
    ...(uv && { uvs: uv.array }),
    ...(index && { index: index.array }),
  };
}

function materialOf({ surface, look }: ShownMaterial): CastMaterial {
  const { ka, kd, ks, shininess } = surface;
  const { baseColor, map } = look;
  return { ka, kd, ks, shininess, baseColor, ...(map && { texture: textureOf(map) }) };
}

function textureOf(texture: Texture): CastTexture {
  const { width, height } = pictureOf(texture);
  const { data } = pictureOf(texture).getContext('2d')!.getImageData(0, 0, width, height);
  const wrap = (mode: Wrapping): Wrap =>
    mode === ClampToEdgeWrapping ? 'clamp' : mode === MirroredRepeatWrapping ? 'mirror' : 'repeat';
  return {
    width,
    height,
    data: new Uint8Array(data),
    wrapS: wrap(texture.wrapS),
    wrapT: wrap(texture.wrapT),
  };
}
