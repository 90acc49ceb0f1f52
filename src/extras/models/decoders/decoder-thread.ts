// Where meshes and textures are decompressed: in a worker, one for each decoder, which keeps the
// page alive and ends at once with an abort. On the main thread where no worker can start: the
// package on another origin, a page opened from disk, a policy without workers or without
// WebAssembly, a bundler that left the worker's file out.
import type { CreateDecoder, WorkerAnswer } from './decoder.js';

/**
 * How long a worker waits for another job, in milliseconds. The models of a page come one after
 * another, and each start fetches and compiles the decoder again. Its heap never shrinks and is
 * freed when the worker ends.
 */
const IDLE_MS = 5000;

/** A decoder that has started. */
interface Session<Job, Result> {
  decode(job: Job, signal: AbortSignal): Promise<Result>;
  end(): void;
}

/** Jobs are done one after the other: however many models are read, there is one worker. */
export class DecoderThread<Job, Result> {
  /** Null once it did not start: it is not tried again. */
  #worker: (() => Worker | null) | null;
  readonly #code: () => Promise<CreateDecoder<Job, Result>>;
  readonly #setup: string;
  #last: Promise<unknown> = Promise.resolve();
  #session: Promise<Session<Job, Result>> | null = null;
  #idle: ReturnType<typeof setTimeout> | undefined;

  /**
   * @param worker starts a worker with the decoder. Null: there is no worker's file.
   * @param code the same decoder for the main thread. Its error is the caller's, where the worker
   * did not start either.
   * @param setup the address of what the decoder gets when it starts, or empty.
   */
  constructor(
    worker: () => Worker | null,
    code: () => Promise<CreateDecoder<Job, Result>>,
    setup: string,
  ) {
    this.#worker = worker;
    this.#code = code;
    this.#setup = setup;
  }

  /**
   * Starts the decoder ahead of the first job, so that it is there when the job's bytes have
   * arrived.
   */
  start(): void {
    if (this.#session) return;
    this.#session = this.#open();
    this.#session.catch(() => undefined); // the first job gets the error
    this.#rest();
  }

  /**
   * @param job is copied for the worker.
   * @throws what the decoder throws, by message and name, or the signal's reason after an abort.
   */
  decode(job: Job, signal: AbortSignal): Promise<Result> {
    const result = this.#last.then(() => this.#decodeNow(job, signal));
    const nothing = (): void => undefined;
    this.#last = result.then(nothing, nothing); // not the result, which can be large: this promise stays
    return result;
  }

  async #decodeNow(job: Job, signal: AbortSignal): Promise<Result> {
    signal.throwIfAborted();
    clearTimeout(this.#idle);
    try {
      const session = await (this.#session ??= this.#open());
      signal.throwIfAborted();
      const result = await session.decode(job, signal);
      this.#rest();
      return result;
    } catch (error) {
      // It may still be at work, or broken by what it was given.
      this.#close();
      throw error;
    }
  }

  async #open(): Promise<Session<Job, Result>> {
    // Beside the worker's file, not after it.
    const fetching = new AbortController();
    const setup = bytesOr(this.#setup, fetching.signal);
    const worker = await this.#openWorker(setup);
    if (worker) return worker;
    fetching.abort('no worker'); // a policy without WebAssembly most likely
    const create = await this.#code();
    this.#worker = null;
    const decode = await create(this.#setup);
    return { decode: async (job) => (await decode(job)).result, end: () => undefined };
  }

  /** Null if it cannot start. */
  async #openWorker(setup: Promise<unknown>): Promise<Session<Job, Result> | null> {
    let worker: Worker | null = null;
    try {
      worker = this.#worker?.() ?? null;
      if (worker === null) return null;
      await answerOf(worker, setup);
      const started = worker;
      return {
        decode: (job, signal) => answerOf(started, job, signal),
        end: () => started.terminate(),
      };
    } catch {
      worker?.terminate();
      return null;
    }
  }

  /** Ends the session after a while, unless it is used again. */
  #rest() {
    clearTimeout(this.#idle);
    this.#idle = setTimeout(() => this.#close(), IDLE_MS);
  }

  #close() {
    this.#session?.then((session) => session.end()).catch(() => undefined);
    this.#session = null;
  }
}

/** The bytes at an address; the address itself where the decoder has to say what is wrong. */
async function bytesOr(address: string, signal: AbortSignal): Promise<unknown> {
  if (address === '') return address;
  try {
    const response = await fetch(address, { signal });
    if (response.ok) return await response.arrayBuffer();
  } catch {
    // As above.
  }
  return address;
}

/** Sends a message and waits for its answer, or for what the worker says before. */
async function answerOf<Result>(
  worker: Worker,
  message: unknown,
  signal?: AbortSignal,
): Promise<Result> {
  const done = new AbortController();
  const until = { signal: done.signal };
  try {
    return await new Promise<Result>((resolve, reject) => {
      const answered = ({ data }: MessageEvent<WorkerAnswer<Result>>): void => {
        if ('result' in data) {
          resolve(data.result);
        } else {
          reject(Object.assign(new Error(data.error.message), { name: data.error.name }));
        }
      };
      const failed = (event: Event): void => {
        // Otherwise the browser would report it as the page's own.
        event.preventDefault();
        reject(new Error('the decoder has stopped'));
      };
      worker.addEventListener('message', answered, until);
      worker.addEventListener('error', failed, until);
      worker.addEventListener('messageerror', failed, until);
      signal?.addEventListener('abort', () => reject(signal.reason as Error), until);
      void Promise.resolve(message).then((ready) => worker.postMessage(ready));
    });
  } finally {
    done.abort('answered');
  }
}
