// In which form a program for exactly some lights is to hold them: by how many there are, what the device can compile meanwhile,
// and for how long their numbers have stood still. Asked once a frame for each mesh.
import type { WebGLRenderer } from 'three';
import { LARGE_BLOCK_ROWS } from '../light/light-layout.js';
import { MOST_CONSTANT, MOST_PARTLY } from '../material/exact-lights.js';
import type { ExactForm } from '../material/exact-material.js';
import type { LightList } from '../material/light-list.js';
import type { PhongMaterial } from '../material/phong-material.js';

/** Of the same lights, before a program is made for them: a third of a second of motion, or a few frames of a slow picture. */
const SETTLED = { frames: 20, slowFrames: 3, slowTime: 300 } as const;

/** Whether so many frames of the same since a time are enough to make a program for it. `least`: milliseconds in any case. */
export function isSettled(frames: number, since: number, least = 0): boolean {
  const { slowFrames, slowTime } = SETTLED;
  if (frames < slowFrames) return false;
  const passed = performance.now() - since;
  return passed >= least && (frames >= SETTLED.frames || passed >= slowTime);
}

/**
 * Lights that a program has in loops of literal length at most: a GPU's driver compiles 128 in a third of a second and 1,024 in
 * three, in the background, and they take 0.5 to 0.7 of the time of loops over a texture.
 */
const MOST_COUNTED = 1024;

/**
 * The same in software, where the first draw compiles, in line with all other pictures. Numbers that are read take two thirds of the
 * time of a frame, so many lights are best with theirs in the program's text.
 */
const MOST_WRITTEN = 16;

/**
 * Milliseconds that so many lights take to compile in software: 24 were measured for 3 (SwiftShader on two cores, mixed kinds), 130 for 8,
 * 380 for 16, 850 for 32, 2,400 for 64 and more. A picture is drawn for at least as long before, so that it never waits for longer than it
 * has saved or soon will.
 */
function compileTime(sent: number): number {
  const lights = Math.min(sent, MOST_CONSTANT);
  return lights * (12 + 0.4 * lights);
}

/** Frames that are given up for it at most: 32 lights' are always worth it, a smooth picture does not halt for 64. */
const MOST_FRAMES_LOST = 64;

/** One mesh's. */
export class FormChoice {
  #list: LightList | null = null;
  #numbers = -1;
  #surface = -1;
  #frames = 0;
  #since = 0;
  #constant = false;

  /** The form for `list`, which is of `cells` or not, in this frame. */
  of(renderer: WebGLRenderer, list: LightList, cells: boolean, material: PhongMaterial): ExactForm {
    const { sent } = list.packed;
    const software = isSoftware(renderer);
    if (software) this.#watch(list, material);
    if (cells) return 'cells';
    if (!software)
      return sent <= MOST_COUNTED && list.packed.rows <= blockRowsOf(renderer) ? 'counted' : 'loops';
    this.#constant ||= sent <= MOST_PARTLY && this.#isWorth(compileTime(sent));
    if (this.#constant) return 'constant';
    return sent <= MOST_WRITTEN ? 'written' : 'loops';
  }

  /** Counts frames in which all numbers of lights and surface are as before. */
  #watch(list: LightList, { surfaceVersion }: PhongMaterial): void {
    const { version } = list.rows;
    if (this.#list === list && this.#numbers === version && this.#surface === surfaceVersion) {
      this.#frames += 1;
      return;
    }
    this.#list = list;
    this.#numbers = version;
    this.#surface = surfaceVersion;
    this.#frames = 0;
    this.#since = performance.now();
    this.#constant = false;
  }

  /** A wait of so many milliseconds, by the frames so far. */
  #isWorth(wait: number): boolean {
    const passed = performance.now() - this.#since;
    return isSettled(this.#frames, this.#since, wait) && passed * MOST_FRAMES_LOST >= wait * this.#frames;
  }
}

interface Device {
  readonly software: boolean;
  /** Rows that a uniform block may have. */
  readonly blockRows: number;
}

const devices = new WeakMap<WebGLRenderer, Device>();

function deviceOf(renderer: WebGLRenderer): Device {
  const known = devices.get(renderer);
  if (known !== undefined) return known;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  const device = {
    software: /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name),
    blockRows: Math.min((gl.getParameter(gl.MAX_UNIFORM_BLOCK_SIZE) as number) / 16, LARGE_BLOCK_ROWS),
  };
  devices.set(renderer, device);
  return device;
}

const isSoftware = (renderer: WebGLRenderer): boolean => deviceOf(renderer).software;
const blockRowsOf = (renderer: WebGLRenderer): number => deviceOf(renderer).blockRows;
