// The worker that decodes Draco data where the one with WebAssembly cannot start.
import { answerJobs } from '../decoders/answer-jobs.js';
import { createDecoder } from './draco.js';

answerJobs(createDecoder);
