// What decoders share, in workers and on the main thread. Must not import three.js: a worker would
// load all of it.

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
  | { readonly result: Result }
  | { readonly error: { readonly name: string; readonly message: string } };

/** Answers the messages of DecoderThread in the worker, in order. */
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

const post = (message: WorkerAnswer<unknown>, transfer: Transferable[]): void =>
  postMessage(message, { transfer });

/** What the factory of such a decoder is given. */
export interface WasmOptions {
  readonly instantiateWasm: (
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance) => void,
  ) => object;
  readonly print: (text: string) => void;
  readonly printErr: (text: string) => void;
}

/**
 * The magic number and version of a module without content (WebAssembly core specification 5.5.16).
 */
const EMPTY_MODULE = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/** @throws WebAssembly.CompileError, or EvalError in WebKit, if a policy does not allow it. */
export async function startWasm<Decoder>(
  create: (options: WasmOptions) => Promise<Decoder>,
  address: string,
): Promise<Decoder> {
  // Throws where a policy refuses WebAssembly, before the file is fetched in vain.
  new WebAssembly.Module(EMPTY_MODULE);
  const response = await fetch(address);
  if (!response.ok) {
    throw new Error(`the server answered ${String(response.status)} for ${address}`);
  }
  const wasm = await response.arrayBuffer();
  const silent = (): void => undefined;
  return new Promise((resolve, reject) => {
    create({
      print: silent,
      printErr: silent,
      // If this fails, the decoder itself would wait for ever.
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiate(wasm, imports).then(({ instance }) => done(instance), reject);
        return {};
      },
    }).then(resolve, reject);
  });
}
