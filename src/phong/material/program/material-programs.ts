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
  /** What was made last, and for what; null after a change of style or surface. */
  #made: {
    readonly drawn: DrawnMaterial;
    readonly declared: number;
    readonly capacity: number;
    readonly linear: boolean;
  } | null = null;

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
    this.#made = null;
    this.#lighting.needs.restyled();
  }

  /** The variant that draws at once. */
  general(): Variant {
    const { packing, needs } = this.#lighting;
    const program = packing.view?.program ?? null;
    const { general } = this.#drawnWith(program === null ? needs.capacity : 0);
    return program === null ? general : program.variant(general);
  }

  /** The program for this draw, and `lights`, those that reach the mesh, as it reads them. */
  forDraw(
    draw: Draw,
    lights: LightBuffer,
  ): { readonly variant: Variant; readonly lights: LightBuffer } {
    const { needs, packing, special } = this.#lighting;
    this.#lighting.drawWith(draw.renderer);
    const hasOne = this.#look.unlit || (packing.view?.program ?? null) !== null;
    const chosen = hasOne ? null : special?.forDraw(draw, this.#drawnWith(needs.capacity), lights);
    return chosen ?? { variant: this.general(), lights };
  }

  /**
   * The general variant for any number of lights of the declared features, and what specialised
   * ones are made from. `capacity` as in {@link generalVariant}.
   */
  #drawnWith(capacity: number): DrawnMaterial {
    const { linear, needs } = this.#lighting;
    const { declared } = needs;
    const made = this.#made;
    if (made?.declared === declared && made.capacity === capacity && made.linear === linear) {
      return made.drawn;
    }
    const { terms, integerShininess } = this.#terms;
    for (const term of terms) {
      this.#everTerms.add(term);
    }
    const style = { ...this.#style, terms: [...this.#everTerms] };
    const material = { look: this.#look, style, linear, mildShininess: this.#mildShininess };
    const general = generalVariant(material, declared, capacity);
    const key = `${general.key} ${terms.join()} ${String(integerShininess)}`;
    const drawn = { key, general, terms: this.#terms, last: null };
    this.#made = { drawn, declared, capacity, linear };
    return drawn;
  }
}
