// Is a model shown without the images and material libraries that are missing or broken, with one
// warning that names them? The same for every format, and for files from a server, from the user's
// disk and inside the model.
import { beforeEach, describe, expect, it } from 'vitest';
import { droppedModel, modelContent } from '../../../src/extras/models/model-content.js';
import type { Content } from '../../../src/phong/model/model.js';
import { floats, type Json, viewsOf } from '../../fuzz/glb.js';
import { triangleDocument } from '../../fuzz/models.js';
import {
  BREAKS_OFF,
  failureOf,
  type FileContent,
  heardWarnings,
  loadFiles,
  OPTIONS,
  png,
  pngHeader,
  standInImages,
  view,
} from './model-files.js';

const warnings = heardWarnings();

/** A triangle with texture coordinates, its buffer inside; `parts` replace the document's own. */
function gltf(parts: Json) {
  const { bufferViews, body } = viewsOf([
    floats(0, 0, 0, 1, 0, 0, 0, 1, 0),
    floats(0, 0, 1, 0, 0, 1),
  ]);
  const uri = `data:application/octet-stream;base64,${body.toString('base64')}`;
  const document = triangleDocument({
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    images: [{ uri: 'pictures/oak%20wood.png' }],
    accessors: [view(0, 'VEC3'), view(1, 'VEC2')],
    bufferViews,
    buffers: [{ byteLength: 60, uri }],
    ...parts,
  });
  return JSON.stringify(document);
}

/** A triangle for each image. */
const obj = (images: readonly string[]): Readonly<Record<string, string>> => {
  const faces = images.map((_, i) => `usemtl m${i}\nf 1/1 2/1 3/1\n`);
  return {
    'a.obj': `mtllib lib/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n${faces.join('')}`,
    'lib/a.mtl': images.map((image, i) => `newmtl m${i}\nKd 0.5 0 0\nmap_Kd ${image}\n`).join(''),
  };
};

const POINTER = `version https://git-lfs.github.com/spec/v1\noid sha256:${'0'.repeat(64)}\nsize 12345\n`;

describe('a pointer of Git LFS', () => {
  it.each([
    ['model', { 'a.glb': POINTER }],
    ['model whose name says another format', { 'a.obj': POINTER }],
    ['buffer', { 'a.gltf': gltf({ buffers: [{ byteLength: 60, uri: 'a.bin' }] }), 'a.bin': POINTER }], // oxfmt-ignore
  ])('is named in the error, in place of a %s', async (_, files) => {
    const error = await failureOf(files);
    expect(error.code).toBe('bad-model');
    expect(error.message).toMatch(/^a\.(glb|obj|bin) is only a pointer of Git LFS .*git lfs pull/);
  });

  it('is named in the warning, in place of a library', async () => {
    const model = await loadFiles({ ...obj(['x.png']), 'lib/a.mtl': POINTER });
    expect(model.missing).toEqual(['lib/a.mtl']);
    expect(warnings).toEqual([expect.stringContaining('a.mtl is only a pointer of Git LFS')]);
  });

  it('is named among dropped files too', async () => {
    const file = new File([POINTER], 'a.stl');
    const model = (await droppedModel([], [file])) as File;
    await expect(modelContent(new URL('file:///a.stl'), OPTIONS, model)).rejects.toThrow(
      /^a\.stl is only a pointer of Git LFS/,
    );
  });
});

const mapsOf = ({ parts }: Content) => parts.map(({ look }) => look.map !== null);

const broken: readonly (readonly [
  what: string,
  content: FileContent | undefined,
  reason: RegExp,
])[] = [
  ['the server does not have', undefined, /answered 404 for oak wood\.png/],
  ['whose connection breaks', BREAKS_OFF, /connection broke/],
  ['that is cut after its header', pngHeader(), /cannot be decoded by this browser/],
  ['that is no image', 'no picture', /is no PNG, JPEG, WebP or KTX2 image/],
  ['of which the server has a pointer', POINTER, /oak wood\.png is only a pointer of Git LFS/],
];

beforeEach(() => void standInImages());

describe.each([
  ['glTF', { 'a.gltf': gltf({}) }, 'pictures/oak wood.png'],
  ['MTL', obj(['oak wood.png']), 'lib/oak wood.png'],
])('an image that %s names', (_format, files, path) => {
  it.each(broken)('and %s is left out', async (_, content, reason) => {
    const model = await loadFiles({ ...files, [path]: content });
    expect(mapsOf(model)).toEqual([false]);
    expect(model.missing).toEqual([path]);
    expect(warnings).toEqual([expect.stringMatching(reason)]);
    expect(warnings[0]).toContain(
      `${Object.keys(files)[0]!} is shown without 1 of the files that it names: ${path}. `,
    );
  });
});

describe('an image', () => {
  it.each([
    [
      'whose data: URI is broken',
      { images: [{ uri: 'data:image/png;base64,*' }] },
      /images\[0\].*base64/,
    ],
    [
      'whose data: URI holds none',
      { images: [{ uri: 'data:image/png,x', name: 'oak' }] },
      /oak is no PNG/,
    ],
    ['whose view is none', { images: [{ bufferView: 7 }] }, /images\[0\]/],
    ['without any source', { images: [{}] }, /images\[0\]/],
    ['on another origin', { images: [{ uri: 'https://other.example/x.png' }] }, /crossorigin/],
    ['that is no address', { images: [{ uri: 'https://:/x.png' }] }, /no valid address/],
    ['that only an unknown extension has', { textures: [{ extensions: { MSFT_texture_dds: { source: 0 } } }] }, /textures\[0\] needs the glTF extension MSFT_texture_dds/], // oxfmt-ignore
    ['that a texture lacks', { textures: [{}] }, /textures\[0\] has no image/],
  ])('%s is left out of a glTF', async (_, parts, reason) => {
    const model = await loadFiles({ 'a.gltf': gltf(parts) });
    expect(mapsOf(model)).toEqual([false]);
    expect(model.missing).toHaveLength(1);
    expect(warnings).toEqual([expect.stringMatching(reason)]);
  });

  it('that several textures name is named once', async () => {
    const attributes = { POSITION: 0, TEXCOORD_0: 1 };
    const parts = {
      textures: [{ source: 0, sampler: 0 }, { source: 0 }, { source: 1 }],
      images: [{ uri: 'x.png' }, { uri: 'x.png' }],
      samplers: [{ wrapS: 33071 }],
      materials: [0, 1, 2].map((index) => ({
        pbrMetallicRoughness: { baseColorTexture: { index } },
      })),
      meshes: [{ primitives: [0, 1, 2].map((material) => ({ attributes, material })) }],
    };
    const model = await loadFiles({ 'a.gltf': gltf(parts) });
    expect(mapsOf(model)).toEqual([false, false, false]);
    expect(model.missing).toEqual(['x.png']);
  });

  it('beside a buffer that is missing is no excuse: the buffer is an error', async () => {
    const buffers = [{ byteLength: 60, uri: 'a.bin' }];
    const error = await failureOf({ 'a.gltf': gltf({ buffers }) });
    expect(error.code).toBe('load-failed');
    expect(error.message).toMatch(/answered 404 for a\.bin/);
    expect(warnings).toEqual([]);
  });
});

describe('the factors of a map whose image is missing', () => {
  it.each<[string, Json, object]>([
    ['glow', { emissiveFactor: [1, 1, 1], emissiveTexture: { index: 0 } }, { emissive: [0, 0, 0] }],
    [
      'metal',
      {
        pbrMetallicRoughness: {
          metallicFactor: 1,
          roughnessFactor: 1,
          metallicRoughnessTexture: { index: 0 },
        },
      },
      { metalness: 0, roughness: null },
    ],
  ])('do not make all of the surface %s', async (_, material, look) => {
    const { parts } = await loadFiles({ 'a.gltf': gltf({ materials: [material] }) });
    expect(parts[0]?.look).toMatchObject(look);
  });
});

describe('files from the user’s disk', () => {
  /** The first file, with the others beside it. */
  async function dropped(files: Readonly<Record<string, string | Uint8Array<ArrayBuffer>>>) {
    const group = Object.entries(files).map(([path, content]) => new File([content], path));
    const model = (await droppedModel([], group)) as File;
    return modelContent(new URL(model.name, 'file:///'), OPTIONS, model);
  }

  it('show an OBJ with three of its four images, and name the fourth', async () => {
    const files = obj(['a.png', 'b.png', 'c.png', 'd.png']);
    const model = await dropped({ ...files, 'a.png': png(), 'b.png': png(), 'd.png': png() });
    expect(mapsOf(model)).toEqual([true, true, false, true]);
    expect(model.missing).toEqual(['lib/c.png']);
    expect(warnings).toEqual([
      'a.obj is shown without 1 of the files that it names: lib/c.png. Drop them together with it, or drop the folder that holds them all.',
    ]);
  });

  it('are found in whatever case, first in the folder that is named', async () => {
    const files = { ...obj(['wood/oak.png']), 'lib/Wood/Oak.png': png(), 'old/oak.png': png() };
    expect(mapsOf(await dropped(files))).toEqual([true]);
  });

  it('say once how to bring many images that are missing, and list ten', async () => {
    const model = await dropped(obj(Array.from({ length: 14 }, (_, i) => `${i}.png`)));
    expect(model.missing).toHaveLength(14);
    expect(warnings).toHaveLength(1);
    expect(warnings[0]).toMatch(
      /without 14 of .*lib\/0\.png, .*lib\/9\.png and 4 more\. Drop them[^:]*all\.$/,
    );
  });

  it.each([
    [['a.stl', 'b.ply'], /There are 2 models: a\.stl, b\.ply\. Drop one of them/],
    [['a.mtl', 'b.bin'], /None of the 2 files is a model: glTF/],
    [['chair.fbx'], /^The format is not supported: chair\.fbx\. Export it as one that is: glTF/],
  ])('are an error that says what to do, if they are %j', async (names, message) => {
    const files = Object.fromEntries(names.map((name) => [name, 'x']));
    await expect(dropped(files)).rejects.toThrow(message);
  });

  it('are an error that names everything missing if a buffer is', async () => {
    const buffers = [{ byteLength: 60, uri: 'a.bin' }];
    await expect(dropped({ 'a.gltf': gltf({ buffers }), 'b.txt': '' })).rejects.toMatchObject({
      code: 'load-failed',
      message: expect.stringMatching(
        /^a\.gltf names files that did not come with it: .*a\.bin/,
      ) as string,
    });
    expect(warnings).toEqual([]);
  });
});
