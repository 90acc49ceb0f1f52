// Plain three.js on a canvas like the element's: MeshPhongMaterial under the nearest lights that
// three.js has, or one unlit mesh.
import {
  AmbientLight,
  BackSide,
  BoxGeometry,
  type BufferGeometry,
  Color,
  DirectionalLight,
  type Light,
  type Material,
  MathUtils,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  type PerspectiveCamera,
  PointLight,
  SphereGeometry,
  SRGBColorSpace,
  SpotLight,
} from 'three';
import {
  extraLight,
  lightAt,
  type OpenSide,
  ORIGIN,
  type Scene as BenchScene,
  type SceneLight,
  type Side,
  SURFACE,
  swing,
  thetaAt,
} from './scenes.js';
import { threePage } from './three-page.js';

const SHAPES: Readonly<Record<string, () => BufferGeometry>> = {
  sphere: () => new SphereGeometry(0.5, 64, 32),
  box: () => new BoxGeometry(),
};

/**
 * The nearest light that three.js has. Its penumbra stands for `cutoff`, its decay for
 * `attenuation`.
 */
export function threeLight({
  position: [x, y, z, w],
  diffuse,
  axis,
  aperture = 180,
}: SceneLight): Light {
  const [r, g, b] = diffuse;
  const color = new Color().setRGB(r / 255, g / 255, b / 255, SRGBColorSpace);
  if (w === 0) return placed(new DirectionalLight(color, Math.PI), [x, y, z]);
  // Brightness falls with the square of the distance: as bright at the origin as the element's
  // light.
  const intensity = Math.PI * (x * x + y * y + z * z);
  if (axis === undefined) return placed(new PointLight(color, intensity, 0, 2), [x, y, z]);
  const spot = new SpotLight(color, intensity, 0, MathUtils.degToRad(aperture), 0.5, 2);
  spot.target.position.set(x + axis[0], y + axis[1], z + axis[2]);
  return placed(spot, [x, y, z]);
}

function placed<T extends Light>(light: T, [x, y, z]: readonly [number, number, number]) {
  light.position.set(x, y, z);
  return light;
}

const targetOf = (light: Light) => (light instanceof SpotLight ? [light.target] : []);

function phongMaterial({ inside, shininess = SURFACE.shininess }: BenchScene) {
  const { kd, ks } = SURFACE;
  const material = new MeshPhongMaterial({
    color: new Color().setScalar(kd / 255).convertSRGBToLinear(),
    specular: new Color().setScalar(ks / 255).convertSRGBToLinear(),
    shininess,
  });
  if (inside === true) {
    material.side = BackSide;
  }
  return material;
}

async function threeMeshes(scene: BenchScene, material: Material) {
  const geometries = new Map<string, BufferGeometry>();
  const meshes: Mesh[] = [];
  for (const { shape, position = ORIGIN, scale = 1 } of scene.meshes) {
    let geometry = geometries.get(shape);
    if (geometry === undefined) {
      geometry = shape.endsWith('.glb') ? await loadGeometry(shape, material) : SHAPES[shape]!();
      geometries.set(shape, geometry);
    }
    const mesh = new Mesh(geometry, material);
    mesh.position.set(...position);
    mesh.scale.setScalar(scale);
    meshes.push(mesh);
  }
  return meshes;
}

/**
 * The first geometry of a model. `material` takes over which sides the model shows and whether it
 * is blended.
 */
async function loadGeometry(url: string, material: Material) {
  const [{ GLTFLoader }, { DRACOLoader }] = await Promise.all([
    import('three/addons/loaders/GLTFLoader.js'),
    import('three/addons/loaders/DRACOLoader.js'),
  ]);
  const draco = new DRACOLoader();
  const { scene } = await new GLTFLoader().setDRACOLoader(draco).loadAsync(url);
  let found: Mesh<BufferGeometry, Material> | undefined;
  scene.traverse((object) => {
    if (object instanceof Mesh) {
      found ??= object as Mesh<BufferGeometry, Material>;
    }
  });
  if (found === undefined) throw new Error(`${url} has no mesh`);
  material.side = found.material.side;
  material.transparent = found.material.transparent;
  return found.geometry;
}

/** To where the eye is at this frame. */
function turn(camera: PerspectiveCamera, { motion, radius }: BenchScene, frame: number) {
  const theta = motion === 'camera' ? MathUtils.degToRad(thetaAt(frame)) : 0;
  camera.position.set(radius * Math.sin(theta), 0, radius * Math.cos(theta));
  camera.lookAt(0, 0, 0);
}

const open = async (holder: HTMLElement, bench: BenchScene, lit: boolean): Promise<Side> => {
  const { renderer, camera, scene } = threePage(holder, 0.05, 100);
  const material = lit ? phongMaterial(bench) : new MeshBasicMaterial();
  const meshes = await threeMeshes(bench, material);
  for (const mesh of meshes) {
    scene.add(mesh);
  }
  const lights = lit ? bench.lights.map(threeLight) : [];
  for (const light of lights) {
    scene.add(light, ...targetOf(light));
  }
  const ambient = bench.lights.reduce((sum, light) => sum + light.ambient[0] / 255, 0);
  if (lit && ambient > 0) {
    scene.add(new AmbientLight(0xffffff, ambient));
  }

  let extra: Light | null = null;
  const change = (i: number) => {
    switch (bench.motion) {
      case 'lights':
        lights.forEach((light, k) => {
          const [x, y, z] = lightAt(bench.lights[k]!, i);
          light.position.set(x, y, z);
        });
        break;
      case 'light count':
        if (extra === null) {
          extra = threeLight(bench.lights[extraLight(i)]!);
          scene.add(extra, ...targetOf(extra));
        } else {
          scene.remove(extra, ...targetOf(extra));
          extra.dispose();
          extra = null;
        }
        break;
      case 'toggle':
        for (const light of lights.slice(lights.length >> 1, (lights.length >> 1) + 1)) {
          light.visible = i % 2 === 0;
        }
        break;
      case 'mesh':
        meshes[0]!.position.x = 0.1 * swing(i);
        break;
      case 'camera':
    }
  };
  const draw = (i: number) => {
    turn(camera, bench, i);
    renderer.render(scene, camera);
  };
  draw(0);
  return {
    async frame(i) {
      change(i);
      await Promise.resolve();
      draw(i);
    },
  };
};

export const openThree: OpenSide = (holder, scene) => open(holder, scene, true);
export const openUnlit: OpenSide = (holder, scene) => open(holder, scene, false);
