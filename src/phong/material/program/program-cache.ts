// The program that draws a mesh: the general one first; a specialised one, compiled in the
// background, once the same lights and material were drawn for a while. One cache for each
// PhongLighting; it counts programs, not meshes.
import { type Camera, GLSL3, type Mesh, RawShaderMaterial, type WebGLRenderer } from 'three';
import {
  compiles,
  compilingPrograms,
  programOf,
  reportLinkFailure,
  variantParameters,
} from './three-programs.js';
import type { Variant } from './variant.js';

/**
 * Drawn frames with the same key before a specialised program is requested: a third of a second of
 * motion.
 */
const SETTLED_FRAMES = 20;

/**
 * Frames after which a program counts as linked if the browser cannot say. A query then no longer
 * blocks.
 */
const UNKNOWN_LINK_FRAMES = 4;

/** Most entries kept. Those of lights and materials that are no longer drawn go first. */
const MOST_ENTRIES = 32;

/** What is drawn: the renderer, the camera, and a mesh of that kind, for compiling. */
export interface Draw {
  readonly renderer: WebGLRenderer;
  readonly camera: Camera;
  readonly mesh: Mesh;
}

/**
 * general → compiling → linked → specialised, or failed. `linked` waits for its turn: the first
 * draw with a program may still compile, so a page takes over one program in a frame.
 */
type State =
  | { readonly name: 'general'; readonly frames: number }
  | { readonly name: 'compiling'; readonly probe: Probe; readonly frames: number }
  | { readonly name: 'linked' | 'specialised'; readonly probe: Probe }
  | { readonly name: 'failed' };

interface Entry {
  state: State;
  /** The last frame that drew it. */
  frame: number;
}

/**
 * A material that holds a program for three.js's own cache: a PhongMaterial of the same variant
 * then shares it.
 */
interface Probe {
  readonly material: RawShaderMaterial;
  readonly variant: Variant;
  readonly renderer: WebGLRenderer;
}

/** Take-overs of the page so far: see {@link ProgramCache.begin}. */
let takeOvers = 0;

export class ProgramCache {
  readonly #entries = new Map<string, Entry>();
  #frame = 0;
  /** {@link takeOvers} at the start of this frame and of the last one. */
  #seen = { now: 0, before: 0 };
  /** The first draw in this frame that asked for a program. */
  #request: { entry: Entry; draw: Draw; specialise: () => Variant } | null = null;
  #compiling: Entry | null = null;
  /** Frames that count as drawn with each key of the first frame. */
  readonly #drawn: number;

  constructor(drawn: number) {
    this.#drawn = drawn;
  }

  /** Before each frame: starts or ends the compilation of one program. */
  begin(): void {
    this.#frame += 1;
    this.#seen = { now: takeOvers, before: this.#seen.now };
    if (this.#compiling !== null) {
      this.#poll(this.#compiling);
    } else if (this.#request !== null) {
      this.#compile();
    }
    this.#request = null;
  }

  /**
   * The specialised variant for a draw, made by `specialise`; null if it is not there. `key` is all
   * it depends on.
   */
  choose(key: string, draw: Draw, specialise: () => Variant): Variant | null {
    const entry = this.#entries.get(key) ?? this.#add(key);
    const isFirst = entry.frame !== this.#frame;
    const isStreak = entry.frame === this.#frame - 1;
    entry.frame = this.#frame;
    const { state } = entry;
    if (state.name === 'specialised') return state.probe.variant;
    if (state.name === 'linked') return this.#takeOver(entry, state.probe);
    if (state.name === 'general' && isFirst) {
      const frames = isStreak ? state.frames + 1 : 1;
      entry.state = { name: 'general', frames };
      if (frames >= SETTLED_FRAMES) {
        this.#request ??= { entry, draw, specialise };
      }
    }
    return null;
  }

  dispose(): void {
    for (const entry of this.#entries.values()) {
      disposeOf(entry);
    }
    this.#entries.clear();
    this.#compiling = null;
    this.#request = null;
  }

  /** Drops what neither this frame nor the last one has drawn, if there is no room. */
  #add(key: string): Entry {
    for (const [other, entry] of this.#entries) {
      if (this.#entries.size < MOST_ENTRIES || entry.frame >= this.#frame - 1) continue;
      if (this.#compiling === entry) {
        this.#compiling = null;
      }
      disposeOf(entry);
      this.#entries.delete(other);
    }
    const frames = this.#frame === 1 ? this.#drawn : 0;
    const entry: Entry = { state: { name: 'general', frames }, frame: this.#frame - 1 };
    this.#entries.set(key, entry);
    return entry;
  }

  #compile(): void {
    const { entry, draw, specialise } = this.#request!;
    const { renderer, camera } = draw;
    const variant = specialise();
    const material = new RawShaderMaterial({ ...variantParameters(variant), glslVersion: GLSL3 });
    const probe: Probe = { material, variant, renderer };
    compiles(material, renderer, camera);
    const program = programOf(probe);
    if (program !== undefined) {
      compilingPrograms.add(program);
    }
    entry.state = { name: 'compiling', probe, frames: 0 };
    this.#compiling = entry;
  }

  #poll(entry: Entry): void {
    const { state } = entry;
    if (state.name !== 'compiling') return;
    const { probe, frames } = state;
    const { renderer } = probe;
    const gl = renderer.getContext();
    const program = programOf(probe);
    const tells = renderer.extensions.has('KHR_parallel_shader_compile');
    if (program !== undefined && !(tells ? program.isReady() : frames >= UNKNOWN_LINK_FRAMES)) {
      entry.state = { ...state, frames: frames + 1 };
      return;
    }
    this.#compiling = null;
    if (program === undefined || gl.isContextLost()) {
      entry.state = { name: 'general', frames: 0 }; // the context was lost with the program
      return;
    }
    const linked = gl.getProgramParameter(program.program, gl.LINK_STATUS) === true;
    compilingPrograms.delete(program);
    if (!linked) {
      // Disposing removes it from three.js's list, so the link check cannot report it later.
      reportLinkFailure(gl, program.program);
      disposeOf(entry);
    }
    entry.state = linked ? { name: 'linked', probe } : { name: 'failed' };
  }

  /**
   * The program that takes over now. At most one of the page is drawn for the first time between
   * two frames of this cache; null, to wait, where another one was.
   */
  #takeOver(entry: Entry, probe: Probe): Variant | null {
    if (takeOvers !== this.#seen.before) return null;
    takeOvers += 1;
    entry.state = { name: 'specialised', probe };
    return probe.variant;
  }
}

function disposeOf({ state }: Entry): void {
  if (!('probe' in state)) return;
  const { renderer, material } = state.probe;
  const program = programOf(state.probe)?.program;
  // three.js deletes shaders with the first draw.
  if (state.name !== 'specialised' && program !== undefined) {
    const gl = renderer.getContext();
    for (const shader of gl.getAttachedShaders(program) ?? []) {
      gl.deleteShader(shader);
    }
  }
  material.dispose();
}
