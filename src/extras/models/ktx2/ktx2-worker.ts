// The worker that decodes KTX2 textures.
import { answerJobs } from '../decoders/decoder.js';
import { createDecoder } from './ktx2.js';

answerJobs(createDecoder);
