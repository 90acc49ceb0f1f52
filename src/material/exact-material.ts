// A material that draws what another one draws, by a program for exactly its lights, exponent and terms. It shares the other's
// uniforms, so only the program differs; it is right only as long as neither list nor material asks for another one.
import { ShaderMaterial } from 'three';
import cellList from '../../shaders/cell_list.glsl?raw';
import constantRowsGlsl from '../../shaders/constant_rows.glsl?raw';
import { SHAPE } from '../light/light-layout.js';
import { isBlack } from '../light/light-kind.js';
import type { PackedLights } from '../light/pack-lights.js';
import { isMildPower, isWholePower } from '../light/steady-light.js';
import {
  constant,
  constantRows,
  counted,
  inCells,
  inLoops,
  isAllConstant,
  literal,
  writtenOut,
} from './exact-lights.js';
import { lightBlockOf } from './light-block.js';
import type { LightList } from './light-list.js';
import type { PhongMaterial } from './phong-material.js';
import { shadersOf } from './shader-source.js';
import type { Term } from './variant.js';

const TERM_BITS: Readonly<Record<Term, number>> = {
  ambient: SHAPE.ambient,
  diffuse: SHAPE.diffuse,
  specular: SHAPE.specular,
};

/**
 * How a program holds its lights: each written out; so with all of their numbers and the surface's in its text, `constant`; in
 * loops of literal length, `counted`; in loops of any length; or in lists by cells of a divided box.
 */
export type ExactForm = 'written' | 'constant' | 'counted' | 'loops' | 'cells';

/** Whether it reads its lights from the uniform block; else from the texture, or not at all. */
export const readsBlock = (form: ExactForm): boolean => form === 'written' || form === 'counted';

export interface ExactChoice {
  readonly list: LightList;
  readonly form: ExactForm;
  /** From the eye to what is drawn it is 1e-9 to 1e14: vectors need no rescue from float32's ends. */
  readonly usual: boolean;
  /** No light stands at what is drawn. */
  readonly apart: boolean;
}

const TEXTS = {
  ...{ written: writtenOut, constant, counted },
  ...{ loops: inLoops, cells: inCells },
} as const;

/** The chunk that a form asks for. */
export const CHUNKS: Readonly<Partial<Record<ExactForm, string>>> = {
  constant: constantRowsGlsl,
  cells: cellList,
};

/** The value of the define EXACT_LIGHTS. */
export const exactText = (form: ExactForm, packed: PackedLights, terms: number): string =>
  TEXTS[form](packed, terms);

export class ExactMaterial extends ShaderMaterial {
  /** The material that this one draws for. */
  readonly standsFor: PhongMaterial;
  readonly #choice: ExactChoice;

  constructor(source: PhongMaterial, choice: ExactChoice) {
    const { glslVersion, uniforms, side, vertexColors } = source;
    const { premultipliedAlpha, blending, transparent, toneMapped } = source;
    super({
      ...{ glslVersion, uniforms, side, vertexColors },
      ...{ premultipliedAlpha, blending, transparent, toneMapped },
      ...shadersOf(source.defines as Record<string, string>, CHUNKS[choice.form]),
    });
    this.standsFor = source;
    this.#choice = choice;
    source.chooseProgram();
    const defines: Record<string, string> = { ...(source.defines as Record<string, string>) };
    const { terms } = source.style;
    const { ks, shininess } = source.surface;
    const summed = terms.filter((term) => term !== 'specular' || !isBlack(ks));
    const bits = summed.reduce((sum, term) => sum | TERM_BITS[term], 0);
    if (!terms.includes('ambient')) delete defines['HAS_AMBIENT'];
    if (isWholePower(shininess)) defines['WHOLE_SHININESS'] = String(shininess);
    else if (isMildPower(shininess)) defines['MILD_SHININESS'] = '';
    if (choice.apart) defines['LIGHTS_APART'] = '';
    if (choice.usual) defines['USUAL_LENGTHS'] = '';
    defines['EXACT_LIGHTS'] = exactText(choice.form, choice.list.packed, bits);
    if (readsBlock(choice.form)) {
      defines['LIGHT_STORAGE'] = 'STORAGE_BLOCK';
      const { rows, packed } = choice.list;
      const block = lightBlockOf(rows);
      defines['LIGHT_BLOCK_ROWS'] = String(block.rowsFor(packed.rows));
      this.uniformsGroups = [block.group];
    } else if (choice.form === 'constant') {
      const { reflectance } = source;
      defines['LIGHT_CONSTANTS'] = constantRows(choice.list.packed);
      delete defines['HAS_AMBIENT'];
      defines['CONSTANT_KA'] = literal(reflectance.ka);
      defines['CONSTANT_KD'] = literal(reflectance.kd);
      defines['CONSTANT_KS'] = literal(reflectance.ks);
    }
    this.defines = defines;
  }

  override onBeforeRender(...[renderer, , , , object]: Parameters<ShaderMaterial['onBeforeRender']>): void {
    const { list, form } = this.#choice;
    const { uLightTexture } = this.uniforms;
    if (readsBlock(form)) lightBlockOf(list.rows).send();
    else if (!(form === 'constant' && isAllConstant(list.packed)) && uLightTexture !== undefined)
      uLightTexture.value = list.rows.sendTexture(renderer);
    this.uniformsNeedUpdate = this.standsFor.place(object);
  }
}
