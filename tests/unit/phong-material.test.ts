// When a material needs another program: for code that it has never needed before, and for nothing else.

import { describe, expect, it } from 'vitest';
import { LightSet } from '../../src/light/light-set.js';
import { LightState } from '../../src/light/light-state.js';
import { AVERAGES_GLSL } from '../../src/material/averaged-highlights.js';
import { PhongLighting, type ShadingFrame } from '../../src/material/lighting.js';
import { PhongMaterial } from '../../src/material/phong-material.js';
import { bringAverages } from '../../src/material/program/source.js';
import { type Term, TERMS } from '../../src/material/program/variant.js';

const FRAME: ShadingFrame = {
  ...{ origin: [0, 0, 0], eye: [0, 0, 5] },
  ...{ right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] },
};

/** A material under one light that brings every term. */
function lit(): { lighting: PhongLighting; material: PhongMaterial } {
  const light = new LightState();
  light.set('ambient', [9, 9, 9]);
  const set = new LightSet();
  set.assign([light]);
  const lighting = new PhongLighting(set);
  lighting.update(FRAME);
  return { lighting, material: new PhongMaterial(lighting) };
}

const termsOf = (material: PhongMaterial): string[] => {
  material.chooseProgram();
  return Object.keys(material.defines).filter((name) => /AMBIENT|DIFFUSE|SPECULAR/.test(name));
};

const terms = (...names: Term[]): { terms: Term[] } => ({ terms: names });

describe('the code for a term', () => {
  it('is not there before the term is summed', () => {
    const { material } = lit();
    material.setStyle(terms('diffuse'));
    expect(termsOf(material)).toStrictEqual(['HAS_DIFFUSE']);
    material.setStyle(terms());
    expect(termsOf(lit().material)).toHaveLength(TERMS.length);
  });

  it('stays once it was needed: turning it off and on needs no other program, and sums nothing meanwhile', () => {
    const { material } = lit();
    termsOf(material);
    const { programVersion } = material;
    for (const chosen of [terms('diffuse'), terms(), terms('specular', 'ambient'), { terms: TERMS }]) {
      material.setStyle(chosen);
      expect(termsOf(material)).toHaveLength(TERMS.length);
      const { ka, kd, ks } = material.reflectance;
      const given = { ambient: ka, diffuse: kd, specular: ks };
      for (const term of TERMS)
        expect([...Array.from(given[term])].some((k) => k > 0)).toBe(chosen.terms.includes(term));
    }
    expect(material.programVersion).toBe(programVersion);
  });

  it('is not there for specular light that the surface never gave back', () => {
    const { material } = lit();
    material.setSurface({ ks: [0, 0, 0] });
    expect(termsOf(material)).not.toContain('HAS_SPECULAR');
    const { programVersion } = material;
    material.setSurface({ ks: [0, 1, 0] });
    expect(termsOf(material)).toContain('HAS_SPECULAR');
    expect(material.programVersion).toBe(programVersion + 1);
    material.setSurface({ ks: [0, 0, 0] });
    expect(termsOf(material)).toContain('HAS_SPECULAR');
    expect(material.programVersion).toBe(programVersion + 1);
  });
});

it('averages highlights from when the code for it is there, and shows them as they are until then', () => {
  const { material } = lit();
  material.setStyle({ antialias: 'highlights' });
  material.chooseProgram();
  expect(material.defines).not.toHaveProperty('FILTER_HIGHLIGHTS');
  bringAverages(AVERAGES_GLSL);
  material.setStyle({});
  material.chooseProgram();
  expect(material.defines).toHaveProperty('FILTER_HIGHLIGHTS');
  expect(material.fragmentShader).toContain(AVERAGES_GLSL);
});

describe('another program', () => {
  it('is for another way of shading, and for what lights need the first time', () => {
    const { lighting, material } = lit();
    termsOf(material);
    const versions = [material.programVersion];
    const next = (change: () => void): void => {
      change();
      lighting.update(FRAME);
      material.chooseProgram();
      versions.push(material.programVersion);
    };
    const [light] = lighting.lights.lights;
    next(() => material.setStyle({ shading: 'gouraud' }));
    next(() => material.setStyle({ reflection: 'blinn-phong' }));
    next(() => light!.set('position', [0, 1, 0, 1]));
    next(() => (lighting.linear = true));
    next(() => light!.set('position', [0, 1, 0, 0]));
    next(() => light!.set('active', false));
    next(() => material.setStyle({ shading: 'phong' }));
    next(() => material.setStyle({ antialias: 'highlights' }));
    next(() => material.setSurface({ shininess: 7, ka: [1, 2, 3] }));
    next(() => lighting.update(FRAME));
    expect(versions.map((version) => version - versions[0]!)).toStrictEqual([
      0, 1, 2, 3, 4, 4, 4, 5, 6, 6, 6,
    ]);
  });
});

describe('what an exact program is made for', () => {
  const keyAfter = (change: (material: PhongMaterial) => void): string => {
    const { material } = lit();
    material.setSurface({ shininess: 0.5 });
    change(material);
    return material.exactKey;
  };
  const plain = keyAfter(() => undefined);

  it.each<[string, (material: PhongMaterial) => void]>([
    ['a whole exponent', (material) => material.setSurface({ shininess: 8 })],
    ['a surface without specular light', (material) => material.setSurface({ ks: [0, 0, 0] })],
    ['fewer terms', (material) => material.setStyle(terms('diffuse'))],
  ])('is %s', (_, change) => {
    expect(keyAfter(change)).not.toBe(plain);
  });

  it('is that an exponent is mild where it is not whole, and neither which nor a colour', () => {
    for (const shininess of [0.1, 2.5, 63.5])
      expect(keyAfter((material) => material.setSurface({ shininess, ka: [1, 2, 3], ks: [1, 0, 0] }))).toBe(
        plain,
      );
  });

  it('is no exponent that is 0 or large', () => {
    const keys = [0, 65, 128.5, 1e6].map((shininess) =>
      keyAfter((material) => material.setSurface({ shininess })),
    );
    expect(new Set(keys).size).toBe(1);
    expect(keys[0]).not.toBe(plain);
  });
});
