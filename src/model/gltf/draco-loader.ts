// Draco decoding for three's glTF loader, by an object that looks like three's own Draco loader, as far as it is
// called.
import wasm from 'three/examples/jsm/libs/draco/gltf/draco_decoder.wasm?url';
import { BufferAttribute, BufferGeometry } from 'three';
import type { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { lazyCode } from '../lazy-code.js';
import { DecoderThread } from '../decoders/decoder-thread.js';
import { ModelError } from '../model.js';
import type { Slices } from '../slices.js';
import type { DracoJob, DracoMesh } from './draco-mesh.js';

const decoderCode = lazyCode(() => import('./draco.js'), 'the Draco decoder');

/**
 * For meshes of any size: the bunny blocks the main thread for 42 ms of processor time, a million triangles for 870 ms.
 * More workers are no faster: each warms the decoder up again, and three of them took 180 ms each for 34 meshes that
 * one unpacks in 190 ms.
 */
const thread = /* @__PURE__ */ new DecoderThread<DracoJob, DracoMesh>(
  () => new Worker(new URL('./draco-worker.ts', import.meta.url), { type: 'module' }),
  async () => {
    const { createDecoder } = await decoderCode().catch((cause: unknown) => {
      const message = 'The Draco decoder, which this model needs, could not be fetched.';
      throw new ModelError('load-failed', message, { cause });
    });
    return createDecoder;
  },
  wasm,
);

type DracoLoader = Parameters<GLTFLoader['setDRACOLoader']>[0];

export function dracoLoader(slices: Slices, signal: AbortSignal): DracoLoader {
  thread.start();
  const decode = async (job: DracoJob): Promise<BufferGeometry> => {
    // On the main thread every mesh is a task of its own.
    await slices.pause();
    const { index, attributes } = await thread.decode(job, signal);
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(index, 1));
    for (const [name, { array, itemSize }] of Object.entries(attributes))
      geometry.setAttribute(name, new BufferAttribute(array, itemSize));
    return geometry;
  };
  const loader = {
    preload: (): void => undefined,
    decodeDracoFile(
      bytes: ArrayBuffer,
      onLoad: (geometry: BufferGeometry) => void,
      idByName: DracoJob['idByName'],
      arrayTypeByName: DracoJob['arrayTypeByName'],
      _colorSpace: string,
      onError: (error: unknown) => void,
    ): void {
      decode({ bytes, idByName, arrayTypeByName }).then(onLoad).catch(onError);
    },
  };
  return loader as unknown as DracoLoader;
}
