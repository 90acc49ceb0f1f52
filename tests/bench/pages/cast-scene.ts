// What a viewer shows, as plain data for the ray caster: its triangles, or the true shapes that
// they stand for.
import {
  type BufferGeometry,
  ClampToEdgeWrapping,
  type Material,
  Mesh,
  MirroredRepeatWrapping,
  type Texture,
  type Wrapping,
} from 'three';
import { sceneOnPage } from '../../support/drawn-scene.js';
import type {
  CastScene,
  CastTexture,
  CastShape,
  Wrap,
} from '../../../src/extras/still/cast-scene.js';
import type { Viewer } from './element-side.js';
import { pictureOf, type ShownMaterial } from './equation-material.js';

type ShownMesh = Mesh<BufferGeometry, Material & ShownMaterial>;

/** `round`: the shape that the viewer's one mesh stands for, in place of its triangles. */
export function castSceneOf(viewer: Viewer, round: CastShape | null): CastScene {
  const meshes = shownMeshes(viewer);
  const { objects, ...scene } = sceneOnPage(viewer);
  return {
    ...scene,
    objects: objects.map(({ shape, material, ...object }, i) => {
      const { map } = meshes[i]!.material.look;
      return {
        ...object,
        shape: round ?? shape,
        material: map === null ? material : { ...material, texture: textureOf(map) },
      };
    }),
  };
}

/** In the order in which they are drawn. */
export function shownMeshes(viewer: Viewer): ShownMesh[] {
  const meshes: ShownMesh[] = [];
  viewer.scene.updateMatrixWorld();
  viewer.scene.traverse((object) => {
    if (object instanceof Mesh) {
      meshes.push(object as ShownMesh);
    }
  });
  return meshes;
}

function textureOf(texture: Texture): CastTexture {
  const { width, height } = pictureOf(texture);
  const { data } = pictureOf(texture).getContext('2d')!.getImageData(0, 0, width, height);
  const wrap = (mode: Wrapping): Wrap =>
    mode === ClampToEdgeWrapping ? 'clamp' : mode === MirroredRepeatWrapping ? 'mirror' : 'repeat';
  const wraps = { wrapS: wrap(texture.wrapS), wrapT: wrap(texture.wrapT) };
  return { width, height, data: new Uint8Array(data), ...wraps };
}
