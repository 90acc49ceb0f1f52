// Which program does one material draw a mesh with? Keeps the material's general variant, and asks the program cache for a
// specialised one. Code that was needed once stays, so that turning something off and on compiles nothing.
import type { Mesh } from 'three';
import { isBlack, isIntegerPower, isPowerTo64 } from '../../light/light-features.js';
import type { LightBuffer } from '../light-buffer.js';
import type { PhongLighting } from '../lighting.js';
import type { SurfaceValues } from '../material-values.js';
import type { Drawing } from './program-cache.js';
import {
  type AlphaMode,
  type Form,
  generalVariant,
  type MaterialStyle,
  type RowCapacity,
  specialisedVariant,
  type Term,
  type Variant,
} from './variant.js';

/** What a program depends on about a file's look. */
interface Look {
  readonly map: object | null;
  readonly vertexColors: boolean;
  readonly alphaMode: AlphaMode;
}

interface Choice {
  readonly variant: Variant;
  /** The lights that the program reads. */
  readonly lights: LightBuffer;
}

export class ProgramChoice {
  readonly #lighting: PhongLighting;
  readonly #look: Look;
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
  #last = { materialKey: '', form: '', lights: '', key: '' };

  constructor(lighting: PhongLighting, look: Look) {
    this.#lighting = lighting;
    this.#look = look;
  }

  /** The material's style or surface changed. */
  describe(style: MaterialStyle, { ks, shininess }: Readonly<SurfaceValues>): void {
    this.#style = style;
    this.#terms = style.terms.filter((term) => term !== 'specular' || !isBlack(ks));
    this.#integerShininess = isIntegerPower(shininess) ? shininess : null;
    if (!isPowerTo64(shininess)) this.#shininessTo64 = false;
    this.#general = null;
  }

  /** The program for this draw, and the lights it reads. */
  choose(drawing: Drawing & { readonly mesh: Mesh }): Choice {
    const lighting = this.#lighting;
    const general = this.#generalFor(lighting.capacityFor(drawing.renderer));
    const lights = lighting.lightsOf(drawing.mesh);
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

  #generalFor(capacity: RowCapacity): Variant {
    const lighting = this.#lighting;
    const { featureVersion } = lighting;
    const made = this.#madeFor;
    if (this.#general !== null && made.featureVersion === featureVersion && made.capacity === capacity)
      return this.#general;
    for (const term of this.#terms) this.#everTerms.add(term);
    const { map, vertexColors, alphaMode } = this.#look;
    this.#general = generalVariant(
      {
        ...this.#style!,
        terms: [...this.#everTerms],
        linear: lighting.linear,
        shininessTo64: this.#shininessTo64,
        map: map !== null,
        vertexColors,
        alphaMode,
      },
      lighting.declared,
      capacity,
    );
    this.#madeFor = { featureVersion, capacity };
    this.#materialKey = `${this.#general.key} ${this.#terms.join()} ${String(this.#integerShininess)}`;
    return this.#general;
  }
}
