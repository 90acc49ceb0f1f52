// What decoders share, in workers and on the main thread. Must not import three.js: a worker would
// load all of it.

/** Makes a decoder. @param setup its WebAssembly, or the address of that. */
export type CreateDecoder<Job, Result> = (
  setup: string | ArrayBuffer,
) => Promise<Decode<Job, Result>>;

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

/**
 * Answers the messages of DecoderThread in the worker, in order. Where a policy refuses WebAssembly
 * it says so at once, which ends the download of that.
 */
export function answerJobs<Job, Result>(create: CreateDecoder<Job, Result>): void {
  try {
    new WebAssembly.Module(EMPTY_MODULE);
  } catch (error) {
    post(failure(error), []);
    return;
  }
  let decode: Decode<Job, Result> | null = null;
  let last = Promise.resolve();
  const answer = async (data: unknown): Promise<void> => {
    try {
      if (decode === null) {
        decode = await create(data as string | ArrayBuffer);
        post({ result: null }, []);
      } else {
        const { result, transfer } = await decode(data as Job);
        post({ result }, transfer);
      }
    } catch (error) {
      post(failure(error), []);
    }
  };
  addEventListener('message', ({ data }: MessageEvent<unknown>) => {
    last = last.then(() => answer(data));
  });
}

function failure(thrown: unknown): WorkerAnswer<never> {
  const { name, message } = thrown instanceof Error ? thrown : new Error(String(thrown));
  return { error: { name, message } };
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

/**
 * @param source the WebAssembly, or its address.
 * @throws WebAssembly.CompileError, or EvalError in WebKit, if a policy does not allow it.
 */
export async function startWasm<Decoder>(
  create: (options: WasmOptions) => Promise<Decoder>,
  source: string | ArrayBuffer,
): Promise<Decoder> {
  // Throws where a policy refuses WebAssembly: then the file is not fetched.
  new WebAssembly.Module(EMPTY_MODULE);
  const wasm = typeof source === 'string' ? await bytesAt(source) : source;
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

async function bytesAt(address: string): Promise<ArrayBuffer> {
  const response = await fetch(address);
  if (response.ok) return response.arrayBuffer();
  throw new Error(`the server answered ${String(response.status)} for ${address}`);
}
