// Specialised programs: each is made for one material and the lights that a mesh is drawn with, and
// takes over once both were drawn for a while. Many narrow spots on one mesh get a light grid.
// The elements fetch this file with motion: few frames are drawn as well without it.
import type { Mesh } from 'three';
import type { Box } from '../../light/cull-lights.js';
import { kindFeatures } from '../../light/kind-features.js';
import { divideLights, LEAST_DIVIDED } from '../../light/light-grid.js';
import { KINDS } from '../../light/light-state.js';
import { LightBuffer } from '../light-buffer.js';
import type { LightPacking } from '../light-packing.js';
import type { MeshLights } from '../mesh-lights.js';
import type { ProgramNeeds } from './program-needs.js';
import { type Draw, ProgramCache } from './program-cache.js';
import { type Form, type MaterialTerms, specialisedVariant } from './special-variant.js';
import type { Variant } from './variant.js';

/**
 * Most lights that software inlines: 16 take 291 ms to compile, 32 take 897 (SwiftShader on two
 * cores).
 */
const MOST_INLINED = 16;

/** What a specialised program is made from besides its lights. */
export interface DrawnMaterial {
  /** All of it as text. */
  readonly key: string;
  readonly general: Variant;
  readonly terms: MaterialTerms;
  /** The last program's key, so that draws build no text. Written by {@link SpecialPrograms}. */
  last: { readonly form: Form; readonly lights: string | number; readonly key: string } | null;
}

/** What specialised programs read of their picture. */
interface SpecialLighting {
  readonly meshLights: MeshLights;
  readonly needs: ProgramNeeds;
  readonly packing: LightPacking;
}

/** The specialised programs of one picture. */
export class SpecialPrograms {
  readonly #lighting: SpecialLighting;
  readonly #cache: ProgramCache;
  readonly #gridOf = new WeakMap<Mesh, MeshLightGrid>();
  /** The grids that the last frame used. */
  readonly #grids = new Set<MeshLightGrid>();
  #frame = 0;

  /** `drawn`: frames that were drawn before, with what is drawn in the first frame. */
  constructor(lighting: SpecialLighting, drawn = 0) {
    this.#lighting = lighting;
    this.#cache = new ProgramCache(drawn);
  }

  /** A frame begins. */
  begin(): void {
    for (const grid of this.#grids) {
      if (grid.frame === this.#frame) continue;
      grid.dispose();
      this.#grids.delete(grid);
    }
    this.#frame += 1;
    this.#cache.begin();
  }

  /** The program for this draw, and its lights as it reads them. Null: the general one is best. */
  forDraw(
    draw: Draw,
    material: DrawnMaterial,
    lights: LightBuffer,
  ): { readonly variant: Variant; readonly lights: LightBuffer } | null {
    const grid = this.#divided(draw.mesh, lights);
    const form = this.#formFor(lights, grid);
    if (form === null) return null;
    const { general, terms } = material;
    const variant = this.#cache.choose(keyOf(material, form, lights), draw, () =>
      specialisedVariant(general, terms, form, lights.packed),
    );
    return variant && { variant, lights: grid ?? lights };
  }

  /** Whether a mesh may read these lights in a grid of its own. */
  divides({ packed }: LightBuffer): boolean {
    return packed.counts.spot >= LEAST_DIVIDED;
  }

  dispose(): void {
    for (const grid of this.#grids) {
      grid.dispose();
    }
    this.#cache.dispose();
  }

  /** The lights in a grid over the mesh; null where that is not worth it. */
  #divided(mesh: Mesh, lights: LightBuffer): LightBuffer | null {
    if (!this.divides(lights)) return null;
    const grid = this.#gridOf.get(mesh) ?? new MeshLightGrid();
    this.#gridOf.set(mesh, grid);
    grid.frame = this.#frame;
    this.#grids.add(grid);
    return grid.of(lights, this.#lighting.meshLights.boxOf(mesh));
  }

  #formFor(lights: LightBuffer, grid: LightBuffer | null): Form | null {
    const { needs, packing } = this.#lighting;
    if (needs.device === null) return null;
    if (grid !== null) return 'grid';
    if (!needs.device.software) return needs.capacity > 0 ? 'counted' : null;
    // Inlined numbers that change in every frame would make a key each, for nothing.
    return lights.packed.sent <= MOST_INLINED && !packing.changed ? 'inlined' : null;
  }
}

/**
 * Inlined numbers are those of one revision of the lights; other forms depend on counts and
 * features alone.
 */
function keyOf(material: DrawnMaterial, form: Form, buffer: LightBuffer): string {
  const lights = form === 'inlined' ? buffer.revision : featureKeyOf(buffer);
  const { last } = material;
  if (last?.form === form && last.lights === lights) return last.key;
  const key = `${material.key} ${form} ${lights}`;
  material.last = { form, lights, key };
  return key;
}

const featureKeys = new WeakMap<LightBuffer, { readonly revision: number; readonly key: string }>();

/** The counts and features of each kind of light, as text. */
function featureKeyOf(buffer: LightBuffer): string {
  const { revision, packed } = buffer;
  const present = featureKeys.get(buffer);
  if (present?.revision === revision) return present.key;
  const masks = kindFeatures(packed);
  const key = KINDS.flatMap((kind) => [packed.counts[kind], masks[kind]]).join();
  featureKeys.set(buffer, { revision, key });
  return key;
}

/**
 * Most frames to skip after failed divisions. One can cost 27 ms (43 wide spots), in every frame
 * that moves lights.
 */
const MOST_SKIPPED = 63;

/** One mesh's grid. Divides again when the lights change; backs off while dividing does not pay. */
class MeshLightGrid {
  /** The last frame that used it. */
  frame = 0;
  readonly #buffer = new LightBuffer();
  /** What it was divided for. */
  #source = -1;
  #box: Box | null = null;
  #divided = false;
  #skips = 0;
  /** Doubles with each failure. */
  #nextSkips = 0;

  of(lights: LightBuffer, box: Box | null): LightBuffer | null {
    if (lights.revision !== this.#source || box !== this.#box) {
      this.#source = lights.revision;
      this.#box = box;
      this.#divided = false;
      if (this.#skips > 0) {
        this.#skips -= 1;
      } else if (box !== null) {
        this.#divide(lights, box);
      }
    }
    return this.#divided ? this.#buffer : null;
  }

  /** Frees what the GPU holds; the next draw sends it again. */
  dispose(): void {
    this.#buffer.dispose();
  }

  #divide({ packed }: LightBuffer, box: Box): void {
    this.#divided = divideLights(packed, box, this.#buffer.packed);
    if (this.#divided) {
      this.#buffer.changed();
    }
    this.#nextSkips = this.#divided ? 0 : Math.min(2 * this.#nextSkips + 1, MOST_SKIPPED);
    this.#skips = this.#nextSkips;
  }
}
