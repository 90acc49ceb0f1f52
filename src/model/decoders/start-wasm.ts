// Starts a decoder that Emscripten compiled to WebAssembly, from the address of its file. Runs in workers and on the
// main thread.

/** What the factory of such a decoder is given. */
export interface WasmOptions {
  readonly instantiateWasm: (imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) => object;
  readonly print: (text: string) => void;
  readonly printErr: (text: string) => void;
}

/** The magic number and version of a module without content (WebAssembly core specification 5.5.16). */
const EMPTY_MODULE = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/**
 * The decoder, with its console output suppressed.
 * @throws WebAssembly.CompileError, or EvalError in WebKit, if a policy does not allow it.
 */
export async function startWasm<Decoder>(
  create: (options: WasmOptions) => Promise<Decoder>,
  address: string,
): Promise<Decoder> {
  // Throws where a policy refuses WebAssembly, before the file is fetched in vain.
  new WebAssembly.Module(EMPTY_MODULE);
  const response = await fetch(address);
  if (!response.ok) throw new Error(`the server answered ${String(response.status)} for ${address}`);
  const wasm = await response.arrayBuffer();
  const silent = (): void => undefined;
  return new Promise((resolve, reject) => {
    create({
      print: silent,
      printErr: silent,
      // If this fails, the decoder itself would wait for ever.
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiate(wasm, imports).then(({ instance }) => {
          done(instance);
        }, reject);
        return {};
      },
    }).then(resolve, reject);
  });
}
