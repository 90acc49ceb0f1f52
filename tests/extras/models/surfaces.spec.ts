// Are the materials of files shaded and explained by the rules of demo/guide/models.md? Compares
// pixels with shadeAt, and shadeAt with values computed here from those rules.

import { patch, type PatchOptions, type Texel } from '../../support/gltf.js';
import { firstOf } from '../../support/repeats.js';
import { type ViewerLocator, expect, pixelAt, pixels, test } from '../../support/test.js';
import { comparedWithPicture, errorOf, isClear, show } from '../explain/shade-at-support.js';

const LIGHTS = `
  <phong-light position="0.5 1 2 0" ambient="60 50 40" diffuse="120 110 100" specular="90 100 110"></phong-light>
  <phong-light position="-0.6 0.4 1.6 1" diffuse="60 70 80" specular="120"></phong-light>`;

/** The encoded value of a linear one. */
const encoded = (c: number) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);

const viewerOf = (options: PatchOptions, attributes = '', mesh = '') =>
  `<phong-viewer theta="12" phi="80" target="0 0 0" radius="3.2" ${attributes}>
    <phong-mesh src="${patch(options)}" ${mesh}></phong-mesh>${LIGHTS}
  </phong-viewer>`;

/** The result of shadeAt for the pixel in the middle. */
const middle = (viewer: ViewerLocator) =>
  viewer.evaluate(async (element) => {
    const { ka, kd, ks, shininess, emissive, metalness, unlit, color, N, sum } =
      (await element.shadeAt(80, 60))!;
    return { ka, kd, ks, shininess, emissive, metalness, unlit, color, N, sum };
  });

const SIZE = { width: 160, height: 120 };

const SMOOTH: readonly Texel[] = [
  [250, 20, 40],
  [40, 120, 200],
  [90, 240, 90],
  [200, 180, 10],
];
/** Green is roughness, blue metalness. */
const METAL_ROUGH: readonly Texel[] = [
  [0, 90, 250],
  [0, 200, 0],
  [0, 130, 120],
  [0, 60, 200],
];
const BUMPS: readonly Texel[] = [
  [128, 128, 255],
  [190, 100, 220],
  [80, 150, 230],
  [120, 200, 210],
];
const MAPPED = { metallicRoughnessTexture: { index: 0 } };
const RED = [0.8, 0.1, 0.05, 1];

const MATERIALS: Readonly<Record<string, PatchOptions>> = {
  'an emissive colour': { material: { emissiveFactor: [0.05, 0.1, 0.02] } },
  'an emissive texture': {
    material: {
      emissiveFactor: [0.2, 0.2, 0.2],
      emissiveTexture: { index: 0 },
      extensions: { KHR_materials_emissive_strength: { emissiveStrength: 1.5 } },
    },
    textures: [SMOOTH],
  },
  metal: {
    material: {
      pbrMetallicRoughness: { baseColorFactor: RED, metallicFactor: 1, roughnessFactor: 0.5 },
    },
  },
  'half a metal': {
    material: {
      pbrMetallicRoughness: { baseColorFactor: RED, metallicFactor: 0.5, roughnessFactor: 0.7 },
    },
  },
  'a rough surface': {
    material: {
      pbrMetallicRoughness: { baseColorFactor: RED, metallicFactor: 0, roughnessFactor: 0.8 },
    },
  },
  'textures of metalness, roughness and base colour': {
    material: { pbrMetallicRoughness: { ...MAPPED, baseColorTexture: { index: 1, texCoord: 1 } } },
    textures: [METAL_ROUGH, SMOOTH],
  },
  'a texture of roughness alone': {
    material: { pbrMetallicRoughness: { ...MAPPED, metallicFactor: 0, baseColorFactor: RED } },
    textures: [METAL_ROUGH],
  },
  'an unlit texture': {
    material: {
      extensions: { KHR_materials_unlit: {} },
      emissiveFactor: [1, 1, 1],
      pbrMetallicRoughness: { baseColorFactor: [0.5, 0.9, 0.7, 1], baseColorTexture: { index: 0 } },
    },
    textures: [SMOOTH],
  },
  'a normal map': { material: { normalTexture: { index: 0, scale: 0.8 } }, textures: [BUMPS] },
  'a normal map with tangents of its own': {
    material: { normalTexture: { index: 0 } },
    textures: [BUMPS],
    tangents: true,
  },
  'a normal map on a mirrored node': {
    material: { normalTexture: { index: 0 } },
    textures: [BUMPS],
    tangents: true,
    matrix: [-1.2, 0, 0, 0, 0, 0.9, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
  },
  'a normal map with coordinates of its own': {
    material: {
      normalTexture: { index: 0, texCoord: 1 },
      pbrMetallicRoughness: { baseColorTexture: { index: 1 } },
    },
    textures: [BUMPS, SMOOTH],
  },
};

const VIEWS: readonly string[] = [
  '',
  'shading="gouraud"',
  'shading="flat"',
  'color-interpolation="linear"',
  'reflection="blinn-phong"',
  'theta="190"',
];

test('the picture of each kind of material is what shadeAt explains, within one code', async ({
  mount,
}) => {
  test.slow();
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  for (const [i, [name, options]] of Object.entries(MATERIALS).entries()) {
    // In each way in turn.
    for (const attributes of firstOf([...new Set([VIEWS[i % VIEWS.length]!, ...VIEWS])], 1)) {
      const what = `${name} ${attributes}`;
      await show(viewer, viewerOf(options, attributes));
      const compared = (await comparedWithPicture(viewer, 12)).filter(isClear);
      expect(compared.length, what).toBeGreaterThan(15);
      // One expectation for all pixels: one for each took a quarter of the time.
      expect
        .soft(
          compared.filter((fragment) => !(errorOf(fragment) <= 1)),
          what,
        )
        .toEqual([]);
    }
  }
});

test('colours are mixed in the light that the file and the viewer ask for, and explained so', async ({
  mount,
}) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const text = (type: string, body: string) =>
    `data:${type};base64,${Buffer.from(body).toString('base64')}`;
  const COLORS = ['1 0 0', '0 1 0'];
  // Red on the left, green on the right.
  const corners = [-1, 1, 1, -1].map((x, i) => `${x} ${i < 2 ? -1 : 1} 0 ${COLORS[(x + 1) / 2]}`);
  const obj = text('model/obj', `${corners.map((v) => `v ${v}\n`).join('')}f 1 2 3 4`);
  const ply = text('model/ply', `ply\nformat ascii 1.0\nelement vertex 4\n${['x', 'y', 'z', 'red', 'green', 'blue'].map((name) => `property float ${name}\n`).join('')}element face 1\nproperty list uchar int vertex_indices\nend_header\n${corners.join('\n')}\n4 0 1 2 3\n`); // oxfmt-ignore
  const texture: readonly Texel[] = [[255, 0, 0], [0, 255, 0], [255, 0, 0], [0, 255, 0]]; // oxfmt-ignore
  const gltf = patch({
    material: { pbrMetallicRoughness: { metallicFactor: 0, baseColorTexture: { index: 0 } } },
    textures: [texture],
  });
  const glowing = patch({
    material: {
      pbrMetallicRoughness: { metallicFactor: 0, baseColorFactor: [0, 0, 0, 1] },
      emissiveFactor: [1, 1, 1],
      emissiveTexture: { index: 0 },
    },
    textures: [texture],
  });
  const half = Math.round(255 * encoded(0.5));
  for (const [what, src, inSrgb, inLinear] of [
    ['an OBJ file', obj, 128, half],
    ['a PLY file', ply, 128, half],
    ['a texture', gltf, 128, half],
    ['an emissive texture', glowing, 128, half],
    ['a glTF file', '/fixtures/cases/gltf/color-gradient.gltf', half, half],
  ] as const) {
    for (const [shading, color] of [
      ['phong', 'srgb'],
      ['phong', 'linear'],
      ['gouraud', 'srgb'],
      ['gouraud', 'linear'],
      ['flat', 'linear'],
    ] as const) {
      const name = `${what}, ${shading}, ${color}`;
      await show(
        viewer,
        `<phong-viewer src="${src}" ka="255" theta="0" phi="90" target="0 0 0" radius="3" shading="${shading}" color-interpolation="${color}">
          <phong-light ambient="255" diffuse="0" specular="0"></phong-light></phong-viewer>`,
      );
      const drawn = pixelAt(await pixels(viewer), 80, 60);
      const explained = (await middle(viewer)).color;
      const expected = color === 'linear' ? inLinear : inSrgb;
      for (const channel of [0, 1] as const) {
        const code = drawn[channel];
        const off = Math.abs(255 * explained[channel] - code);
        // The pixel's centre lies beside the middle, by half of it.
        expect.soft(Math.abs(code - expected), `${name}: ${code}`).toBeLessThanOrEqual(4);
        expect.soft(off, `${name}: shadeAt`).toBeLessThanOrEqual(1);
      }
    }
  }
});

test.describe('by the rules of demo/guide/models.md', () => {
  const base = RED.slice(0, 3).map(encoded);

  const shown = async (
    viewer: ViewerLocator,
    options: PatchOptions,
    attributes = '',
    mesh = '',
  ) => {
    await show(viewer, viewerOf(options, attributes, mesh));
    return middle(viewer);
  };

  test('metalness, roughness and an exponent in the markup give Kd, Ks and shininess', async ({
    mount,
  }) => {
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    const metal = await shown(viewer, MATERIALS['metal']!, '', 'ka="255" kd="255"');
    expect(metal.metalness).toBe(0.5); // without a texture
    expect(metal.shininess).toBeCloseTo(7.5, 12); // (1 / 0.5⁴ − 1) / 2
    base.forEach((c, i) => {
      expect(metal.ka[i]).toBeCloseTo(c, 6);
      expect(metal.kd[i]).toBeCloseTo(c / 2, 6);
      expect(metal.ks[i]).toBeCloseTo(((c / 2 + 9.5 / 34 / 2) * 128) / 255, 6); // the lobe's share: (7.5 + 2) / 34
    });
    const rough = await shown(viewer, MATERIALS['a rough surface']!, '', 'kd="255"');
    expect(rough.shininess).toBeCloseTo(1, 12); // (1 / 0.8⁴ − 1) / 2 is below 1, the smallest exponent
    for (const k of rough.ks) {
      expect(k).toBeCloseTo(((128 / 255) * (1 + 2)) / 34, 9);
    }
    base.forEach((c, i) => expect(rough.kd[i]).toBeCloseTo(c, 6));
    const written = await shown(
      viewer,
      MATERIALS['a texture of roughness alone']!,
      '',
      'shininess="20"',
    );
    expect(written).toMatchObject({ shininess: 20, ks: [128 / 255, 128 / 255, 128 / 255] });
    const { kd, ...plain } = await shown(viewer, { material: {} }, '', 'kd="255"');
    expect(plain).toMatchObject({ shininess: 32, metalness: 0, unlit: false });
    for (const k of kd) {
      expect(k).toBeCloseTo(1, 12);
    }
  });

  test('an emissive colour is added once, an unlit surface has its base colour, in any light', async ({
    mount,
  }) => {
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    const { color, emissive } = await shown(viewer, MATERIALS['an emissive colour']!, 'terms=""');
    for (const [i, c] of [0.05, 0.1, 0.02].map(encoded).entries()) {
      expect(color[i]).toBeCloseTo(c, 9);
      expect(emissive[i]).toBeCloseTo(c, 9);
    }
    const extensions = { KHR_materials_unlit: {} };
    const material = { extensions, pbrMetallicRoughness: { baseColorFactor: RED } };
    for (const attributes of ['', 'terms=""', 'color-interpolation="linear"']) {
      const flat = await shown(viewer, { material }, attributes);
      expect(flat).toMatchObject({ unlit: true, kd: [0, 0, 0] });
      base.forEach((c, i) => expect(flat.color[i], attributes).toBeCloseTo(c, 6));
    }
  });

  test('green points up the image, with and without tangents of its own', async ({ mount }) => {
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    const material = { normalTexture: { index: 0 } };
    // Textures of one normal each: up, and to the left of the image.
    const directions: readonly Texel[] = [
      [128, 218, 218],
      [37, 128, 218],
    ];
    for (const tangents of [false, true]) {
      for (const texel of directions) {
        const textures = [Array<Texel>(4).fill(texel)];
        const [x, y] = [Math.sign(texel[0] - 128), Math.sign(texel[1] - 128)];
        await show(
          viewer,
          `<phong-viewer theta="0" phi="90" target="0 0 0.3" radius="3.2">
            <phong-mesh src="${patch({ material, textures, tangents })}" kd="255" ks="0" ka="0"></phong-mesh>
            <phong-light position="${x} ${y} 1 0" ambient="0" diffuse="255" specular="0"></phong-light>
          </phong-viewer>`,
        );
        // In the middle the patch faces +z, its u runs along +x and its v along -y: the texel is
        // the normal in world space.
        const t = texel.slice(0, 3).map((c) => (2 * c!) / 255 - 1);
        const length = Math.hypot(...t);
        const diffuse = (x * t[0]! + y * t[1]! + t[2]!) / (Math.SQRT2 * length);
        const which = `${tangents ? 'own' : 'computed'} tangents, ${texel.join(' ')}`;
        const { N, color } = await middle(viewer);
        N.forEach((n, i) => expect(n, which).toBeCloseTo(t[i]! / length, 2));
        expect(color[0], which).toBeCloseTo(diffuse, 2);
        const [red] = pixelAt(await pixels(viewer), 80, 60);
        expect(Math.abs(red - 255 * diffuse), which).toBeLessThan(2);
      }
    }
  });
});
