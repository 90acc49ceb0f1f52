// The worker that decodes Draco data, by WebAssembly.
import createDraco from 'three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js';
import { answerJobs, startWasm } from '../decoders/decoder.js';
import { meshDecoder } from './draco-mesh.js';

answerJobs(async (source) => meshDecoder(await startWasm(createDraco, source)));
