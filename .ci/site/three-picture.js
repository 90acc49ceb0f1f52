// @ts-check
// How does three.js show a model? With its own loaders, MeshStandardMaterial where the file has no
// material, its RoomEnvironment and one directional light. Runs in a page whose import map names
// three. Knows nothing of phong-viewer.

import {
  DirectionalLight,
  DoubleSide,
  LoadingManager,
  Mesh,
  MeshStandardMaterial,
  NeutralToneMapping,
  PerspectiveCamera,
  PMREMGenerator,
  Scene,
  WebGLRenderer,
} from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { MTLLoader } from 'three/addons/loaders/MTLLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

/**
 * @typedef {object} View
 * @property {readonly [number, number, number]} eye
 * @property {readonly [number, number, number]} target
 * @property {readonly [number, number, number]} up
 * @property {number} radius distance of the two
 * @property {number} fov vertical, in degrees
 * @property {number} width in pixels
 * @property {number} height
 */

/**
 * @param {string} url
 * @param {View} view
 * @returns {Promise<string>} a data URL of a WebP picture, transparent where nothing is drawn
 */
export async function pictureOf(url, { eye, target, up, radius, fov, width, height }) {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
  renderer.setSize(width, height);
  // As in <model-viewer>: highlights are compressed instead of clipped.
  renderer.toneMapping = NeutralToneMapping;
  const scene = new Scene();
  scene.environment = new PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
  scene.environmentIntensity = 0.45;
  scene.add(await load(url));
  const camera = new PerspectiveCamera(fov, width / height, radius / 100, radius * 100);
  camera.position.set(...eye);
  camera.up.set(...up);
  camera.lookAt(...target);
  const light = new DirectionalLight(0xffffff, 1.6);
  light.position.set(-1, 2, 2).applyQuaternion(camera.quaternion);
  scene.add(light);
  renderer.render(scene, camera);
  const picture = renderer.domElement.toDataURL('image/webp', 0.8);
  renderer.dispose();
  return picture;
}

/**
 * The object, once its textures are there. @param {string} url @returns
 * {Promise<import('three').Object3D>}
 */
async function load(url) {
  const manager = new LoadingManager();
  const loaded = new Promise((resolve) => {
    manager.onLoad = () => resolve(undefined);
  });
  const object = await read(url, manager);
  await loaded;
  return object;
}

/** @param {string} url @param {LoadingManager} manager */
async function read(url, manager) {
  if (/\.gl(b|tf)$/.test(url)) {
    const draco = new DRACOLoader().setDecoderPath('/three/examples/jsm/libs/draco/gltf/');
    const { scene } = await new GLTFLoader(manager).setDRACOLoader(draco).loadAsync(url);
    return scene;
  }
  if (url.endsWith('.obj')) {
    const text = await (await fetch(url)).text();
    const loader = new OBJLoader(manager);
    const library = /^mtllib +(.+?)\s*$/m.exec(text)?.[1];
    if (library === undefined) {
      manager.itemStart(url);
    } else {
      loader.setMaterials(await new MTLLoader(manager).loadAsync(new URL(library, url).href));
    }
    const object = loader.parse(text);
    if (library === undefined) {
      setTimeout(() => manager.itemEnd(url));
    }
    return object;
  }
  const geometry = await (
    url.endsWith('.stl') ? new STLLoader(manager) : new PLYLoader(manager)
  ).loadAsync(url);
  if (!geometry.hasAttribute('normal')) {
    geometry.computeVertexNormals();
  }
  return new Mesh(
    geometry,
    new MeshStandardMaterial({ color: 0xc8c8c8, roughness: 0.5, side: DoubleSide }),
  );
}
