// Which markup do the components of `phong-viewer/react` render on a server?

import { createElement, type FunctionComponent } from 'react';
import { renderToStaticMarkup } from 'react-dom/server';
import { describe, expect, it } from 'vitest';
import {
  PhongCompare,
  PhongControl,
  type PhongCompareProps,
  type PhongControlProps,
  PhongLight,
  type PhongLightProps,
  PhongMesh,
  type PhongMeshProps,
  PhongViewer,
  type PhongViewerProps,
} from '../../src/react.js';

const markup = <P extends object>(component: FunctionComponent<P>, props: P): string =>
  renderToStaticMarkup(createElement(component, props));

describe('the React components on a server', () => {
  it('write lists, numbers, booleans and words as text', () => {
    const props = {
      position: [1, 2.5, -3, 1],
      diffuse: '#fc8',
      cutoff: 0,
      active: true,
      space: 'camera',
    } as const;
    expect(markup(PhongLight, props)).toBe(
      '<phong-light position="1 2.5 -3 1" diffuse="#fc8" cutoff="0" active="true" space="camera"></phong-light>',
    );
  });

  it('write typed arrays like arrays', () => {
    const props = { position: new Float32Array([0.5, 1, 2]), ka: new Uint8ClampedArray([1, 2, 3]) };
    expect(markup(PhongMesh, props)).toBe('<phong-mesh position="0.5 1 2" ka="1 2 3"></phong-mesh>');
  });

  it('omit null and undefined', () => {
    expect(markup(PhongMesh, { geometry: null, segments: undefined })).toBe('<phong-mesh></phong-mesh>');
  });

  it('name attributes as HTML does, whatever the spelling of the prop', () => {
    const props = { autoRotate: 5, 'color-interpolation': 'linear', crossOrigin: 'anonymous' } as const;
    expect(markup(PhongViewer, props)).toBe(
      '<phong-viewer auto-rotate="5" color-interpolation="linear" crossorigin="anonymous"></phong-viewer>',
    );
  });

  it('leave other props and children to React, and write no handler', () => {
    const props: PhongViewerProps = {
      id: 'scene',
      className: 'wide',
      style: { width: 10 },
      hidden: true,
      tabIndex: 0,
      'aria-label': 'A box',
      onClick: () => undefined,
      onLoad: () => undefined,
      onCameraChange: () => undefined,
      children: createElement(PhongLight, { name: 'sun' }),
    };
    expect(markup(PhongViewer, props)).toBe(
      '<phong-viewer id="scene" class="wide" style="width:10px" hidden="" tabIndex="0" aria-label="A box">' +
        '<phong-light name="sun"></phong-light></phong-viewer>',
    );
  });

  it('write a comparison with its viewers', () => {
    const props = { at: [30], labels: 'A, B', onDividerChange: () => undefined };
    const viewer = createElement(PhongViewer, { alt: 'A' });
    expect(markup(PhongCompare, { ...props, children: viewer })).toBe(
      '<phong-compare at="30" labels="A, B"><phong-viewer alt="A"></phong-viewer></phong-compare>',
    );
  });

  it('write a control with its label', () => {
    const props = { for: 'a b', attribute: 'cutoff', max: 60, children: 'softness' };
    expect(markup(PhongControl, props)).toBe(
      '<phong-control for="a b" attribute="cutoff" max="60">softness</phong-control>',
    );
  });

  it('write lists of texts with commas, which labels may contain spaces between', () => {
    const labels = ['Gouraud shading', 'Phong'];
    expect(markup(PhongCompare, { labels })).toBe(
      '<phong-compare labels="Gouraud shading, Phong"></phong-compare>',
    );
    expect(markup(PhongViewer, { terms: ['ambient', 'diffuse'] })).toBe(
      '<phong-viewer terms="ambient, diffuse"></phong-viewer>',
    );
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

  it('omit a value that has no text form, which the client sets', () => {
    const props = { src: new Blob(['solid']) } as object;
    expect(markup(PhongViewer, props)).toBe('<phong-viewer></phong-viewer>');
  });
});
