// The worker that decodes Draco data, by WebAssembly.
import createDraco from 'three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js';
import { answerJobs } from '../decoders/answer-jobs.js';
import { startWasm } from '../decoders/start-wasm.js';
import { meshDecoder } from './draco-mesh.js';

answerJobs(async (address) => meshDecoder(await startWasm(createDraco, address)));
