// The worker that decodes KTX2 textures, and the same decoder for the main thread: one file is both.
import { answerJobs } from '../decoders/decoder.js';
import { createDecoder } from './ktx2.js';

export { createDecoder };

if ('importScripts' in globalThis) {
  answerJobs(createDecoder);
}
