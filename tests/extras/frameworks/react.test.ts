// Which markup do the components of `phong-viewer/react` render on a server?

import { createElement, type FunctionComponent } from 'react';
import { renderToStaticMarkup } from 'react-dom/server';
import { describe, expect, it } from 'vitest';
import { attributeOf, fields } from '../../../.ci/manifest/tables.js';
import * as components from '../../../src/extras/frameworks/react.js';
import {
  PhongCompare,
  type PhongCompareProps,
  type PhongControlProps,
  PhongLight,
  type PhongLightProps,
  PhongMesh,
  type PhongMeshProps,
  PhongViewer,
  type PhongViewerProps,
} from '../../../src/extras/frameworks/react.js';

it.each(Object.entries(fields))('the component of <%s> writes each of its values', (tag, table) => {
  const component = Object.values(components).find(({ displayName }) => displayName === tag);
  const props = Object.fromEntries(Object.keys(table).map((key) => [key, [1, 2]]));
  const html = renderToStaticMarkup(createElement(component as FunctionComponent, props));
  for (const key of Object.keys(table)) {
    expect(html).toContain(` ${attributeOf(key)}="1 2"`);
  }
});

it('handlers know the element that they are on', () => {
  // Checked by the compiler.
  const viewer: PhongViewerProps = {
    onCameraChange: ({ currentTarget, detail }) => [currentTarget.camera.theta, detail.source],
    onLoad: (event) => event.currentTarget.loaded,
  };
  const mesh: PhongMeshProps = { onError: (event) => event.currentTarget.geometry };
  const compare: PhongCompareProps = { onDividerChange: ({ currentTarget }) => currentTarget.at };
  expect([viewer, mesh, compare].map((props) => Object.keys(props).length)).toEqual([2, 1, 1]);
});

describe('the React components on a server', () => {
  const quiet = () => undefined;
  const light = createElement(PhongLight, { name: 'sun' });

  it.each([
    [
      'lists, numbers, booleans and words as text',
      createElement(PhongLight, {
        position: [1, 2.5, -3, 1],
        diffuse: '#fc8',
        cutoff: 0,
        active: true,
      }),
      '<phong-light position="1 2.5 -3 1" diffuse="#fc8" cutoff="0" active="true"></phong-light>',
    ],
    [
      'typed arrays like arrays',
      createElement(PhongMesh, {
        position: Float32Array.of(0.5, 1, 2),
        ka: Uint8ClampedArray.of(1, 2, 3),
      }),
      '<phong-mesh position="0.5 1 2" ka="1 2 3"></phong-mesh>',
    ],
    [
      'nothing for null, undefined and a value without a text form, which the client sets',
      createElement(PhongMesh, {
        geometry: null,
        segments: undefined,
        src: new Blob(['solid']),
      } as object),
      '<phong-mesh></phong-mesh>',
    ],
    [
      'attributes by their HTML names, whatever the spelling of the prop',
      createElement(PhongViewer, {
        autoRotate: 5,
        'color-interpolation': 'linear',
        crossOrigin: 'anonymous',
      }),
      '<phong-viewer auto-rotate="5" color-interpolation="linear" crossorigin="anonymous"></phong-viewer>',
    ],
    [
      'other props and children as React does, and no handler',
      createElement(PhongViewer, {
        id: 'scene',
        className: 'wide',
        style: { width: 10 },
        hidden: true,
        tabIndex: 0,
        'aria-label': 'A box',
        onClick: quiet,
        onLoad: quiet,
        onCameraChange: quiet,
        children: light,
      }),
      '<phong-viewer id="scene" class="wide" style="width:10px" hidden="" tabIndex="0" aria-label="A box">' +
        '<phong-light name="sun"></phong-light></phong-viewer>',
    ],
    [
      'a comparison with its viewers, and lists of texts with commas',
      createElement(PhongCompare, {
        at: [30],
        labels: ['Gouraud shading', 'Phong'],
        onDividerChange: quiet,
        children: createElement(PhongViewer, { terms: ['ambient', 'diffuse'] }),
      }),
      '<phong-compare at="30" labels="Gouraud shading, Phong">' +
        '<phong-viewer terms="ambient, diffuse"></phong-viewer></phong-compare>',
    ],
  ])('write %s', (_, element, html) => {
    expect(renderToStaticMarkup(element)).toBe(html);
  });

  it('refuse React’s own color, which is a guess at diffuse or kd', () => {
    // @ts-expect-error there is no such prop
    const light: PhongLightProps = { color: 'red' };
    // @ts-expect-error meshes have no such prop
    const mesh: PhongMeshProps = { color: 'red' };
    // @ts-expect-error there is no such look
    const control: PhongControlProps = { type: 'knob' };
    // @ts-expect-error labels are texts
    const compare: PhongCompareProps = { labels: [1] };
    expect([light, mesh, compare, control]).toHaveLength(4);
  });
});
