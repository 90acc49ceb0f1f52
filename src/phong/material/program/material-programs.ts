// The programs of one material: its general variant, and a specialised one where the program cache
// has it. Code that was needed once stays, so that turning something off and on compiles nothing.
import { isBlack } from '../../math/color.js';
import { isIntegerPower, isMildPower } from '../../light/precision.js';
import { usesRoughnessMap, type BaseLook } from '../file-surface.js';
import type { LightBuffer } from '../light-buffer.js';
import type { PhongLighting } from '../lighting.js';
import { type SurfaceValues, DEFAULT_STYLE, type ShadingStyle } from '../material-values.js';
import type { Term } from '../../light/light-state.js';
import type { Draw } from './program-cache.js';
import type { DrawnMaterial } from './special-programs.js';
import type { MaterialTerms } from './special-variant.js';
import { generalVariant, type Variant } from './variant.js';

export class MaterialPrograms {
  readonly #lighting: PhongLighting;
  readonly #look: BaseLook;
  #style: ShadingStyle = DEFAULT_STYLE;
  #terms: MaterialTerms = { terms: [], integerShininess: null };
  /** All terms that were ever summed. */
  readonly #everTerms = new Set<Term>();
  /** All exponents so far were mild: see LARGEST_MILD_POWER. */
  #mildShininess = true;
  /** The general variant and what it was made for; null after a change of style or surface. */
  #general: { variant: Variant; declared: number; capacity: number; linear: boolean } | null = null;
  /** What a specialised program is made from besides its lights; belongs to the general variant. */
  #drawn: DrawnMaterial | null = null;

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
    if (varies || !isMildPower(shininess)) {
      this.#mildShininess = false;
    }
    this.#general = null;
    this.#lighting.needs.restyled();
  }

  /** The one that draws at once. */
  get general(): Variant {
    const { packing, needs } = this.#lighting;
    const shown = packing.view?.program ?? null;
    return shown === null ? this.#generalFor(needs.capacity) : shown.variant(this.#generalFor(0));
  }

  /** The program for this draw, and the lights it reads. */
  forDraw(draw: Draw): { readonly variant: Variant; readonly lights: LightBuffer } {
    const lighting = this.#lighting;
    lighting.drawWith(draw.renderer);
    const lights = lighting.meshLights.of(draw.mesh);
    const general = this.general;
    const hasOne = this.#look.unlit || (lighting.packing.view?.program ?? null) !== null;
    const special = hasOne ? null : lighting.special?.forDraw(draw, this.#drawn!, lights);
    return special ?? { variant: general, lights };
  }

  /**
   * The program for any number of lights of the declared features. `capacity` as in {@link
   * generalVariant}.
   */
  #generalFor(capacity: number): Variant {
    const { linear, needs } = this.#lighting;
    const { declared } = needs;
    const made = this.#general;
    if (made?.declared === declared && made.capacity === capacity && made.linear === linear) {
      return made.variant;
    }
    const { terms, integerShininess } = this.#terms;
    for (const term of terms) {
      this.#everTerms.add(term);
    }
    const style = { ...this.#style, terms: [...this.#everTerms] };
    const material = { look: this.#look, style, linear, mildShininess: this.#mildShininess };
    const variant = generalVariant(material, declared, capacity);
    this.#general = { variant, declared, capacity, linear };
    const key = `${variant.key} ${terms.join()} ${String(integerShininess)}`;
    this.#drawn = { key, general: variant, terms: this.#terms, last: null };
    return variant;
  }
}
