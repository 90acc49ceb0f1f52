// The Draco decoder in plain JavaScript, for the main thread where no worker can start or a policy
// refuses WebAssembly. A chunk of half a megabyte.
import createDraco from 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';
import { type DracoJob, type DracoMesh, meshDecoder } from './draco-mesh.js';
import type { Decode } from '../decoders/decoder.js';

/** Its console output is suppressed. */
export async function createDecoder(): Promise<Decode<DracoJob, DracoMesh>> {
  const silent = (): void => undefined;
  return meshDecoder(await createDraco({ print: silent, printErr: silent }));
}
