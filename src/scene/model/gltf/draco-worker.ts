// The worker that decodes Draco data.
import { answerJobs } from '../decoders/answer-jobs.js';
import { createDecoder } from './draco.js';

answerJobs(createDecoder);
