// What happens to programs after their first draw? Broken ones are reported, and the attribute
// lists of the others stay as they are.
import type { WebGLRenderer } from 'three';
import { expect, it, vi } from 'vitest';
import { checkLinks } from '../../../src/phong/material/program/three-programs.js';

/** A renderer whose programs have linked, or have not. */
function drawn(links: boolean) {
  const attributes = { position: {} };
  const program = { program: {}, isReady: () => true, getAttributes: () => attributes };
  const gl = {
    getProgramParameter: () => links,
    isContextLost: () => false,
    getAttachedShaders: () => [],
    getProgramInfoLog: () => 'broken by hand',
  };
  const renderer = { info: { programs: [program] }, getContext: () => gl };
  return { attributes, renderer: renderer as unknown as WebGLRenderer };
}

it('freezes the list of a program’s attributes', () => {
  const { attributes, renderer } = drawn(true);
  checkLinks(renderer);
  expect(Object.isExtensible(attributes)).toBe(false);
});

it('reports a program that does not link, once', () => {
  const reported = vi.fn();
  vi.stubGlobal('reportError', reported);
  const { renderer } = drawn(false);
  checkLinks(renderer);
  checkLinks(renderer);
  expect(reported).toHaveBeenCalledTimes(1);
  expect(String(reported.mock.calls[0]?.[0])).toContain('broken by hand');
  vi.unstubAllGlobals();
});

it('does not report a program whose context is lost while it links', () => {
  const reported = vi.fn();
  vi.stubGlobal('reportError', reported);
  const { renderer } = drawn(false);
  const gl = renderer.getContext();
  let lost = false;
  gl.isContextLost = () => lost;
  gl.getProgramParameter = () => {
    lost = true;
    return null;
  };
  checkLinks(renderer);
  expect(reported).not.toHaveBeenCalled();
  vi.unstubAllGlobals();
});
