// A plain three.js page that shows a model by three's own loader, under a light at the camera, with
// MeshPhongMaterial.
import {
  Box3,
  type BufferGeometry,
  DirectionalLight,
  Mesh,
  MeshPhongMaterial,
  MeshStandardMaterial,
  type Object3D,
  Sphere,
} from 'three';
import { DRACOLoader } from 'three/examples/jsm/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js';
import { threePage } from './three-page.js';

const address = new URLSearchParams(location.search).get('model')!;
const shown = load();

const { renderer, camera, scene } = threePage(document.getElementById('holder')!, 0.1, 2000);
camera.add(new DirectionalLight(0xffffff, Math.PI));
scene.add(camera);

const model = await shown;
scene.add(model);
const { center, radius } = new Box3().setFromObject(model).getBoundingSphere(new Sphere());
camera.near = radius / 100;
camera.far = radius * 10;
camera.updateProjectionMatrix();
camera.position
  .set(0.2, 0.3, 0.9)
  .normalize()
  .multiplyScalar(2.8 * radius)
  .add(center);
camera.lookAt(center);
renderer.render(scene, camera);

async function load(): Promise<Object3D> {
  if (address.endsWith('.stl')) return meshOf(await new STLLoader().loadAsync(address));
  if (address.endsWith('.ply')) {
    const geometry = await new PLYLoader().loadAsync(address);
    geometry.computeVertexNormals();
    return meshOf(geometry);
  }
  const loader = new GLTFLoader().setDRACOLoader(new DRACOLoader().setDecoderPath('./draco/'));
  const { scene: root } = await loader.loadAsync(address);
  root.traverse((object) => {
    if (!(object instanceof Mesh) || !(object.material instanceof MeshStandardMaterial)) return;
    const { color, map } = object.material;
    object.material = new MeshPhongMaterial({ color, map });
  });
  return root;
}

function meshOf(geometry: BufferGeometry): Mesh {
  return new Mesh(geometry, new MeshPhongMaterial());
}
