// The interface of a decoder, on the main thread and in a worker. Types only.

/** Makes a decoder. @param setup what it needs to start, such as the address of its WebAssembly. */
export type CreateDecoder<Job, Result> = (setup: string) => Promise<Decode<Job, Result>>;

export type Decode<Job, Result> = (job: Job) => Decoded<Result> | Promise<Decoded<Result>>;

export interface Decoded<Result> {
  readonly result: Result;
  /** Parts of the result that a worker transfers instead of copying. Each once. */
  readonly transfer: Transferable[];
}

/** A worker's answer to a message. The first message is the setup, the others are jobs. */
export type WorkerAnswer<Result> =
  { readonly result: Result } | { readonly error: { readonly name: string; readonly message: string } };
