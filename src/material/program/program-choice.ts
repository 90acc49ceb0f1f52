// Which program does one material draw a mesh with? Keeps the material's general variant, and asks the program cache for a
// specialised one. Code that was needed once stays, so that turning something off and on compiles nothing.
import type { Mesh, Texture } from 'three';
import { isBlack, isIntegerPower, isPowerTo64 } from '../../light/light-features.js';
import type { FileSurface } from '../file-surface.js';
import type { LightBuffer } from '../light-buffer.js';
import type { PhongLighting } from '../lighting.js';
import type { SurfaceValues } from '../material-values.js';
import type { Drawing } from './program-cache.js';
import {
  type AlphaMode,
  type Form,
  generalVariant,
  type MapName,
  type MaterialStyle,
  type RowCapacity,
  specialisedVariant,
  type Term,
  type Variant,
} from './variant.js';

/** What a program depends on about a file's look. */
export type ProgramLook = FileSurface & {
  readonly map: Texture | null;
  readonly vertexColors: boolean;
  readonly alphaMode: AlphaMode;
};

interface Choice {
  readonly variant: Variant;
  /** The lights that the program reads. */
  readonly lights: LightBuffer;
}

export class ProgramChoice {
  readonly #lighting: PhongLighting;
  readonly #look: ProgramLook;
  #style: MaterialStyle | null = null;
  /** The terms that style and surface sum now, and all that they ever did. */
  #terms: readonly Term[] = [];
  readonly #everTerms = new Set<Term>();
  /** All exponents so far were 64 at most. */
  #shininessTo64 = true;
  #integerShininess: number | null = null;
  #general: Variant | null = null;
  /** What {@link #general} was made for. */
  #madeFor = { featureVersion: -1, capacity: -1 };
  /** What a specialised program depends on besides its lights. */
  #materialKey = '';
  /** The last key, so that draws build no text. */
  #last = { materialKey: '', form: '', lights: '' as string | number, key: '' };

  constructor(lighting: PhongLighting, look: ProgramLook) {
    this.#lighting = lighting;
    this.#look = look;
  }

  /** The material's style or surface changed. */
  describe(style: MaterialStyle, { ks, shininess }: Readonly<SurfaceValues>): void {
    this.#style = style;
    this.#terms = style.terms.filter((term) => term !== 'specular' || !isBlack(ks));
    const varies = usesRoughnessMap(this.#look, style);
    this.#integerShininess = !varies && isIntegerPower(shininess) ? shininess : null;
    if (varies || !isPowerTo64(shininess)) this.#shininessTo64 = false;
    this.#general = null;
  }

  /** The program for this draw, and the lights it reads. */
  choose(drawing: Drawing & { readonly mesh: Mesh }): Choice {
    const lighting = this.#lighting;
    const general = this.general(lighting.capacityFor(drawing.renderer));
    const lights = lighting.lightsOf(drawing.mesh);
    if (this.#look.unlit) return { variant: general, lights };
    const grid = lighting.gridOf(drawing.mesh);
    const form = lighting.formFor(lights, grid);
    if (form === null) return { variant: general, lights };
    const special = lighting.programs.choose(this.#keyOf(form, lights), drawing, () =>
      specialisedVariant(
        general,
        { terms: this.#terms, integerShininess: this.#integerShininess },
        form,
        lights.packed,
      ),
    );
    return special === null ? { variant: general, lights } : { variant: special, lights: grid ?? lights };
  }

  /** Inlined numbers are those of one version of the lights; other forms depend on counts and features alone. */
  #keyOf(form: Form, { contentKey, featureKey }: LightBuffer): string {
    const lights = form === 'inlined' ? contentKey : featureKey;
    const materialKey = this.#materialKey;
    const last = this.#last;
    if (last.materialKey === materialKey && last.form === form && last.lights === lights) return last.key;
    const key = `${materialKey} ${form} ${lights}`;
    this.#last = { materialKey, form, lights, key };
    return key;
  }

  /** The program for any number of lights of the declared features. */
  general(capacity: RowCapacity): Variant {
    const lighting = this.#lighting;
    const { featureVersion } = lighting;
    const made = this.#madeFor;
    if (this.#general !== null && made.featureVersion === featureVersion && made.capacity === capacity)
      return this.#general;
    for (const term of this.#terms) this.#everTerms.add(term);
    const look = this.#look;
    const { vertexColors, alphaMode, unlit } = look;
    const style = this.#style!;
    this.#general = generalVariant(
      {
        ...style,
        terms: [...this.#everTerms],
        linear: lighting.linear,
        shininessTo64: this.#shininessTo64,
        vertexColors,
        alphaMode,
        unlit,
        emissive: emits(look),
        metalness: !unlit && look.metalness > 0,
        roughness: usesRoughnessMap(look, style),
        maps: mapsOf(look, style),
      },
      lighting.declared,
      capacity,
    );
    this.#madeFor = { featureVersion, capacity };
    this.#materialKey = `${this.#general.key} ${this.#terms.join()} ${String(this.#integerShininess)}`;
    return this.#general;
  }
}

const emits = ({ unlit, emissive }: ProgramLook): boolean => !unlit && !isBlack(emissive);

/** A vertex has no texture: Gouraud shading takes the roughness without its map. */
export const usesRoughnessMap = (
  { unlit, roughness, metalRoughMap }: ProgramLook,
  { shading }: MaterialStyle,
): boolean => !unlit && roughness !== null && metalRoughMap !== null && shading !== 'gouraud';

/** The maps that are sampled, each with its set of texture coordinates. */
function mapsOf(look: ProgramLook, style: MaterialStyle): Partial<Record<MapName, number>> {
  const { map, emissiveMap, metalRoughMap, normalMap, unlit, metalness } = look;
  const maps: Partial<Record<MapName, number>> = {};
  if (map !== null) maps.map = map.channel;
  if (emissiveMap !== null && emits(look)) maps.emissiveMap = emissiveMap.channel;
  if (metalRoughMap !== null && ((!unlit && metalness > 0) || usesRoughnessMap(look, style)))
    maps.metalRoughMap = metalRoughMap.channel;
  if (normalMap !== null && !unlit && style.shading === 'phong') maps.normalMap = normalMap.channel;
  return maps;
}
