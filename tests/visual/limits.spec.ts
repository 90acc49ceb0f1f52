// Does the picture follow the table of limits at degenerate input? A light floor seen from straight above; the middle
// pixel is the world's origin. The expected codes are computed by hand from the table.
import { expect, pixelAt, pixels, test } from '../support/test.js';

/** Odd, so that one pixel's centre is the picture's. */
const SIZE = { width: 101, height: 101 };
const MIDDLE = 50;
/** About a third of the way to the floor's corner. */
const ASIDE = 70;

/** The first of two attributes of one name counts: `mesh` wins. */
const viewer = (light: string, mesh = ''): string =>
  `<phong-viewer theta="0" phi="0" radius="3" target="0 0 0" fov="40">
     <phong-mesh geometry="plane" ${mesh} scale="2" ka="255" kd="255" ks="0"></phong-mesh>
     <phong-light ${light}></phong-light>
   </phong-viewer>`;

const DARK = 'diffuse="0" specular="0"';

interface Row {
  readonly says: string;
  readonly light: string;
  readonly mesh?: string;
  readonly middle?: number;
  readonly aside?: number;
}

const rows: readonly Row[] = [
  {
    says: 'shininess 0 makes the specular term constant where light arrives',
    light: 'position="5 1 0 0" diffuse="0" specular="255"',
    mesh: 'ka="0" kd="0" ks="100" shininess="0"',
    middle: 100,
    aside: 100,
  },
  {
    says: 'shininess below 1e-6 counts as 0',
    light: 'position="5 1 0 0" diffuse="0" specular="255"',
    mesh: 'ka="0" kd="0" ks="100" shininess="9e-7"',
    middle: 100,
    aside: 100,
  },
  {
    says: 'shininess 0 gives nothing where light comes from behind',
    light: 'position="0 -1 0 0" diffuse="0" specular="255"',
    mesh: 'ka="0" kd="0" ks="100" shininess="0"',
    middle: 0,
    aside: 0,
  },
  {
    says: 'a specular base of 0 to a small power is 0, not 1',
    light: 'position="1 1e-12 0 0" diffuse="0" specular="255"',
    mesh: 'ka="0" kd="0" ks="255" shininess="1"',
    middle: 0,
  },
  {
    says: 'a spot whose back is turned to a fragment decays to 0 there',
    light: `position="0 1 0 1" axis="0 1 0" cutoff="0.5" ambient="200" ${DARK}`,
    middle: 0,
  },
  {
    says: 'cutoff below 1e-6 means no decay, behind the spot too',
    light: `position="0 1 0 1" axis="0 1 0" cutoff="9e-7" ambient="200" ${DARK}`,
    middle: 200,
    aside: 200,
  },
  {
    says: 'aperture 180 lets the fragment behind the spot through',
    light: 'position="0 1 0 1" axis="0 1 0" aperture="180" diffuse="150" specular="0"',
    middle: 150,
  },
  {
    says: 'aperture 0 lights only what is exactly on the axis',
    light: `position="0 1 0 1" axis="0 -1 0" aperture="0" ambient="80" ${DARK}`,
    middle: 80,
    aside: 0,
  },
  {
    says: 'a zero axis means neither cone nor decay',
    light: `position="0 1 0 1" axis="0 0 0" aperture="1" cutoff="1000" ambient="60" ${DARK}`,
    middle: 60,
    aside: 60,
  },
  {
    says: 'a light at the fragment brings its ambient light only',
    light: 'position="0 0 0 1" ambient="90" diffuse="255" specular="255"',
    mesh: 'ks="255"',
    middle: 90,
  },
  {
    says: 'a spot at the fragment has it inside its cone, undecayed',
    light:
      'position="0 0 0 1" axis="0 1 0" aperture="1" cutoff="1e6" ambient="90" diffuse="255" specular="255"',
    mesh: 'ks="255"',
    middle: 90,
  },
  {
    says: 'a directional light without a direction brings its ambient light only',
    light: 'position="0 0 0 0" ambient="70" diffuse="255" specular="255"',
    mesh: 'ks="255"',
    middle: 70,
    aside: 70,
  },
  {
    says: 'a directional spot without a direction keeps its ambient light',
    light: 'position="0 0 0 0" axis="0 -1 0" aperture="10" cutoff="5" ambient="70"',
    middle: 70,
    aside: 70,
  },
  {
    says: 'attenuation 0 0 0 takes nothing',
    light: 'position="0 1 0 1" diffuse="140" specular="0" attenuation="0 0 0"',
    middle: 140,
  },
  {
    says: 'attenuation below 1 never brightens',
    light: 'position="0 0.5 0 1" diffuse="140" specular="0" attenuation="0.1 0.1 0"',
    middle: 140,
  },
  {
    says: 'a directional light takes no attenuation',
    light: 'position="0 1 0 0" diffuse="140" specular="0" attenuation="4 1 1"',
    middle: 140,
    aside: 140,
  },
  {
    says: 'a directional spot is all inside its cone, or all outside',
    light: 'position="0 1 0 0" axis="1 -1 0" aperture="44" diffuse="140" specular="0"',
    middle: 0,
    aside: 0,
  },
  {
    says: 'a directional spot decays by the angle between its axis and its direction',
    light: 'position="0 1 0 0" axis="1 -1 0" cutoff="2" diffuse="200" specular="0"',
    middle: Math.round(200 * ((1 + Math.SQRT1_2) / 2) ** 2),
    aside: Math.round(200 * ((1 + Math.SQRT1_2) / 2) ** 2),
  },
  {
    says: 'a mesh flattened along its normal keeps its normal',
    light: 'position="0 1 0 0" diffuse="140" specular="0"',
    mesh: 'scale="2 0 2"',
    middle: 140,
    aside: 140,
  },
  {
    says: 'a mirrored mesh keeps its normals outside',
    light: 'position="0 1 0 0" diffuse="140" specular="0"',
    mesh: 'scale="-2 2 2"',
    middle: 140,
    aside: 140,
  },
  {
    says: 'a scene of 1e12 along the normal is lit as any',
    light: 'position="0 1 0 0" diffuse="140" specular="0"',
    mesh: 'scale="2 1e12 2"',
    middle: 140,
    aside: 140,
  },
];

test('follows every row of the table of limits', async ({ mount, page }) => {
  // One page for all: a page each would take twenty times as long.
  await mount(rows.map(({ light, mesh }) => viewer(light, mesh)).join(''), SIZE);
  for (const [i, { says, middle, aside }] of rows.entries()) {
    const picture = await pixels(page.locator('phong-viewer').nth(i), SIZE);
    const grey = (code: number): number[] => [code, code, code, 255];
    if (middle !== undefined) expect.soft(pixelAt(picture, MIDDLE, MIDDLE), says).toEqual(grey(middle));
    if (aside !== undefined) expect.soft(pixelAt(picture, ASIDE, MIDDLE), says).toEqual(grey(aside));
  }
});

test('interpolates the colours of vertices under Gouraud shading', async ({ mount }) => {
  // One quad: the corners are 2√2/2 from the origin on the floor, the light 1 above it.
  const element = await mount(
    viewer('position="0 1 0 1" diffuse="255" specular="0"').replace('fov=', 'shading="gouraud" fov='),
    SIZE,
  );
  // NoL at every corner is 1/√3, and so it is in between; per fragment the middle would have 1.
  const corner = Math.round(255 / Math.sqrt(3));
  const picture = await pixels(element, SIZE);
  for (const x of [MIDDLE, ASIDE]) expect(pixelAt(picture, x, MIDDLE)).toEqual([corner, corner, corner, 255]);
});

test('lights the visible side under Gouraud shading, also from below', async ({ mount }) => {
  const element = await mount(
    viewer('position="0 -1 0 0" diffuse="120" specular="0"').replace(
      'phi="0"',
      'phi="180" shading="gouraud"',
    ),
    SIZE,
  );
  expect(pixelAt(await pixels(element, SIZE), MIDDLE, MIDDLE)).toEqual([120, 120, 120, 255]);
});

test('draws no light if `terms` is empty', async ({ mount }) => {
  const element = await mount(
    viewer('position="0 1 0 0" ambient="50" diffuse="120"').replace('fov=', 'terms="" fov='),
    SIZE,
  );
  expect(pixelAt(await pixels(element, SIZE), MIDDLE, MIDDLE)).toEqual([0, 0, 0, 255]);
});
