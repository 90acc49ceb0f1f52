// How much of a long text in a file or an address does a message repeat? A part, so that the page can lay it out.

import { expect, test } from '../../support/test.js';
import { type PhongViewer, record } from '../support/viewer.js';

const dataUri = (gltf: object): string => `data:model/gltf+json,${encodeURIComponent(JSON.stringify(gltf))}`;
const word = 'x'.repeat(1e5);
const words = 'x '.repeat(5e4);
const sources: Readonly<Record<string, string>> = {
  'a version of one word': dataUri({ asset: { version: word } }),
  'a version of many words': dataUri({ asset: { version: words } }),
  'an extension of one word': dataUri({ asset: { version: '2.0' }, extensionsRequired: [word] }),
  'an extension of many words': dataUri({ asset: { version: '2.0' }, extensionsRequired: [words] }),
  'the address of a linked file': dataUri({ asset: { version: '2.0' }, buffers: [{ uri: `/${word}`, byteLength: 36 }], bufferViews: [{ buffer: 0, byteLength: 36 }], accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' }], meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }], nodes: [{ mesh: 0 }], scenes: [{ nodes: [0] }] }), // prettier-ignore
  'an address that is not there': `/${'x'.repeat(5000)}.glb`,
};

test('messages repeat a part of long texts in files and addresses', async ({ mount, consoleGuard }) => {
  consoleGuard.allow(/error: Failed to load resource/);
  consoleGuard.allow(/warning: .*Save it without that extension\./, 2);
  const viewer = await mount('<phong-viewer></phong-viewer>');
  const errors = await record(viewer, 'error');
  for (const [what, src] of Object.entries(sources)) {
    await viewer.evaluate(async (element: PhongViewer, address) => {
      element.src = address;
      await element.ready;
    }, src);
    const [error, ...more] = await errors.take();
    expect(more, what).toEqual([]);
    const { message } = error!.detail as { message: string };
    const shown = (await viewer.locator('[part=notice]').textContent())!;
    expect(shown.slice(0, 100), what).toBe(message.slice(0, 100));
    for (const text of [message, shown]) {
      expect(text.length, what).toBeLessThan(530);
      expect(Math.max(...text.split(/\s+/).map(({ length }) => length)), what).toBeLessThan(105);
      expect(text, what).toContain('...');
    }
  }
});
