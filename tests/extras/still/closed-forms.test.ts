// Pixels of stills whose colour the equation gives by hand. The arithmetic is written out here, so
// that no code of the package judges itself. lights.test.ts has the sums at any point, caster.test.ts
// spheres.
import { describe, expect, it } from 'vitest';
import { still } from 'phong-viewer/still';

/** Odd: the middle pixel's centre is on the view's axis. */
const SIZE = 41;

/** The middle pixel of a viewer that looks along −z at the origin from 4 in front of it. */
async function pixelOf(viewer: string, content: string): Promise<readonly number[]> {
  const view = 'theta="0" phi="90" radius="4" target="0 0 0" fov="1"';
  const markup = `<phong-viewer ${view} ${viewer}>${content}</phong-viewer>`;
  const options = { width: SIZE, height: SIZE, threads: 1, warn: unexpected };
  const { pixels } = await still(markup, options);
  const at = 2 * (SIZE ** 2 - 1);
  return [...pixels.subarray(at, at + 4)];
}

function unexpected(message: string): void {
  throw new Error(message);
}

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const cos = (degrees: number) => Math.cos(radians(degrees));
const sin = (degrees: number) => Math.sin(radians(degrees));

// A wall at z = 0 that faces the eye: N = V = 0 0 1.
const WALL =
  '<phong-mesh geometry="plane" rotation="90 0 0" kd="204" ks="153" ka="102" shininess="16"></phong-mesh>';
const [KA, KD, KS] = [102 / 255, 204 / 255, 153 / 255];
const shape = (geometry: string) =>
  `<phong-mesh geometry="${geometry}" kd="204" ks="0"></phong-mesh>`;
const light = (values: string) => `<phong-light ${values}></phong-light>`;
const fromSide = (degrees: number, values: string) =>
  light(`position="${String(sin(degrees))} 0 ${String(cos(degrees))} 0" ${values}`);
const DULL = 'specular="0"';

const decode = (code: number) => ((code / 255 + 0.055) / 1.055) ** 2.4;
const encode = (linear: number) => 1.055 * linear ** (1 / 2.4) - 0.055;
const LAMP = `position="0 0 2" axis="${String(sin(25))} 0 ${String(-cos(25))}" cutoff="12"`;
const EYE_LAMP = `space="camera" position="0 0 -2 1" attenuation="1 0.5 0" ${DULL}`;

describe('a still’s pixel', () => {
  it.each([
    ['a sun', '', WALL + fromSide(60, DULL), KD * cos(60)],
    ['a sun behind it', '', WALL + fromSide(90.5, ''), 0],
    ['a highlight', '', WALL + fromSide(20, 'diffuse="0"'), KS * cos(20) ** 16],
    [
      'Blinn’s highlight',
      'reflection="blinn-phong"',
      WALL + fromSide(30, 'diffuse="0"'),
      KS * cos(15) ** 16,
    ],
    [
      'decay, of Ka too',
      '',
      WALL + light(`${LAMP} ${DULL} ambient="50" diffuse="200"`),
      ((KA * 50 + KD * 200) / 255) * ((1 + cos(25)) / 2) ** 12,
    ],
    [
      'two of the terms',
      'terms="ambient diffuse"',
      WALL + fromSide(40, 'ambient="50"'),
      (KA * 50) / 255 + KD * cos(40),
    ],
    [
      'linear light',
      'color-interpolation="linear"',
      WALL + fromSide(50, `${DULL} diffuse="180"`),
      encode(decode(204) * decode(180) * cos(50)),
    ],
    ['a lamp at the eye', '', WALL + light(EYE_LAMP), KD / 2],
    ['a cylinder', '', shape('cylinder') + fromSide(0, DULL), KD],
    // Half as wide as high: its normals rise by 1 for 2 outward.
    ['a cone', '', shape('cone') + fromSide(0, DULL), (KD * 2) / Math.sqrt(5)],
    ['a box', '', shape('box') + fromSide(35, DULL), KD * cos(35)],
  ])('has the equation’s colour by hand: %s', async (_, viewer, content, value) => {
    const code = Math.round(255 * value);
    expect(await pixelOf(viewer, content)).toEqual([code, code, code, 255]);
  });

  it('has half the light where a cone’s edge halves the pixel', async () => {
    // The cone's axis is 45° to the right: its edge on the wall is a hyperbola through the middle.
    const spot = light(`position="0 0 2" axis="1 0 -1" aperture="45" ${DULL}`);
    const [red] = await pixelOf('', WALL + spot);
    expect(Math.abs(red! - (255 * KD) / 2)).toBeLessThanOrEqual(2);
  });
});
