// Changes of a scene that must not change its picture, scene to scene. World space, HTML's units.
import { Euler, Matrix4, Vector3 } from 'three';
import { kindOf } from '../../src/light/light-features.js';
import type { LightValues } from '../../src/light/light-state.js';
import { srgbDecode, srgbEncode } from '../../src/math/color.js';
import { add, scale, type Vec3, type Vec4 } from '../../src/math/vector.js';
import { Dice, randomLight } from './random-scene.js';
import type { DeclaredScene } from './ray-cast.js';

const lightsOf = (scene: DeclaredScene, change: (light: LightValues) => LightValues): DeclaredScene => ({
  ...scene,
  lights: scene.lights.map(change),
});

/** The place or direction that a light's position is, changed; w stays. */
function placed({ position: [x, y, z, w] }: LightValues, change: (v: Vec3) => Vec3): Vec4 {
  return [...change([x, y, z]), w];
}

/** All lengths times `s`: places, sizes, the camera's distance, and attenuation's share of them. */
export function scaled(scene: DeclaredScene, s: number): DeclaredScene {
  const { pose, meshes } = scene;
  const larger = (v: Vec3): Vec3 => scale(v, s);
  const lit = lightsOf(scene, (light) => {
    const [kc, kl, kq] = light.attenuation;
    return {
      ...light,
      position: light.position[3] === 1 ? placed(light, larger) : light.position,
      attenuation: [kc, kl / s, kq / s / s],
    };
  });
  return {
    ...lit,
    pose: { ...pose, radius: pose.radius * s, target: larger(pose.target) },
    meshes: meshes.map((mesh) => ({ ...mesh, position: larger(mesh.position), scale: larger(mesh.scale) })),
  };
}

/** Moves everything in the world by `offset`; lights in camera space follow the eye. */
export function moved(scene: DeclaredScene, offset: Vec3): DeclaredScene {
  const there = (v: Vec3): Vec3 => add(v, offset);
  const lit = lightsOf(scene, (light) =>
    light.position[3] === 1 && light.space === 'world' ? { ...light, position: placed(light, there) } : light,
  );
  return {
    ...lit,
    pose: { ...scene.pose, target: there(scene.pose.target) },
    meshes: scene.meshes.map((mesh) => ({ ...mesh, position: there(mesh.position) })),
  };
}

/** Scene, lights and camera a quarter turn about +y, which takes +z to +x; θ grows by 90. */
export function turned(scene: DeclaredScene): DeclaredScene {
  const round = ([x, y, z]: Vec3): Vec3 => [z, y, 0 - x];
  const quarter = new Matrix4().makeBasis(new Vector3(0, 0, -1), new Vector3(0, 1, 0), new Vector3(1, 0, 0));
  const rotation = (degrees: Vec3): Vec3 => {
    const [x, y, z] = degrees.map((d) => (d * Math.PI) / 180) as [number, number, number];
    const matrix = new Matrix4().makeRotationFromEuler(new Euler(x, y, z, 'XYZ')).premultiply(quarter);
    const angles = new Euler().setFromRotationMatrix(matrix, 'XYZ');
    return [angles.x, angles.y, angles.z].map((a) => (a * 180) / Math.PI) as unknown as Vec3;
  };
  const lit = lightsOf(scene, (light) =>
    light.space === 'camera' ? light : { ...light, position: placed(light, round), axis: round(light.axis) },
  );
  return {
    ...lit,
    pose: { ...scene.pose, theta: scene.pose.theta + 90, target: round(scene.pose.target) },
    meshes: scene.meshes.map((mesh) => ({
      ...mesh,
      position: round(mesh.position),
      rotation: rotation(mesh.rotation),
    })),
  };
}

/** The lights sorted by kind and each kind in its old order: what is sent to the GPU is the same. */
export const sortedByKind = (scene: DeclaredScene): DeclaredScene => ({
  ...scene,
  lights: scene.lights.toSorted((a, b) => kindOf(b).localeCompare(kindOf(a))),
});

export const reversed = (scene: DeclaredScene): DeclaredScene => ({
  ...scene,
  lights: scene.lights.toReversed(),
});

const BLACK: Vec3 = [0, 0, 0];

/** After each light a black one and one that is off, of its own kind: they ask for no other program. */
export const withSilentTwins = (scene: DeclaredScene): DeclaredScene => ({
  ...scene,
  lights: scene.lights.flatMap((light) => {
    const elsewhere = { ...light, position: placed(light, (v) => scale(v, -0.7)) };
    return [light, { ...elsewhere, ambient: BLACK, diffuse: BLACK, specular: BLACK }, { ...elsewhere, active: false }];
  }),
});

/** Adds inactive lights of every kind, which may select another program. */
export function withStrangers(scene: DeclaredScene, seed: number): DeclaredScene {
  const dice = new Dice(seed);
  const strangers = Array.from({ length: 8 }, () => ({ ...randomLight(dice), active: false }));
  return { ...scene, lights: [...strangers.slice(4), ...scene.lights, ...strangers.slice(0, 4)] };
}

/** Each light as two of half its intensity; where colours are encoded, half of what they decode to. */
export function halved(scene: DeclaredScene): DeclaredScene {
  const half = (c: Vec3): Vec3 => {
    if (scene.options.linear !== true) return scale(c, 0.5);
    return c.map((x) => 255 * srgbEncode(srgbDecode(x / 255) / 2)) as unknown as Vec3;
  };
  const halves = lightsOf(scene, (light) => ({
    ...light,
    ambient: half(light.ambient),
    diffuse: half(light.diffuse),
    specular: half(light.specular),
  }));
  return { ...halves, lights: halves.lights.flatMap((light) => [light, light]) };
}

/** Directions of another length: a spot's axis, and the vector to a directional light. */
export const stretched = (scene: DeclaredScene, s: number): DeclaredScene =>
  lightsOf(scene, (light) => ({
    ...light,
    axis: scale(light.axis, s),
    position: light.position[3] === 0 ? placed(light, (v) => scale(v, s)) : light.position,
  }));

/** Not equivalent: every light is 1 % brighter. */
export const brighter = (scene: DeclaredScene): DeclaredScene =>
  lightsOf(scene, (light) => ({
    ...light,
    diffuse: scale(light.diffuse, 1.01),
    ambient: scale(light.ambient, 1.01),
  }));
