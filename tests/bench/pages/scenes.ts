// The scenes that the bench draws, described once for all sides, in the element's units: lengths in
// scene units, angles in degrees, colours 0 to 255. Positions come from Halton sequences, so every
// run draws the same scene.

export type Vec3 = readonly [number, number, number];
type Vec4 = readonly [number, number, number, number];

export interface SceneLight {
  readonly position: Vec4;
  readonly ambient: Vec3;
  readonly diffuse: Vec3;
  readonly specular: Vec3;
  readonly attenuation?: Vec3;
  readonly axis?: Vec3;
  readonly aperture?: number;
  readonly cutoff?: number;
}

export type RoundShape = 'sphere' | 'torus' | 'teapot';

interface SceneMesh {
  /** A built-in shape, or a model's file. */
  readonly shape: RoundShape | 'box' | 'models/bunny.glb';
  readonly position?: Vec3;
  readonly scale?: number;
}

/** A mesh without a position is here. */
export const ORIGIN: Vec3 = [0, 0, 0];

/** What changes before each frame. */
type Motion = 'camera' | 'lights' | 'light count' | 'mesh' | 'toggle';

export interface Scene {
  readonly lights: readonly SceneLight[];
  readonly meshes: readonly SceneMesh[];
  /** The eye is at `radius` from the target, on its equator. Vertical field of view: 45 degrees. */
  readonly radius: number;
  readonly motion: Motion;
  /** Of its round shapes, where they have a fixed number. */
  readonly segments?: number;
  /** Of all meshes, in place of the usual one. */
  readonly shininess?: number;
  /** The eye is inside the first mesh. */
  readonly inside?: boolean;
  /** The element finds target and radius by itself, and again after each move. */
  readonly autoFit?: boolean;
}

/** Opens a scene in an element that has its final size. Resolves once one frame is drawn. */
export type OpenSide = (holder: HTMLElement, scene: Scene) => Promise<Side>;

/** One way to draw a scene. */
export interface Side {
  /** Changes the scene to its state at this frame and draws it. */
  frame(i: number): Promise<void>;
}

export const FOV = 45;
export const SURFACE = { ka: 200, kd: 200, ks: 128, shininess: 32 } as const;

/** The widest picture that is measured: width / height. */
const WIDEST = 16 / 9;
/** The angle from the picture's center to its corner. */
const CORNER = Math.atan(Math.tan((FOV / 2) * (Math.PI / 180)) * Math.hypot(1, WIDEST));
/** The eye's distance from a sphere of diameter 1 that fills the picture, corners included. */
const FILLED = 0.97 * (0.5 / Math.sin(CORNER));

/** The i-th number of the van der Corput sequence in a prime base, in [0, 1). */
function halton(i: number, base: number) {
  let [result, share] = [0, 1];
  for (let n = i + 1; n > 0; n = Math.floor(n / base)) {
    share /= base;
    result += share * (n % base);
  }
  return result;
}

const between = (low: number, high: number, t: number) => low + (high - low) * t;

/**
 * Lights on the eye's side of the origin, `distance` to twice that far from it: directional, point
 * and spot in turn. Every cone holds a sphere of a sixth of `distance` around the origin, so no
 * light can be culled. Together they are about as bright as one full light.
 */
export function mixedLights(count: number, distance = 2): SceneLight[] {
  const full = Math.min(200, 600 / Math.max(count, 1));
  return Array.from({ length: count }, (_, i): SceneLight => {
    const azimuth = between(-0.45, 0.45, halton(i, 2)) * Math.PI;
    const height = between(-0.7, 0.9, halton(i, 3));
    const away = distance * between(1, 2, halton(i, 5));
    const flat = Math.sqrt(1 - height * height);
    const [x, z] = [away * flat * Math.sin(azimuth), away * flat * Math.cos(azimuth)];
    const y = away * height;
    const channel = (base: number) => full * between(0.5, 1, halton(i, base));
    const color: Vec3 = [channel(7), channel(11), channel(13)];
    const common = { ambient: [0, 0, 0], diffuse: color, specular: color } as const;
    const attenuation: Vec3 = [1, 0.05, 0.02];
    if (i % 3 === 0) {
      return { ...common, position: [x, y, z, 0], ambient: [full / 10, full / 10, full / 10] };
    }
    if (i % 3 === 1) return { ...common, position: [x, y, z, 1], attenuation };
    const spot = { axis: [-x, -y, -z] as const, aperture: 30, cutoff: 4 + (i % 12) };
    return { ...common, position: [x, y, z, 1], attenuation, ...spot };
  });
}

/** Lights inside a room of edge 4 around the origin, `y` up. */
function roomLights(count: number): SceneLight[] {
  return mixedLights(count, 0.9).map((light, i) => {
    if (light.position[3] === 0) return light;
    const place = (base: number) => between(-1.5, 1.5, halton(i, base));
    const [x, y, z] = [place(2), place(3), place(5)];
    const cone = light.axis === undefined ? {} : { axis: [x, -1, z] as const, aperture: 60 };
    return { ...light, position: [x, y, z, 1], ...cone };
  });
}

/** Equal shapes on a regular grid around the origin, 1 apart. */
function grid([nx, ny, nz]: Vec3, shape: SceneMesh['shape'], scale: number): SceneMesh[] {
  return Array.from({ length: nx * ny * nz }, (_, i): SceneMesh => {
    const at = (index: number, count: number) => index - (count - 1) / 2;
    const [x, y] = [at(i % nx, nx), at(Math.floor(i / nx) % ny, ny)];
    return { shape, scale, position: [x, y, at(Math.floor(i / (nx * ny)), nz)] };
  });
}

const sphere = (lights: number, motion: Motion): Scene => ({
  lights: mixedLights(lights),
  meshes: [{ shape: 'sphere' }],
  radius: FILLED,
  motion,
});

const box = (lights: number, motion: Motion): Scene => ({
  ...sphere(lights, motion),
  meshes: [{ shape: 'box' }],
  radius: 2,
});

const boxes = (lights: number, count: Vec3, motion: Motion): Scene => ({
  lights: mixedLights(lights, 40),
  meshes: grid(count, 'box', 0.6),
  radius: 24,
  motion,
});

/** By name; the first number in the name is the number of lights. */
export function sceneOf(name: string): Scene {
  const [kind = '', count = '', more = ''] = name.split(':');
  const lights = Number(count);
  switch (kind) {
    case 'sphere':
      return sphere(lights, 'camera');
    case 'shiny':
      return { ...sphere(lights, 'camera'), shininess: Number(more) };
    case 'framed': {
      const meshes = [{ shape: more as RoundShape }];
      return { ...sphere(lights, 'camera'), meshes, autoFit: true, segments: 64 };
    }
    case 'moving':
      return sphere(lights, 'lights');
    case 'changing':
      return sphere(lights, 'light count');
    case 'toggle':
      return box(lights, 'toggle');
    case 'room':
      return {
        lights: roomLights(lights),
        meshes: [{ shape: 'box', scale: 4 }],
        radius: 1,
        motion: 'camera',
        inside: true,
      };
    case 'bunny':
      return {
        lights: mixedLights(lights, 6),
        meshes: [{ shape: 'models/bunny.glb' }],
        radius: 2.9,
        motion: 'camera',
      };
    case 'spheres':
      return {
        lights: mixedLights(lights, 40),
        meshes: grid([8, 8, 1], 'sphere', 0.9),
        radius: 10.2,
        motion: 'camera',
      };
    case 'boxes':
      return boxes(lights, [20, 10, 10], 'camera');
    case 'ten-thousand':
      return boxes(lights, [25, 20, 20], more as Motion);
    case 'box-turning':
      return box(lights, 'camera');
    case 'box-moving':
      return box(lights, 'lights');
    default:
      throw new RangeError(`no scene is called ${name}`);
  }
}

/** The swing of everything that moves, in frames. */
const PERIOD = 60;
export const swing = (frame: number): number => Math.sin((2 * Math.PI * frame) / PERIOD);

/** The eye's azimuth at a frame, in degrees. */
export const thetaAt = (frame: number): number => 4 * swing(frame);

/** Where a light is at a frame. */
export function lightAt({ position: [x, y, z, w] }: SceneLight, frame: number): Vec4 {
  const way = 0.1 * swing(frame);
  return [x + way, y, z - way, w];
}

/**
 * The kind of the light that is added at even frames and removed at odd ones: an index into
 * `lights`.
 */
export const extraLight = (frame: number): number => Math.floor(frame / 2) % 3;
