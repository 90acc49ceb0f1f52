// A material that draws what another one draws, by a program for exactly its lights, exponent and terms. It shares the other's
// uniforms, so only the program differs; it is right only as long as neither list nor material asks for another one.
import { ShaderMaterial } from 'three';
import { SHAPE } from '../light/light-layout.js';
import { isBlack } from '../light/light-kind.js';
import { isWholePower } from '../light/steady-light.js';
import { inLoops, writtenOut } from './exact-lights.js';
import type { LightList } from './light-list.js';
import type { PhongMaterial } from './phong-material.js';
import type { Term } from './variant.js';

const TERM_BITS: Readonly<Record<Term, number>> = {
  ambient: SHAPE.ambient,
  diffuse: SHAPE.diffuse,
  specular: SHAPE.specular,
};

export class ExactMaterial extends ShaderMaterial {
  readonly #source: PhongMaterial;
  readonly #list: LightList;
  readonly #written: boolean;

  /** Lists of up to `mostWritten` lights are written out; longer ones stay loops. */
  constructor(source: PhongMaterial, list: LightList, mostWritten: number) {
    const { glslVersion, vertexShader, fragmentShader, uniforms, side, vertexColors } = source;
    const { premultipliedAlpha, blending, transparent, toneMapped } = source;
    super({
      ...{ glslVersion, vertexShader, fragmentShader, uniforms, side, vertexColors },
      ...{ premultipliedAlpha, blending, transparent, toneMapped },
    });
    this.#source = source;
    this.#list = list;
    const { packed } = list;
    this.#written = packed.sent <= mostWritten;
    source.chooseProgram();
    this.defines = { ...source.defines };
    const { terms } = source.style;
    const { ks, shininess } = source.surface;
    const summed = terms.filter((term) => term !== 'specular' || !isBlack(ks));
    if (!terms.includes('ambient')) delete this.defines['HAS_AMBIENT'];
    const bits = summed.reduce((sum, term) => sum | TERM_BITS[term], 0);
    if (isWholePower(shininess)) this.defines['WHOLE_SHININESS'] = String(shininess);
    if (this.#written) {
      this.defines['LIGHT_STORAGE'] = 'STORAGE_BLOCK';
      this.defines['EXACT_LIGHTS'] = writtenOut(packed, bits);
      this.uniformsGroups = [list.rows.group];
    } else {
      this.defines['EXACT_LIGHTS'] = inLoops(packed, bits);
    }
  }

  override onBeforeRender(...[renderer, , , , object]: Parameters<ShaderMaterial['onBeforeRender']>): void {
    const { rows } = this.#list;
    const { uLightTexture } = this.uniforms;
    if (this.#written) rows.sendBlock();
    else if (uLightTexture !== undefined) uLightTexture.value = rows.sendTexture(renderer);
    this.#source.place(object);
    this.uniformsNeedUpdate = true;
  }
}
