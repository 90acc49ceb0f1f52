// What markup becomes: other shadings, views, models, files, and what is refused or warned of.
import { readFileSync } from 'node:fs';
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { still } from 'phong-viewer/still';
import { readPage } from '../../../src/extras/still/command/page.js';
import { castSceneOf } from '../../../src/extras/still/build-scene.js';
import { decodeImage } from '../../../src/extras/still/images.js';
import { readMarkup } from '../../../src/extras/still/markup.js';
import { checksum, chunk, joined } from '../../../src/extras/png/chunks.js';
import type { Quantity } from '../../../src/phong/material/view/view-table.js';
import { patch, type Texel } from '../../support/gltf.js';

const SIZE = 21;
const MIDDLE = 10;

async function draw(markup: string, size = SIZE) {
  const warnings: string[] = [];
  const options = { width: size, height: size, threads: 1 };
  const made = await still(markup, { ...options, warn: (text) => warnings.push(text) });
  const at = (x: number, y: number): readonly number[] => [
    ...made.pixels.subarray(4 * (y * size + x), 4 * (y * size + x) + 4),
  ];
  return { ...made, warnings, at, middle: at(MIDDLE, MIDDLE) };
}

const FRONT = 'theta="0" phi="90" radius="4" target="0 0 0"';
const SUN = '<phong-light position="0 0 1 0" specular="0"></phong-light>';
const front = (mesh: string, viewer = 'fov="1"', light = SUN) =>
  `<phong-viewer ${FRONT} ${viewer}>${light}${mesh}</phong-viewer>`;
const WALL = '<phong-mesh geometry="plane" rotation="90 0 0"></phong-mesh>';

/** A patch that shows a texture as it is. `use`: of the texture; `more`: of its material. */
function textured(texels: readonly Texel[], use?: object, more?: object) {
  const pbrMetallicRoughness = { baseColorTexture: { index: 0, ...use } };
  const material = { extensions: { KHR_materials_unlit: {} }, pbrMetallicRoughness, ...more };
  return patch({ material, textures: [texels] });
}

/** Black below, white above. */
const FADE = 'data:,v -1 -1 0 0 0 0%0Av 1 -1 0 0 0 0%0Av 1 1 0 1 1 1%0Av -1 1 0 1 1 1%0Af 1 2 3 4';

/** A white wall, and before it a black strip. */
const STRIP = `<phong-mesh kd="255" src="data:,${encodeURIComponent(`
v -9 -9 0 1 1 1
v 9 -9 0 1 1 1
v 9 9 0 1 1 1
v -9 9 0 1 1 1
v 0.01 -0.5 1 0 0 0
v 0.02 -0.5 1 0 0 0
v 0.02 0.5 1 0 0 0
v 0.01 0.5 1 0 0 0
f 1 2 3 4
f 5 6 7 8
`)}"></phong-mesh>`;

/** Exif data, in the order of bytes of "MM". */
const ORIENTATION_6 = 'MM\0*\0\0\0\b\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0';

describe('a still', () => {
  it('is a PNG of its pixels', async () => {
    const { png, pixels } = await draw(front('<phong-mesh geometry="torus"></phong-mesh>', ''));
    expect(PNG.sync.read(Buffer.from(png)).data.equals(Buffer.from(pixels))).toBe(true);
  });

  it('frames the scene, and lights it from the eye where it has no light', async () => {
    const { middle, at } = await draw('<phong-viewer geometry="sphere"></phong-viewer>');
    // Kd + Ks where the surface faces the eye.
    expect(middle).toEqual([255, 255, 255, 255]);
    expect(at(0, 0)[3]).toBe(0);
    // The sphere fills 1/1.05 of the smaller side.
    expect(at(0, MIDDLE)[3]).toBeLessThan(255);
    expect(at(1, MIDDLE)[3]).toBe(255);
  });

  // The second box has faces in the planes of the last one's.
  it.each(['box', 'box" scale="0.7 0.6 1', 'sphere', 'cylinder', 'torus-knot'])(
    'shows the last %s of two',
    async (name) => {
      const [red, blue] = [name, name.split('"')[0]!].map(
        (shape, i) =>
          `<phong-mesh geometry="${shape}" ka="0" ks="0" kd="${['255 0 0', '0 0 255'][i]!}"></phong-mesh>`,
      );
      const { pixels } = await draw(`<phong-viewer>${red}${blue}</phong-viewer>`);
      expect(pixels.some((code, i) => i % 4 === 0 && code > 0)).toBe(false);
    },
  );

  it.each([
    ['box', 'scale="2 0.01 0.01" rotation="0 0 3"', 0.02],
    ['cylinder', 'scale="0.01 2 0.01" rotation="0 0 33"', 0.02],
    ['sphere', 'scale="0.02"', Math.PI / 1e4],
    ['strip of the wall’s model', STRIP, 0.01],
  ])('shows a %s thinner than a pixel before a wall, by its area', async (name, size, area) => {
    const thin = `<phong-mesh geometry="${name}" ${size} kd="0" position="0.03 0.04 1"></phong-mesh>`;
    const wall = WALL.replace('>', ' scale="9" kd="255">');
    const { pixels } = await draw(front(size === STRIP ? STRIP : wall + thin, ''));
    const dark = pixels.reduce((sum, code, i) => sum + (i % 4 === 0 ? 1 - code / 255 : 0), 0);
    const pixel = (2 * 3 * Math.tan(Math.PI / 8)) / SIZE;
    expect((dark * pixel ** 2) / area).toBeCloseTo(1, 0.7);
  });

  it('interpolates the corners’ sums under Gouraud shading', async () => {
    const lamp = '<phong-light position="0.5 0.5 1" specular="0"></phong-light>';
    const { middle } = await draw(front(WALL, 'fov="1" shading="gouraud"', lamp));
    // The middle lies between two opposite corners: 1 above the wall and √2 beside the lamp, or the
    // one under the lamp.
    const corners = [
      [1, 1 / Math.sqrt(3)],
      [1 / Math.sqrt(2), 1 / Math.sqrt(2)],
    ];
    const means = corners.map(([a, b]) => Math.round((200 * (a! + b!)) / 2));
    expect(means).toContain(middle[0]);
  });

  it('has the triangles’ own normals under flat shading', async () => {
    const { at } = await draw(
      front(
        '<phong-mesh geometry="cylinder" segments="4" shading="flat"></phong-mesh>',
        'fov="10"',
      ),
    );
    expect(at(MIDDLE + 4, MIDDLE)[0]).toBe(Math.round(200 * Math.SQRT1_2));
  });

  const grey = (n: number) => [n, n, n];
  const ofViews = {
    normals: [128, 128, 255],
    'n-dot-l': grey(255),
    'r-dot-v': grey(255),
    attenuation: grey(142),
    decay: grey(64),
    diffuse: grey(100),
    ambient: grey(0),
  } satisfies Record<Quantity | 'diffuse' | 'ambient', number[]>;

  it.each(Object.entries(ofViews))('shows the view %s', async (view, color) => {
    const { middle } = await draw(
      front(
        WALL,
        `fov="1" view="${view}"`,
        '<phong-light position="0 0 2" axis="1 0 0" cutoff="2" attenuation="1 0.4 0" diffuse="918"></phong-light>',
      ),
    );
    expect(middle).toEqual([...color, 255]);
  });

  it('shows nothing lit for a light that view-light names in vain, and says so', async () => {
    const { middle, warnings } = await draw(front(WALL, 'fov="1" view-light="moon"'));
    expect(middle).toEqual([0, 0, 0, 255]);
    expect(warnings).toEqual([
      '<phong-viewer view-light="moon">: no light has this name, so none is shown. Names of lights: "light 1".',
    ]);
  });

  it('shows the head-light for its name', async () => {
    const { middle, warnings } = await draw(front(WALL, 'fov="1" view-light="head-light"', ''));
    expect(warnings).toEqual([]);
    expect(middle).toEqual([255, 255, 255, 255]);
  });

  it('blends what a file declares translucent over what lies behind it', async () => {
    const glass = (texel: Texel, place: string) =>
      `<phong-mesh src="${textured([texel], {}, { alphaMode: 'BLEND' })}" ${place}></phong-mesh>`;
    const red = glass([255, 0, 0, 102], 'position="0 0 1"');
    const { middle } = await draw(front(red + WALL));
    expect(middle).toEqual([Math.round(0.4 * 255 + 0.6 * 200), 120, 120, 255]);
    const { middle: alone } = await draw(front(red));
    expect(alone).toEqual([255, 0, 0, 102]);
    // Its origin is nearer than the red one's, and its surface farther away.
    const blue = glass([0, 0, 255, 102], 'position="0 0 2" scale="1 1 -10"');
    expect((await draw(front(red + blue))).middle).toEqual([159, 0, 96, 163]);
  });

  it.each([4000, 1])('refuses a PNG of 9 rows whose header says %i', async (height) => {
    const bytes = new Uint8Array(PNG.sync.write(new PNG({ width: 9, height: 9 })));
    const view = new DataView(bytes.buffer);
    view.setUint32(20, height);
    view.setInt32(29, checksum(bytes.subarray(12, 29)));
    await expect(decodeImage({ bytes, type: '' })).rejects.toThrow('is damaged');
  });

  it.each(['\x89PNG', '\xff\xd8\xff\xdb'])(
    'says in its own words that %j… is damaged',
    async (start) => {
      const bytes = Buffer.alloc(200);
      bytes.write(start, 'latin1');
      await expect(decodeImage({ bytes, type: '' })).rejects.toThrow(/^is damaged$/);
    },
  );

  it.each([
    ['a texel’s colour', textured([[200, 100, 50]]), '', [200, 100, 50, 255]],
    [
      'nothing that a mask cuts away',
      textured([[200, 100, 50, 100]], {}, { alphaMode: 'MASK' }),
      '',
      [0, 0, 0, 0],
    ],
    [
      // The middle, (0.5, 0.5), is scaled to (0.25, 0.5), turned to (0.5, -0.25), and moved to the
      // middle of the third texel of the first row.
      'a texture moved as glTF says: first the scale, then the turn',
      textured(
        Array.from({ length: 16 }, (_, i) => [10 * i, 10 * i, 10 * i] as const),
        {
          extensions: {
            KHR_texture_transform: {
              scale: [0.5, 1],
              rotation: Math.PI / 2,
              offset: [0.125, 0.375],
            },
          },
        },
      ),
      '',
      [20, 20, 20, 255],
    ],
    [
      'no normal maps under Gouraud shading, in no view',
      patch({ material: { normalTexture: { index: 0 } }, textures: [[[255, 128, 128]]] }),
      'shading="gouraud" view="normals"',
      [128, 128, 255, 255],
    ],
    ['vertex colours mixed as they are stored', FADE, '', [128, 128, 128, 255]],
    [
      'vertex colours decoded under linear',
      FADE,
      'color-interpolation="linear"',
      [188, 188, 188, 255],
    ],
    // Half red and half blue, times a base colour of 0.5 1 0.7354 as it is encoded. Beside the middle,
    // green begins.
    ['linear vertex colours, encoded after', fixture('vertex-colours.glb'), '', [94, 2, 138, 255]],
    [
      'linear vertex colours in linear',
      fixture('vertex-colours.glb'),
      'color-interpolation="linear"',
      [92, 2, 137, 255],
    ],
  ])('has %s', async (_, src, viewer, expected) => {
    const { middle } = await draw(
      front(`<phong-mesh src="${src}" kd="255"></phong-mesh>`, `fov="1" ${viewer}`),
    );
    expect(middle).toEqual(expected);
  });

  it.each([
    ['keeps the colour that a PNG declares transparent', 'tRNS', '\0\t\0\b\0\x07', '9,8,7,0'],
    ['refuses to turn an image', 'eXIf', ORIENTATION_6, 'cannot turn'],
    ['reads no orientation elsewhere', 'teSt', ORIENTATION_6, '9,8,7'],
  ])('%s', async (_, type, text, expected) => {
    const image = new PNG({ width: 1, height: 1 });
    image.data.set([9, 8, 7, 255]);
    const file = PNG.sync.write(image, { colorType: 2 });
    const bytes = joined([file.subarray(0, 33), chunk(type, Buffer.from(text)), file.subarray(33)]);
    const found = await decodeImage({ bytes, type: '' }).then(({ data }) => data.join(), String);
    expect(found).toContain(expected);
  });

  it('reads the colours of a JPEG by its markers, as browsers do', async () => {
    const bytes = new Uint8Array(
      readFileSync(
        new URL('../../../demo/assets/models/real/spider/engineflare1.jpg', import.meta.url),
      ),
    );
    const decode = async () => (await decodeImage({ bytes, type: '' })).data;
    const given = await decode();
    // Adobe's marker in place of JFIF's, for YCbCr.
    bytes.set([0xee, 0, 16, ...Buffer.from('Adobe\0\0\0\0\0\0\x01')], 3);
    expect(await decode()).toEqual(given);
    // For r, g and b: where there is no chroma, the last two are half-way.
    bytes[17] = 0;
    expect((await decode()).subarray(0, 3).join()).toBe('7,128,128');
  });

  it.each(['no-normals.glb', 'coloured.ply', 'coloured.stl', 'quads.obj'])(
    'reads %s',
    async (file) => {
      const { pixels } = await draw(`<phong-viewer src="${fixture(file)}"></phong-viewer>`);
      expect(pixels.filter((value, i) => i % 4 === 3 && value === 255).length).toBeGreaterThan(50);
    },
  );
});

describe('a still of many meshes', () => {
  it('reads a file once, and lets meshes share the triangles of their shape', async () => {
    const read: string[] = [];
    const model = `<phong-mesh src="${fixture('coloured.ply')}"></phong-mesh>`;
    const ball = '<phong-mesh geometry="sphere"></phong-mesh>';
    const markup = `<phong-viewer>${(model + ball).repeat(3)}</phong-viewer>`;
    const warn = () => undefined;
    const { objects } = await castSceneOf(
      readMarkup(markup, warn),
      { width: SIZE, height: SIZE },
      { base: undefined, warn, onFile: ({ href }) => read.push(href) },
    );
    expect(new Set(objects.map(({ shape }) => shape)).size).toBe(2);
    expect(read).toHaveLength(1);
  });

  it('counts what its models claim together', async () => {
    const src = (own: number) => {
      const json = JSON.parse(atob(patch({ material: {} }).split(',')[1]!)) as object;
      const text = JSON.stringify({ ...json, extras: Array.from({ length: 1.2e6 }, () => own) });
      return `data:,${encodeURIComponent(text)}`;
    };
    const models = [1, 2].map((own) => `<phong-mesh src="${src(own)}"></phong-mesh>`);
    await expect(draw(front(models.join('')))).rejects.toThrow(
      /^The still has 2,4.* values in its JSON/,
    );
  });
});

describe('values in a still’s markup', () => {
  it.each([
    ['#fc8', [255, 204, 136]],
    ['tomato', [255, 99, 71]],
    ['rgb(50% 0 100%)', [128, 0, 255]],
    ['rgba(10, 20, 30, 0.5)', [10, 20, 30]],
    ['hsl(210 50% 40%)', [51, 102, 153]],
    ['hsl(0.5turn, 100%, 25%)', [0, 128, 128]],
    ['hwb(120 20% 40%)', [51, 153, 51]],
    ['100 50 25', [100, 50, 25]],
  ])('may be the colour %s', async (color, expected) => {
    const light = SUN.replace('>', ` diffuse="${color}">`);
    const { middle, warnings } = await draw(
      front(WALL.replace('>', ' kd="255">'), undefined, light),
    );
    expect(warnings).toEqual([]);
    expect(middle).toEqual([...expected, 255]);
  });

  it.each([
    ['<phong-viewer fov="200" geometry="box"></phong-viewer>', 'a number from 1 to 170'],
    ['<phong-viewer geometry="boxx"></phong-viewer>', 'Did you mean "box"?'],
    ['<phong-viewer geometry="box" kd="redd"></phong-viewer>', 'using 200 200 200 instead'],
    [
      `<phong-viewer geometry="box" kd="rgb(${'1'.repeat(1e5)}x 0 0)"></phong-viewer>`,
      'using 200 200 200 instead',
    ],
    ['<phong-viewer geometry="box" shininess="NaN"></phong-viewer>', 'using 32 instead'],
    ['<phong-viewer geometry="box" segments="9999"></phong-viewer>', 'using auto instead'],
    ['<phong-viewer><phong-light position="1 2"></phong-light></phong-viewer>', 'x y z w'],
    [
      '<phong-viewer><phong-mesh geometry="box" scale="a"></phong-mesh></phong-viewer>',
      '<phong-mesh>',
    ],
  ])('warn as in a browser: %s', async (markup, part) => {
    const { warnings } = await draw(markup);
    expect(warnings).toHaveLength(1);
    expect(warnings[0]).toContain(part);
  });

  it.each([
    ['', 'one <phong-viewer>, and the markup has 0'],
    [Buffer.from('<phong-viewer></phong-viewer>') as unknown as string, 'must be a string'],
    ['<phong-viewer></phong-viewer><phong-viewer></phong-viewer>', 'has 2'],
    ['<phong-viewer view="triangles" geometry="box"></phong-viewer>', 'view="triangles"'],
    ['<phong-viewer geometry="box" kd="oklch(0.5 0.1 20)"></phong-viewer>', 'oklch(0.5 0.1 20)'],
    [
      '<phong-viewer geometry="box" kd="rgb(from red r g b)"></phong-viewer>',
      'rgb(from red r g b)',
    ],
    ['<phong-viewer geometry="box" kd="rgb(calc(9) 0 0)"></phong-viewer>', 'rgb(calc(9) 0 0)'],
    ['<phong-viewer src="model.glb"></phong-viewer>', 'without options.base'],
    ['<phong-viewer src="file:///nowhere/model.glb"></phong-viewer>', 'model.glb cannot be read'],
    [
      `<phong-viewer src="${fixture('..')}"></phong-viewer>`,
      '"fixtures" is a folder, not a model.',
    ],
    ['<phong-viewer src="javascript:alert(1)"></phong-viewer>', 'begins with "javascript:".'],
    ['<phong-viewer src="blob:null/a"></phong-viewer>', 'This blob: address leads to no data'],
    ['<phong-viewer src="data:,"></phong-viewer>', 'The model is empty: the data: URI.'],
    [`<phong-viewer src="${fixture('ktx2.glb')}"></phong-viewer>`, 'A still cannot read KTX2'],
    [
      `<phong-viewer src="${fixture('meshopt.glb')}"></phong-viewer>`,
      'A still cannot read meshopt',
    ],
    [`<phong-viewer src="${fixture('other-origin.gltf')}"></phong-viewer>`, 'not in the folder'],
    [
      `<phong-viewer>${'<phong-mesh geometry="teapot" segments="512"></phong-mesh>'.repeat(20)}</phong-viewer>`,
      'triangles',
    ],
  ])('are refused by name: %s', async (markup, part) => {
    await expect(draw(markup)).rejects.toThrow(part);
  });

  it.each([
    ['box', 20_000, 'draws; at most 10,000 can be shown.'],
    ['box', 9000, 'surfaces before and behind each other', 35],
  ])('are no heap of meshes: %s, %i', async (shape, count, part, size = 300) => {
    const mesh = `<phong-mesh geometry="${shape}"></phong-mesh>`;
    await expect(draw(`<phong-viewer>${mesh.repeat(count)}</phong-viewer>`, size)).rejects.toThrow(
      part,
    );
  });

  it('has a size in whole pixels', async () => {
    for (const size of [0, 1.5, NaN, 1e9]) {
      await expect(draw('<phong-viewer></phong-viewer>', size)).rejects.toThrow(RangeError);
    }
  });

  it('reads elements however deep they stand', async () => {
    const [open, close] = ['<div>', '</div>'].map((tag) => tag.repeat(20_000));
    const { middle } = await draw(`${open}${front(open + WALL + close)}${close}`);
    expect(middle).toEqual([200, 200, 200, 255]);
    const page = `<title>a</title>${open}${front(open + WALL + close).replace('>', ' style="width: 9px; height: 9px">')}`;
    expect(readPage(page).viewers).toHaveLength(1);
    const rooted = `<b><template shadowrootmode="open">${front(WALL)}</template></b>`;
    expect(readPage(rooted).viewers).toHaveLength(1);
    expect(readPage(rooted.replace(' shadow', ' ')).viewers).toHaveLength(0);
  });

  it('need no end tags, as in a browser', async () => {
    const { middle } = await draw(front(WALL).replace('</phong-mesh></phong-viewer>', ''));
    expect(middle).toEqual([200, 200, 200, 255]);
  });
});

function fixture(name: string) {
  return new URL(`../../fixtures/models/${name}`, import.meta.url).href;
}
