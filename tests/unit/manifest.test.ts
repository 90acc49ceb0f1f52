// Do the files for editors agree with the elements? Generated in memory from the source.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { Ajv } from 'ajv';
import type { CustomElementDeclaration } from 'custom-elements-manifest';
import { describe, expect, it } from 'vitest';
import { packageExports } from '../../.ci/entries.mjs';
import { referencePage } from '../../.ci/manifest/reference-page.mjs';
import { describeElements } from '../../.ci/manifest/elements.mjs';
import { customElementsManifest, vsCodeHtmlData, webTypes } from '../../.ci/manifest/formats.mjs';
import * as tables from '../../.ci/manifest/tables.js';
import type {
  CompareProperties,
  CompareValues,
} from '../../src/viewer/element/fields/compare-fields.js';
import type { ControlProperties, ControlValues } from '../../src/viewer/element/phong-control.js';
import type { ExerciseProperties } from '../../src/viewer/element/phong-exercise.js';
import type { ProbeProperties } from '../../src/viewer/element/phong-probe.js';
import type {
  LightProperties,
  MeshProperties,
  SingleNumber,
} from '../../src/viewer/element/fields/properties.js';
import type {
  ViewerProperties,
  ViewerValues,
} from '../../src/viewer/element/fields/viewer-fields.js';
import type { LightValues } from '../../src/phong/light/light-state.js';
import type { MeshValues } from '../../src/phong/model/mesh-fields.js';
import * as classes from '../../src/viewer/index.js';
import { PhongLight } from '../../src/viewer/element/phong-light.js';
import { PhongMesh } from '../../src/viewer/element/phong-mesh.js';

const elements = describeElements(tables);
const manifest = customElementsManifest(elements);
const declarations = manifest.modules[0]!.declarations as CustomElementDeclaration[];
const declared = (tag: string) => declarations.find((d) => d.tagName === tag)!;
const attributes = declarations.flatMap(({ tagName, attributes = [] }) =>
  attributes.map((attribute) => ({ ...attribute, title: `${tagName!} ${attribute.name}` })),
);
const fieldOf = (title: string) => {
  const [tag = '', name] = title.split(' ');
  return Object.entries(tables.fields[tag]!).find(([key]) => tables.attributeOf(key) === name)![1];
};
const { elements: tags } = webTypes(elements, { name: 'x', version: '1.0.0' }).contributions.html;
const data = vsCodeHtmlData(elements).tags;

it('the tables of the reference are written from the source (`npm run manifest` writes them again)', () => {
  const page = readFileSync(new URL('../../demo/guide/reference.md', import.meta.url), 'utf8');
  expect(page).toBe(referencePage(page, elements));
});

it('the package exports the class of every element, and the type of its props', () => {
  const entry = readFileSync(new URL('../../src/viewer/index.ts', import.meta.url), 'utf8');
  for (const { className } of elements) {
    expect(Object.keys(classes)).toContain(className);
    expect(entry).toContain(`  ${className}Props,`);
  }
});

it('the exports of the package follow from its entries (`npm run manifest` writes them again)', () => {
  const text = readFileSync(new URL('../../package.json', import.meta.url), 'utf8');
  expect(JSON.parse(text)).toMatchObject(packageExports());
  const { exports } = JSON.parse(text) as { readonly exports: object };
  expect(Object.keys(exports)).toEqual(Object.keys(packageExports().exports));
});

describe('the custom elements manifest', () => {
  it('keeps to the published schema', () => {
    const path = createRequire(import.meta.url).resolve('custom-elements-manifest/schema.json');
    const validate = new Ajv({ strict: false }).compile(
      JSON.parse(readFileSync(path, 'utf8')) as object,
    );
    validate(manifest);
    expect(validate.errors).toBeNull();
  });

  it('has every attribute that the elements observe, in their order, and no other', () => {
    const names = (tag: string) => declared(tag).attributes!.map(({ name }) => name);
    expect(names('phong-light')).toEqual(PhongLight.observedAttributes);
    expect(names('phong-mesh')).toEqual(PhongMesh.observedAttributes);
    const ofViewer = Object.keys(tables.fields['phong-viewer']!).map(tables.attributeOf);
    expect(names('phong-viewer')).toEqual(ofViewer);
    for (const tag of ['phong-compare', 'phong-control', 'phong-probe', 'phong-exercise']) {
      expect(names(tag), tag).toContain(tag === 'phong-compare' ? 'layout' : 'for');
    }
  });

  it.each(attributes)(
    'describes $title with words, a type with its choices, its property and the default that its absence has',
    (attribute) => {
      const { title, description, default: text } = attribute;
      expect(description).toMatch(/^\S.{10}/);
      const type = /^(string|boolean|number( \| 'auto')?|'[\w+/-]+'( \| '[\w+/-]+')+)$/;
      expect(attribute.type!.text).toMatch(type);
      expect(tables.attributeOf(attribute.fieldName!)).toBe(attribute.name);
      const field = fieldOf(title);
      const words = field.kind === 'number' && field.word !== undefined ? [field.word] : [];
      for (const word of field.choices ?? words) {
        expect(attribute.type!.text).toContain(`'${word}'`);
      }
      const { fallback } = field;
      if (fallback === null) {
        expect(text).toBeUndefined();
      } else if (fallback === false) {
        expect(text).toBe('false');
      } else {
        expect(text).toBe(tables.formatValue(fallback, field) ?? '');
      }
    },
  );

  it('lists the public members of the viewer, and no internal ones', () => {
    const members = declared('phong-viewer').members!.map(({ name }) => name);
    const offered = ['camera', 'lights', 'meshes', 'loaded', 'scene', 'stats', 'ready'];
    offered.push('toBlob', 'toHTML', 'resetCamera', 'requestRender', 'refit', 'autoRotate');
    expect(members).toEqual(expect.arrayContaining(offered));
    expect(
      members.filter((name) => /^#|Callback$|^(state|declared|render|updated)$/.test(name)),
    ).toEqual([]);
    for (const member of declared('phong-viewer').members!) {
      expect(member.description, member.name).toBeTruthy();
    }
  });

  it('lists properties without an attribute, once', () => {
    const writable = (tag: string) =>
      declared(tag).members!.filter(
        (member) => member.kind === 'field' && !member.readonly && !('attribute' in member),
      );
    expect(writable('phong-viewer')).toMatchObject([
      { name: 'texts', type: { text: 'ViewerTexts | null' } },
      { name: 'maxTriangles', type: { text: 'number' } },
      { name: 'maxMemory', type: { text: 'number' } },
    ]);
    expect(writable('phong-light')).toEqual([]);
    for (const tag of ['phong-probe', 'phong-exercise']) {
      expect(writable(tag)).toMatchObject([{ name: 'value', type: { text: 'string' } }]);
    }
    const { properties } = tags.find(({ name }) => name === 'phong-viewer')!.js;
    expect(properties.filter(({ name }) => name === 'texts')).toMatchObject([
      { type: 'ViewerTexts | null' },
    ]);
  });

  it('lists the events with their details, the slots, the parts and the states', () => {
    const { events, slots, cssParts, cssStates } = declared('phong-viewer');
    const names = 'camera-change error light-change load probe-change progress render';
    expect(events!.map(({ name }) => name).sort()).toEqual(names.split(' '));
    expect(events!.find(({ name }) => name === 'camera-change')!.type.text).toMatch(
      /source: .*'pointer'/,
    );
    expect(slots!.map(({ name }) => name)).toEqual(['', 'poster', 'progress', 'error']);
    expect(cssStates!.map(({ name }) => name)).toEqual(['loading', 'error', 'empty']);
    expect(cssParts!.map(({ name }) => name)).toEqual(expect.arrayContaining(['surface', 'panel']));
    expect(declared('phong-mesh').events!.map(({ name }) => name)).toEqual(['load', 'error']);
  });
});

describe("JetBrains' web-types and VS Code's data", () => {
  it('name the same tags and attributes as the manifest', () => {
    const expected = declarations.map((d) => [d.tagName, d.attributes!.map(({ name }) => name)]);
    expect(tags.map((tag) => [tag.name, tag.attributes.map(({ name }) => name)])).toEqual(expected);
    expect(data.map((tag) => [tag.name, tag.attributes.map(({ name }) => name)])).toEqual(expected);
  });

  it('offer the values that an editor can complete', () => {
    const attribute = (tag: string, name: string) =>
      data.find((entry) => entry.name === tag)!.attributes.find((entry) => entry.name === name);
    const values = (tag: string, name: string) => {
      const found = attribute(tag, name)!;
      return 'values' in found ? found.values.map((value) => value.name) : [];
    };
    expect(values('phong-light', 'active')).toEqual(['true', 'false']);
    expect(values('phong-mesh', 'geometry')).toContain('torus-knot');
    expect(values('phong-viewer', 'target')).toEqual(['auto']);
    expect(attribute('phong-viewer', 'gui')).toMatchObject({ valueSet: 'v' });
  });
});

describe('the types of properties and JSX', () => {
  it('have for every value a setter that accepts undefined, as the compiler checks', () => {
    // A value without a setter of its own makes the type of what can be assigned to any key
    // `never`.
    const resets = {
      light: (light: LightProperties, key: keyof LightValues) => (light[key] = undefined),
      mesh: (mesh: MeshProperties, key: keyof MeshValues) => (mesh[key] = undefined),
      viewer: (viewer: ViewerProperties, key: keyof ViewerValues) => (viewer[key] = undefined),
      compare: (compare: CompareProperties, key: keyof CompareValues) => (compare[key] = undefined),
      control: (control: ControlProperties, key: keyof ControlValues) => (control[key] = undefined),
      probe: (probe: ProbeProperties, key: keyof ProbeProperties) => (probe[key] = undefined),
      exercise: (exercise: ExerciseProperties, key: keyof ExerciseProperties) =>
        (exercise[key] = undefined),
    };
    const tags = Object.keys(resets).map((name) => `phong-${name}`);
    expect(tags.sort()).toEqual(Object.keys(tables.fields).sort());
  });

  it('accept one number where the property accepts it for a list', () => {
    const typed: Record<SingleNumber, boolean> = {
      ambient: true,
      diffuse: true,
      specular: true,
      ka: true,
      kd: true,
      ks: true,
      scale: true,
      at: true,
    };
    const found = Object.values(tables.fields)
      .flatMap((fields) => Object.entries(fields))
      .filter(([, { check }]) => {
        try {
          return Array.isArray(check(1));
        } catch {
          return false;
        }
      });
    expect(new Set(found.map(([key]) => key))).toEqual(new Set(Object.keys(typed)));
  });
});
