// Does the picture follow the table of limits at degenerate input? A light floor seen from straight
// above; the middle pixel is the world's origin. The expected codes are computed by hand from the
// table.
import { expect, pixelAt, pixels, test } from '../support/test.js';

/** Odd, so that one pixel's centre is the picture's. */
const SIZE = { width: 101, height: 101 };
const MIDDLE = 50;
/** About a third of the way to the floor's corner. */
const ASIDE = 70;

/** The first of two attributes of one name counts: `view` and `mesh` win. */
const viewer = (light: string, mesh = '', view = '') =>
  `<phong-viewer ${view} theta="0" phi="0" radius="3" target="0 0 0" fov="40">
     <phong-mesh geometry="plane" ${mesh} scale="2" ka="255" kd="255" ks="0"></phong-mesh>
     <phong-light ${light}></phong-light>
   </phong-viewer>`;

const AMBIENT = 'diffuse="0" specular="0" ambient';
const MATTE = 'specular="0" diffuse';
const GLOSS = 'diffuse="0" specular="255"';
const ALL = 'ambient="90" diffuse="255" specular="255"';
const MIRROR = 'ka="0" kd="0" ks';
const SLANTED = Math.round(200 * ((1 + Math.SQRT1_2) / 2) ** 2);

/**
 * What the table says; a light; the codes in the middle and aside, null where the table says
 * nothing.
 */
type Row = readonly [
  says: string,
  light: string,
  middle: number,
  aside: number | null,
  mesh?: string,
  view?: string,
];

// oxfmt-ignore
const ROWS: readonly Row[] = [
  ['shininess 0 makes the specular term constant where light arrives',
    `position="5 1 0 0" ${GLOSS}`, 100, 100, `${MIRROR}="100" shininess="0"`],
  ['shininess below 1e-6 counts as 0',
    `position="5 1 0 0" ${GLOSS}`, 100, 100, `${MIRROR}="100" shininess="9e-7"`],
  ['shininess 0 gives nothing where light comes from behind',
    `position="0 -1 0 0" ${GLOSS}`, 0, 0, `${MIRROR}="100" shininess="0"`],
  ['a specular base of 0 to a small power is 0, not 1',
    `position="1 1e-12 0 0" ${GLOSS}`, 0, null, `${MIRROR}="255" shininess="1"`],
  ['a spot whose back is turned to a fragment decays to 0 there',
    `position="0 1 0 1" axis="0 1 0" cutoff="0.5" ${AMBIENT}="200"`, 0, null],
  ['cutoff below 1e-6 means no decay, behind the spot too',
    `position="0 1 0 1" axis="0 1 0" cutoff="9e-7" ${AMBIENT}="200"`, 200, 200],
  ['aperture 180 lets the fragment behind the spot through',
    `position="0 1 0 1" axis="0 1 0" aperture="180" ${MATTE}="150"`, 150, null],
  ['aperture 0 lights only what is exactly on the axis',
    `position="0 1 0 1" axis="0 -1 0" aperture="0" ${AMBIENT}="80"`, 80, 0],
  ['a zero axis means neither cone nor decay',
    `position="0 1 0 1" axis="0 0 0" aperture="1" cutoff="1000" ${AMBIENT}="60"`, 60, 60],
  ['a light at the fragment brings its ambient light only',
    `position="0 0 0 1" ${ALL}`, 90, null, 'ks="255"'],
  ['a spot at the fragment has it inside its cone, undecayed',
    `position="0 0 0 1" axis="0 1 0" aperture="1" cutoff="1e6" ${ALL}`, 90, null, 'ks="255"'],
  ['a directional light without a direction brings its ambient light only',
    `position="0 0 0 0" ${ALL}`, 90, 90, 'ks="255"'],
  ['a directional spot without a direction keeps its ambient light',
    'position="0 0 0 0" axis="0 -1 0" aperture="10" cutoff="5" ambient="70"', 70, 70],
  ['attenuation 0 0 0 takes nothing',
    `position="0 1 0 1" ${MATTE}="140" attenuation="0 0 0"`, 140, null],
  ['attenuation below 1 never brightens',
    `position="0 0.5 0 1" ${MATTE}="140" attenuation="0.1 0.1 0"`, 140, null],
  ['a directional light takes no attenuation',
    `position="0 1 0 0" ${MATTE}="140" attenuation="4 1 1"`, 140, 140],
  ['a directional spot is all inside its cone, or all outside',
    `position="0 1 0 0" axis="1 -1 0" aperture="44" ${MATTE}="140"`, 0, 0],
  ['a directional spot decays by the angle between its axis and its direction',
    `position="0 1 0 0" axis="1 -1 0" cutoff="2" ${MATTE}="200"`, SLANTED, SLANTED],
  ['a mesh flattened along its normal keeps its normal',
    `position="0 1 0 0" ${MATTE}="140"`, 140, 140, 'scale="2 0 2"'],
  ['a mirrored mesh keeps its normals outside',
    `position="0 1 0 0" ${MATTE}="140"`, 140, 140, 'scale="-2 2 2"'],
  ['a scene of 1e12 along the normal is lit as any',
    `position="0 1 0 0" ${MATTE}="140"`, 140, 140, 'scale="2 1e12 2"'],
  // One quad, whose corners are √2 from the middle and the light 1 above it: N·L is 1/√3 at each of
  // them, and so in between; per fragment the middle would have 1.
  ['the colours of vertices are interpolated under Gouraud shading',
    `position="0 1 0 1" ${MATTE}="255"`, 147, 147, '', 'shading="gouraud"'],
  ['the visible side is lit under Gouraud shading, also from below',
    `position="0 -1 0 0" ${MATTE}="120"`, 120, 120, '', 'phi="180" shading="gouraud"'],
  ['no light is drawn if `terms` is empty',
    'position="0 1 0 0" ambient="50" diffuse="120"', 0, 0, '', 'terms=""'],
];

test('follows every row of the table of limits', async ({ mount, page }) => {
  await mount(ROWS.map(([, light, , , mesh, view]) => viewer(light, mesh, view)).join(''), SIZE);
  for (const [i, [says, , middle, aside]] of ROWS.entries()) {
    const picture = await pixels(page.locator('phong-viewer').nth(i), SIZE);
    const grey = (code: number) => [code, code, code, 255];
    expect.soft(pixelAt(picture, MIDDLE, MIDDLE), says).toEqual(grey(middle));
    if (aside !== null) {
      expect.soft(pixelAt(picture, ASIDE, MIDDLE), says).toEqual(grey(aside));
    }
  }
});
