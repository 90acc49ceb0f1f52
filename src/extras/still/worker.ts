// A thread of the ray caster.
import { workerData } from 'node:worker_threads';
import { type CastJob, castShare } from './threads.js';

castShare(workerData as CastJob);
