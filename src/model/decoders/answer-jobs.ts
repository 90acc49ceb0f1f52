// Answers the messages of DecoderThread in the worker.
import type { CreateDecoder, Decode, WorkerAnswer } from './decoder-thread.js';

/** Answers each message, in order. */
export function answerJobs<Job, Result>(create: CreateDecoder<Job, Result>): void {
  let decode: Decode<Job, Result> | null = null;
  let last = Promise.resolve();
  const answer = async (data: unknown): Promise<void> => {
    try {
      if (decode === null) {
        decode = await create(data as string);
        post({ result: null }, []);
      } else {
        const { result, transfer } = await decode(data as Job);
        post({ result }, transfer);
      }
    } catch (error) {
      const { name, message } = error instanceof Error ? error : new Error(String(error));
      post({ error: { name, message } }, []);
    }
  };
  addEventListener('message', ({ data }: MessageEvent<unknown>) => {
    last = last.then(() => answer(data));
  });
}

function post(message: WorkerAnswer<unknown>, transfer: Transferable[]): void {
  postMessage(message, { transfer });
}
