// A thread of the ray caster: casts the bands of rows that it is sent.
import { parentPort, workerData } from 'node:worker_threads';
import { castRows } from './picture.js';
import type { CastOptions, CastScene } from './scene.js';
import { Tracer } from './tracer.js';

const { scene, options } = workerData as { scene: CastScene; options: CastOptions };
const tracer = new Tracer(scene, options.width, options.height);

parentPort?.on('message', ({ from, to }: { from: number; to: number }) => {
  const means = castRows(tracer, options, from, to);
  parentPort?.postMessage({ from, means }, [means.buffer as ArrayBuffer]);
});
