// Which program does one material draw a mesh with? Keeps the material's general variant, and asks the program cache for a
// specialised one. Code that was needed once stays, so that turning something off and on compiles nothing.
import type { Mesh } from 'three';
import { isBlack, isIntegerPower, isPowerTo64 } from '../../light/light-features.js';
import { usesRoughnessMap } from '../file-surface.js';
import type { LightBuffer } from '../light-buffer.js';
import type { PhongLighting } from '../lighting.js';
import type { SurfaceValues } from '../material-values.js';
import type { BaseLook } from '../phong-material.js';
import { DEFAULT_STYLE, type ShadingStyle, type Term } from '../shading-style.js';
import type { Drawing } from './program-cache.js';
import {
  type Form,
  generalVariant,
  type MaterialTerms,
  specialisedVariant,
  type Variant,
} from './variant.js';

interface Choice {
  readonly variant: Variant;
  /** The lights that the program reads. */
  readonly lights: LightBuffer;
}

export class ProgramChoice {
  readonly #lighting: PhongLighting;
  readonly #look: BaseLook;
  #style: ShadingStyle = DEFAULT_STYLE;
  #terms: MaterialTerms = { terms: [], integerShininess: null };
  /** All terms that were ever summed. */
  readonly #everTerms = new Set<Term>();
  /** All exponents so far were 64 at most. */
  #shininessTo64 = true;
  #general: Variant | null = null;
  /** What {@link #general} was made for. */
  #madeFor = { featureVersion: -1, capacity: -1 };
  /** What a specialised program depends on besides its lights. */
  #materialKey = '';
  /** The last key, so that draws build no text. */
  #last = { materialKey: '', form: '', lights: '' as string | number, key: '' };

  constructor(lighting: PhongLighting, look: BaseLook) {
    this.#lighting = lighting;
    this.#look = look;
  }

  /** The material's style or surface changed. */
  describe(style: ShadingStyle, { ks, shininess }: Readonly<SurfaceValues>): void {
    this.#style = style;
    const varies = usesRoughnessMap(this.#look, style);
    this.#terms = {
      terms: style.terms.filter((term) => term !== 'specular' || !isBlack(ks)),
      integerShininess: !varies && isIntegerPower(shininess) ? shininess : null,
    };
    if (varies || !isPowerTo64(shininess)) this.#shininessTo64 = false;
    this.#general = null;
  }

  /** The program for this draw, and the lights it reads. */
  choose(drawing: Drawing & { readonly mesh: Mesh }): Choice {
    const lighting = this.#lighting;
    const general = this.general(lighting.capacityFor(drawing.renderer));
    const lights = lighting.lightsOf(drawing.mesh);
    const grid = this.#look.unlit ? null : lighting.gridOf(drawing.mesh);
    const form = this.#look.unlit ? null : lighting.formFor(lights, grid);
    const special =
      form &&
      lighting.programs.choose(this.#keyOf(form, lights), drawing, () =>
        specialisedVariant(general, this.#terms, form, lights.packed),
      );
    return special ? { variant: special, lights: grid ?? lights } : { variant: general, lights };
  }

  /** The program for any number of lights of the declared features. `capacity` as in {@link generalVariant}. */
  general(capacity: number): Variant {
    const { featureVersion, linear, declared } = this.#lighting;
    const made = this.#madeFor;
    if (this.#general !== null && made.featureVersion === featureVersion && made.capacity === capacity)
      return this.#general;
    const { terms, integerShininess } = this.#terms;
    for (const term of terms) this.#everTerms.add(term);
    const style = { ...this.#style, terms: [...this.#everTerms] };
    const material = { look: this.#look, style, linear, shininessTo64: this.#shininessTo64 };
    this.#general = generalVariant(material, declared, capacity);
    this.#madeFor = { featureVersion, capacity };
    this.#materialKey = `${this.#general.key} ${terms.join()} ${String(integerShininess)}`;
    return this.#general;
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
}
