// Which addresses may a model name, what is in a data: URI, and what format is a file in?
import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { decodeDataUri } from '../../../src/extras/models/encodings.js';
import { Slices } from '../../../src/extras/models/slices.js';
import { formatOf } from '../../../src/extras/models/format.js';
import { linkedUrl, modelContent } from '../../../src/extras/models/model-content.js';
import { loadWith } from './model-files.js';

const MODEL = new URL('https://shop.example/models/chairs/one.gltf?v=2');

const REFUSED = expect.stringContaining('is not in the folder of a.obj') as string;

describe('the files that a model names', () => {
  it.each([
    ['one.bin', 'https://shop.example/models/chairs/one.bin'],
    ['./wood/oak.png', 'https://shop.example/models/chairs/wood/oak.png'],
    ['a..;b/..c', 'https://shop.example/models/chairs/a..;b/..c'],
    ['50%25.png', 'https://shop.example/models/chairs/50%25.png'],
    ['wood/../one.bin', 'https://shop.example/models/chairs/one.bin'],
    ['/models/chairs/one.bin?x#y', 'https://shop.example/models/chairs/one.bin?x#y'],
    [
      'https://shop.example/models/chairs/a%20b.png',
      'https://shop.example/models/chairs/a%20b.png',
    ],
  ])('may be %s', (uri, address) => {
    expect(linkedUrl(uri, MODEL, false).href).toBe(address);
  });

  it.each([
    'a%2F..%2f..%2Fone.bin',
    'a%5c..%5cone.bin',
    'a%252f..%252fone.bin',
    '..;/one.bin',
    'a/..;jsessionid=1/one.bin',
    'a/.%2E;/one.bin',
    'a/..%3b/one.bin',
    'a/%252e%252e/one.bin',
    '/models/chairs-old/one.bin',
    'http://shop.example/models/chairs/one.bin',
    'https://shop.example:8443/models/chairs/one.bin',
    'https://user:secret@shop.example/models/chairs/one.bin',
    'blob:https://shop.example/1234',
    'javascript:alert(1)',
    'file:///etc/passwd',
  ])('may not be %s', (uri) => {
    expect(() => linkedUrl(uri, MODEL, false)).toThrow(
      expect.objectContaining({ code: 'load-failed' }),
    );
  });

  it('may be anywhere on the web, and nowhere else, if crossorigin is set', () => {
    expect(linkedUrl('//other.example/a.bin', MODEL, true).href).toBe(
      'https://other.example/a.bin',
    );
    expect(linkedUrl('../a.bin', MODEL, true).href).toBe('https://shop.example/models/a.bin');
    for (const uri of [
      'javascript:alert(1)',
      'file:///etc/passwd',
      'blob:https://shop.example/1',
    ]) {
      expect(() => linkedUrl(uri, MODEL, true)).toThrow(/is not in the folder of/);
    }
  });

  it('stay in the folder whatever the path', () => {
    const pieces = fc.constantFrom('..', '/', '\\', '%2e', '%2f', 'a', ':', '?', '#', '//');
    fc.assert(
      fc.property(fc.array(pieces), (parts) => {
        let href = 'https://shop.example/models/chairs/';
        try {
          ({ href } = linkedUrl(parts.join(''), MODEL, false));
        } catch {
          // Refused.
        }
        expect(href.startsWith('https://shop.example/models/chairs/')).toBe(true);
      }),
    );
  });

  it.each([
    ['another folder', 'https://shop.example/v3/a.obj', 'https://shop.example/v3/wood.mtl', []],
    ['another origin', 'https://cdn.example/v3/a.obj', 'https://cdn.example/v3/wood.mtl', []],
    ['another origin', 'https://cdn.example/v3/a.obj', '//shop.example/models/wood.mtl', [REFUSED]],
    ['a deeper folder', 'https://shop.example/models/v3/a.obj', '../wood.mtl', [REFUSED]],
  ])('are looked for where a redirect to %s has led', async (_, answered, library, missing) => {
    const warn = vi.spyOn(console, 'warn').mockReturnValue();
    const asked: string[] = [];
    const uri = missing.length === 0 ? 'wood.mtl' : library;
    vi.spyOn(globalThis, 'fetch').mockImplementation((input) => {
      asked.push((input as URL).href);
      const isModel = asked.length === 1;
      const text = isModel
        ? `mtllib ${uri}\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3`
        : 'newmtl m\nKd 1 0 0';
      const url = isModel ? answered : '';
      return Promise.resolve(Object.defineProperty(new Response(text), 'url', { value: url }));
    });
    const signal = new AbortController().signal;
    const address = new URL('https://shop.example/models/a.obj');
    const model = await modelContent(address, loadWith(signal));
    expect(asked).toEqual([address.href, ...(missing.length === 0 ? [library] : [])]);
    expect(warn.mock.calls.flat()).toEqual(missing);
    expect(model.missing).toHaveLength(missing.length);
    vi.restoreAllMocks();
  });

  it.each(['data:model/gltf+json,{}', 'blob:https://shop.example/1'])(
    'are refused beside %s',
    (model) => {
      expect(() => linkedUrl('one.bin', new URL(model), false)).toThrow();
    },
  );
});

describe('data: URIs', () => {
  const decode = (uri: string) => decodeDataUri(uri, new Slices(new AbortController().signal));
  const decoded = async (uri: string) => Array.from((await decode(uri)).bytes);

  it('decode to the bytes that were encoded', async () => {
    await fc.assert(
      fc.asyncProperty(fc.uint8Array(), async (bytes) => {
        const base64 = Buffer.from(bytes).toString('base64');
        const percent = Array.from(bytes, (byte) => `%${byte.toString(16).padStart(2, '0')}`).join(
          '',
        );
        const expected = Array.from(bytes);
        expect(await decoded(`data:application/octet-stream;base64,${base64}`)).toEqual(expected);
        expect(await decoded(`DATA:;BASE64,${base64.replace(/=+$/, '')}`)).toEqual(expected);
        expect(await decoded(`data:application/octet-stream,${percent}`)).toEqual(expected);
      }),
    );
  });

  it('give their type, and may be percent-encoded base64', async () => {
    const image = { type: 'image/png', bytes: new Uint8Array([0]) };
    expect(await decode('data:Image/PNG;charset=x;base64,AA%3D%3D')).toEqual(image);
    expect((await decode('data:,a%20b')).type).toBe('text/plain');
  });

  it.each(['data:image/png;base64', 'data:image/png;base64,*!', 'data:;base64,AAAAA'])(
    'are bad-model where they are broken: %s',
    async (uri) => {
      await expect(decode(uri)).rejects.toMatchObject({ code: 'bad-model' });
    },
  );
});

describe('formats', () => {
  const bytes = (text: string) => new TextEncoder().encode(text);
  const url = (name: string) => `https://shop.example/${name}`;
  const supported =
    /^The format is not supported: .*Export it as one that is: glTF \(\.glb, \.gltf\), PLY \(\.ply\), STL \(\.stl\), OBJ \(\.obj\)/;
  const ascii = (text: string) => Uint8Array.from(text, (c) => c.charCodeAt(0));
  const oneTriangle = new Uint8Array(134);
  oneTriangle[80] = 1;

  it.each([
    ['glTF\u0002', 'x.bin', 'glTF'],
    ['{"asset":{}}', 'x', 'glTF'],
    ['\ufeff \n {"asset":{}}', 'x.txt', 'glTF'],
    ['nonsense', 'x.GLB', 'glTF'],
    ['nonsense', 'x.gltf?y=.obj', 'glTF'],
    ['ply\r\nformat', 'x.obj', 'PLY'],
    ['solid a name\n facet normal', 'x', 'STL'],
    ['SOLID\r\nENDSOLID', 'x', 'STL'],
    ['solid', 'x.stl', 'STL'],
    ['# made by hand\n\nmtllib a.mtl\nv 0 0 0\n', 'x', 'OBJ'],
    ['nonsense', 'x.obj', 'OBJ'],
  ])('are detected: content %j of %s is %s', (text, name, format) => {
    expect(formatOf(url(name), bytes(text)).name).toBe(format);
  });

  it('include binary STL by its size, whatever it begins with', () => {
    expect(formatOf(url('x'), oneTriangle).name).toBe('STL');
    expect(
      formatOf(url('x.bin'), Uint8Array.from([...ascii('solid'), ...oneTriangle.subarray(5)])).name,
    ).toBe('STL');
  });

  it('are named by `type` before the extension, and by the extension before the media type', () => {
    const unclear = bytes('unclear');
    expect(formatOf(url('x.stl'), unclear, { type: 'OBJ' }).name).toBe('OBJ');
    expect(formatOf(url('x.stl'), unclear, { type: 'model/obj; charset=utf-8' }).name).toBe('OBJ');
    expect(formatOf(url('x.stl'), unclear, { mediaType: 'model/obj' }).name).toBe('STL');
    expect(formatOf(url('x'), unclear, { mediaType: 'model/obj' }).name).toBe('OBJ');
    expect(formatOf(url('x'), bytes('ply\n'), { type: 'obj' }).name).toBe('PLY');
  });

  it.each([
    ['solid x', 'x', supported],
    ['', 'x.glb', /The model is empty/],
    ['<!doctype html>', 'x.obj', /web page/],
    ['PK\x03\x04\x14\0\0\0\0\0a.txt', 'x', /archive.*Unpack/],
    ['<?xml version="1.0"?>\n<COLLADA xmlns="">', 'x.dae', /XML/],
    ['Kaydara FBX Binary  \0', 'x.fbx', supported],
  ])('refuse content %j of %s, and say why', (text, name, message) => {
    expect(() => formatOf(url(name), ascii(text))).toThrow(message);
  });

  it('are an archive where gzip says so, though a browser’s Latin-1 has another character for it', () => {
    const decode = vi.spyOn(TextDecoder.prototype, 'decode').mockReturnValue('\x1f\u2039');
    expect(() => formatOf(url('x.stl'), ascii('\x1f\x8b'))).toThrow(/archive/);
    decode.mockRestore();
  });
});
