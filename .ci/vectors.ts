// The sheet of test scenes as data for other renderers: inputs with three decimals, and what the
// reference gives for them.
import type { Given } from '../src/phong/mistakes/steps.js';
import { sheetOf } from '../src/phong/mistakes/sheet.js';
import { KINDS, LightState, TERMS } from '../src/phong/light/light-state.js';
import type { Vec3 } from '../src/phong/math/vector.js';
import { shade } from '../src/phong/reference/equation.js';

/** Points of each scene: each form of each mistake is seen at four of them or more. */
const COUNT = 20;

export interface VectorRow {
  readonly scene: string;
  readonly light: Given['light'];
  readonly material: Given['material'];
  readonly p: Vec3;
  readonly normal: Vec3;
  readonly eye: Vec3;
  readonly ambient: Vec3;
  readonly diffuse: Vec3;
  /** By Phong, and by Blinn–Phong. */
  readonly specular: Vec3;
  readonly specularBlinn: Vec3;
}

export const vectors = (): readonly VectorRow[] =>
  sheetOf({ kinds: KINDS, terms: TERMS, reflection: 'phong' }, COUNT).map(({ scene, given }) => {
    const { light, material, p, normal, eye } = given;
    const phong = termsOf(given, 'phong');
    const { specular: specularBlinn } = termsOf(given, 'blinn-phong');
    return { scene, light, material, p, normal, eye, ...phong, specularBlinn };
  });

/** The reference takes colours as HTML writes them. */
const html = ([r, g, b]: Vec3): Vec3 => [255 * r, 255 * g, 255 * b];

function termsOf({ light, material, p, normal, eye }: Given, reflection: Given['reflection']) {
  const { values } = new LightState({
    ...light,
    ambient: html(light.ambient),
    diffuse: html(light.diffuse),
    specular: html(light.specular),
  });
  const surface = {
    ka: html(material.ka),
    kd: html(material.kd),
    ks: html(material.ks),
    shininess: material.shininess,
  };
  const { ambient, diffuse, specular } = shade({ p, normal, eye }, surface, [values], {
    reflection,
  }).shares[0]!;
  return { ambient: exact(ambient), diffuse: exact(diffuse), specular: exact(specular) };
}

/** Twelve decimals: the guide promises 1e-12. */
const exact = (color: Vec3): Vec3 => color.map((x) => Number(x.toFixed(12))) as unknown as Vec3;
