// The judge of stills: pixels whose colour the equation gives by hand. The arithmetic is written
// out here, so that no code of the package judges itself.
import { describe, expect, it } from 'vitest';
import { still } from 'phong-viewer/still';

/** Odd: the middle pixel's centre is on the view's axis. */
const SIZE = 41;
const MIDDLE = 20;

/** The pixel of a viewer that looks along −z at the origin from 4 in front of it. */
async function pixelOf(
  viewer: string,
  content: string,
  [x, y] = [MIDDLE, MIDDLE],
): Promise<readonly number[]> {
  const view = 'theta="0" phi="90" radius="4" target="0 0 0"';
  const fov = viewer.includes('fov') ? '' : 'fov="1"';
  const markup = `<phong-viewer ${view} ${fov} ${viewer}>${content}</phong-viewer>`;
  const options = { width: SIZE, height: SIZE, threads: 1, warn: unexpected };
  const { pixels } = await still(markup, options);
  const at = 4 * (SIZE * y! + x!);
  return [...pixels.subarray(at, at + 4)];
}

function unexpected(message: string): void {
  throw new Error(message);
}

const degrees = (angle: number): number => (angle * Math.PI) / 180;
const cos = (angle: number): number => Math.cos(degrees(angle));
const sin = (angle: number): number => Math.sin(degrees(angle));
const grey = (value: number): readonly number[] => {
  const code = Math.round(255 * Math.min(Math.max(value, 0), 1));
  return [code, code, code, 255];
};

// A wall at z = 0 that faces the eye: N = V = 0 0 1.
const WALL =
  '<phong-mesh geometry="plane" rotation="90 0 0" kd="204" ks="153" ka="102" shininess="16"></phong-mesh>';
const sharp = (n: number): string => WALL.replace('shininess="16"', `shininess="${String(n)}"`);
const [KA, KD, KS] = [102 / 255, 204 / 255, 153 / 255];
const light = (values: string): string => `<phong-light ${values}></phong-light>`;
const fromSide = (angle: number, values: string): string =>
  light(`position="${String(sin(angle))} 0 ${String(cos(angle))} 0" ${values}`);
const DULL = 'specular="0"';
const SHINY = 'diffuse="0"';

describe('a still’s pixel', () => {
  it.each([0, 30, 60, 85])('has Kd · cos of %d° under a directional light', async (angle) => {
    expect(await pixelOf('', WALL + fromSide(angle, DULL))).toEqual(grey(KD * cos(angle)));
  });

  it.each([90.5, 120])('has nothing of a light %d° behind it', async (angle) => {
    expect(await pixelOf('', WALL + fromSide(angle, ''))).toEqual(grey(0));
  });

  it.each([
    [1, 70],
    [10, 20],
    [100, 8],
    [1000, 2],
    [0.5, 80],
  ])('has Ks · (R·V)^%d at %d°', async (n, angle) => {
    const expected = KS * cos(angle) ** n;
    expect(await pixelOf('', sharp(n) + fromSide(angle, SHINY))).toEqual(grey(expected));
  });

  it.each([
    [10, 40],
    [1000, 4],
  ])('has Ks · (N·H)^%d at %d° under Blinn–Phong', async (n, angle) => {
    const found = await pixelOf('reflection="blinn-phong"', sharp(n) + fromSide(angle, SHINY));
    expect(found).toEqual(grey(KS * cos(angle / 2) ** n));
  });

  it('has Ks whatever the angle at the exponent 0', async () => {
    expect(await pixelOf('', sharp(0) + fromSide(77, SHINY))).toEqual(grey(KS));
  });

  it.each([
    ['1 0.5 0', 1 / (1 + 0.5 * 2)],
    ['0.5 0 0.2', 1 / (0.5 + 0.2 * 4)],
    ['1 0.2 0.05', 1 / (1 + 0.2 * 2 + 0.05 * 4)],
    ['0.25 0.1 0', 1],
  ])('is attenuated by %s two units away', async (attenuation, expected) => {
    const lamp = light(`position="0 0 2" attenuation="${attenuation}" ${DULL} diffuse="200"`);
    expect(await pixelOf('', WALL + lamp)).toEqual(grey((KD * expected * 200) / 255));
  });

  it.each([
    [1, 60],
    [12, 25],
    [48, 10],
    [0.5, 150],
  ])('has ((1 + c)/2)^%d at %d° from a spot’s axis', async (cutoff, angle) => {
    const axis = `axis="${String(sin(angle))} 0 ${String(-cos(angle))}"`;
    const spot = light(`position="0 0 2" ${axis} cutoff="${String(cutoff)}" ${DULL}`);
    expect(await pixelOf('', WALL + spot)).toEqual(grey(KD * ((1 + cos(angle)) / 2) ** cutoff));
  });

  it.each([
    ['44.9', 0],
    ['45.1', KD],
    ['0.1', 0],
    ['180', KD],
  ])('is inside a cone of %s°, 45° from its axis, or not', async (aperture, expected) => {
    const spot = light(`position="0 0 2" axis="1 0 -1" aperture="${aperture}" ${DULL}`);
    expect(await pixelOf('', WALL + spot)).toEqual(grey(expected));
  });

  it('has half the light where a cone’s edge halves the pixel', async () => {
    // The cone's axis is 45° to the right: its edge on the wall is a hyperbola through the middle.
    const spot = light(`position="0 0 2" axis="1 0 -1" aperture="45" ${DULL}`);
    const [red] = await pixelOf('', WALL + spot);
    expect(Math.abs(red! - (255 * KD) / 2)).toBeLessThanOrEqual(2);
  });

  it('has Ka · Ia, without attenuation and with decay', async () => {
    const lamp = light(
      'position="0 0 2" ambient="120" diffuse="0" specular="0" attenuation="9 9 9"',
    );
    expect(await pixelOf('', WALL + lamp)).toEqual(grey((KA * 120) / 255));
  });

  it('sums the terms that are asked for', async () => {
    const lamp = fromSide(40, 'ambient="50"');
    const found = await pixelOf('terms="ambient diffuse"', WALL + lamp);
    expect(found).toEqual(grey((KA * 50) / 255 + KD * cos(40)));
  });

  it('decodes colours first and encodes the sum under linear', async () => {
    const decode = (c: number): number => ((c / 255 + 0.055) / 1.055) ** 2.4;
    const encode = (l: number): number => 1.055 * l ** (1 / 2.4) - 0.055;
    const lamp = fromSide(50, `${DULL} diffuse="180"`);
    const found = await pixelOf('color-interpolation="linear"', WALL + lamp);
    expect(found).toEqual(grey(encode(decode(204) * decode(180) * cos(50))));
  });

  it('is lit from the eye by a light in camera space', async () => {
    const lamp = light(`space="camera" position="0 0 -2 1" attenuation="1 0.5 0" ${DULL}`);
    expect(await pixelOf('', WALL + lamp)).toEqual(grey(KD / 2));
  });

  const lit = (geometry: string): string =>
    `<phong-mesh geometry="${geometry}" kd="204" ks="0"></phong-mesh>`;

  it('has the normal of a cylinder, a cone and a box', async () => {
    const lamp = fromSide(0, DULL);
    expect(await pixelOf('', lit('cylinder') + lamp)).toEqual(grey(KD));
    // Half as wide as high: its normals rise by 1 for 2 outward.
    expect(await pixelOf('', lit('cone') + lamp)).toEqual(grey((KD * 2) / Math.sqrt(5)));
    expect(await pixelOf('', lit('box') + fromSide(35, DULL))).toEqual(grey(KD * cos(35)));
  });

  it.each([
    [MIDDLE, MIDDLE],
    [25, 17],
    [10, 28],
    [29, 11],
  ])('has the normal of a sphere at %d, %d', async (x, y) => {
    const fov = 20;
    const slope = Math.tan(degrees(fov) / 2);
    const a = ((2 * (x + 0.5)) / SIZE - 1) * slope;
    const b = (1 - (2 * (y + 0.5)) / SIZE) * slope;
    // |(0, 0, 4) + t (a, b, −1)| = 1/2.
    const s = a * a + b * b + 1;
    const t = (4 - Math.sqrt(16 - s * (16 - 0.25))) / s;
    const p = [t * a, t * b, 4 - t] as const;
    const toLamp = [2 - p[0], 1 - p[1], 3 - p[2]] as const;
    const NoL =
      (2 * (p[0] * toLamp[0] + p[1] * toLamp[1] + p[2] * toLamp[2])) / Math.hypot(...toLamp);
    const lamp = light(`position="2 1 3" ${DULL}`);
    const [red] = await pixelOf(`fov="${String(fov)}"`, lit('sphere') + lamp, [x, y]);
    // The mean over the pixel's square is not its middle: the sphere bends.
    expect(Math.abs(red! - 255 * KD * Math.max(NoL, 0))).toBeLessThanOrEqual(1);
  });
});
