// Counts what a page sends to WebGL: draws, uploads and their bytes, programs and their text. Wraps
// all functions before any script runs, and can impose limits that this machine does not have.

import type { Page } from '@playwright/test';

/** Counts since the last reading. */
export interface GlSpent {
  /** Calls of any WebGL 2 function. */
  readonly calls: number;
  readonly draws: number;
  /** Links and compilations of general programs. */
  readonly links: number;
  readonly compiles: number;
  /** Calls that write into an existing texture or buffer, and their bytes. */
  readonly uploads: number;
  readonly bytes: number;
  /** Calls that allocate memory for a texture or buffer. */
  readonly allocations: number;
  /** Bytes of buffers that were allocated: geometries. */
  readonly bufferBytes: number;
}

export interface GlProgram {
  readonly vertex: string;
  readonly fragment: string;
  /** Linked, and neither deleted nor lost. */
  readonly live: boolean;
  /** Draw calls with it. */
  readonly draws: number;
  /** vec4s of its active uniforms outside of blocks, both stages together. */
  readonly uniformVectors: number;
  /** Bytes of its largest uniform block; 0 without any. */
  readonly blockBytes: number;
}

/** Values that `getParameter` returns instead of the real ones, by the constant's name. */
type Limits = Readonly<Record<string, number>>;

interface GlLog {
  take(): GlSpent;
  programs(): GlProgram[];
  drawnWith(): GlProgram[];
}

declare global {
  interface Window {
    glLog: GlLog;
  }
}

/** Logs all pages of this context that are opened later. */
export async function logGl(page: Page, limits: Limits = {}): Promise<void> {
  await page.addInitScript(wrapGl, limits);
}

/** Counts since the last call, or since the page was opened. */
export const glSpent = (page: Page): Promise<GlSpent> => page.evaluate(() => window.glLog.take());

/** All programs that were ever linked, in order. */
export const glPrograms = (page: Page): Promise<GlProgram[]> =>
  page.evaluate(() => window.glLog.programs());

/** The programs used since the last call of {@link glSpent}. */
export const drawnWith = (page: Page): Promise<GlProgram[]> =>
  page.evaluate(() => window.glLog.drawnWith());

/** A specialised program. */
export const isSpecialised = ({ fragment, vertex }: GlProgram): boolean =>
  /#define (?:LIGHT_STATEMENTS|HAS_LIGHT_GRID)/.test(fragment + vertex);

/** A program that runs the light loop; not one of the page's own objects. */
export const isLit = ({ fragment, vertex }: GlProgram): boolean =>
  /LightSums/.test(fragment + vertex);

/** Runs in the page. */
function wrapGl(limits: Limits) {
  type Call = (this: unknown, ...given: unknown[]) => unknown;
  interface Linked extends GlProgram {
    live: boolean;
    draws: number;
  }
  const gl = WebGL2RenderingContext.prototype;
  const none = () => ({
    calls: 0,
    draws: 0,
    links: 0,
    compiles: 0,
    uploads: 0,
    bytes: 0,
    allocations: 0,
    bufferBytes: 0,
  });
  let spent = none();
  const wrap = (name: string, before: (given: unknown[], self: WebGL2RenderingContext) => void) => {
    const real = Object.getOwnPropertyDescriptor(gl, name)?.value as Call | undefined;
    if (typeof real !== 'function') return;
    Reflect.set(gl, name, function (this: WebGL2RenderingContext, ...given: unknown[]) {
      before(given, this);
      return Reflect.apply(real, this, given);
    });
  };
  const named = new Map(
    Object.entries(limits).map(([name, value]) => [Reflect.get(gl, name) as unknown, value]),
  );
  const realParameter = Object.getOwnPropertyDescriptor(gl, 'getParameter')?.value as Call;
  gl.getParameter = function (this: unknown, name: number) {
    return named.get(name) ?? Reflect.apply(realParameter, this, [name]);
  };

  for (const name of Object.getOwnPropertyNames(gl)) {
    wrap(name, () => (spent.calls += 1));
    if (/^draw(?!ingBuffer|Buffers)/.test(name)) {
      wrap(name, (_, self) => draw(self));
    }
    if (/^tex(Image|Storage)/.test(name)) {
      wrap(name, () => (spent.allocations += 1));
    }
  }
  wrap('bufferData', ([, data]) => {
    spent.allocations += 1;
    spent.bufferBytes += typeof data === 'number' ? data : (data as ArrayBufferView).byteLength;
  });

  const CHANNELS: Readonly<Record<number, number>> = {
    [gl.RED]: 1,
    [gl.RG]: 2,
    [gl.RGB]: 3,
    [gl.RGBA]: 4,
  };
  wrap('texSubImage2D', ([, , , , width, height, format, type]) => {
    spent.uploads += 1;
    if (typeof type !== 'number') return; // the form that uploads an image
    const size = type === gl.FLOAT ? 4 : 1;
    spent.bytes += Number(width) * Number(height) * (CHANNELS[Number(format)] ?? 4) * size;
  });
  wrap('bufferSubData', ([, , data, , length]) => {
    spent.uploads += 1;
    const view = data as ArrayBufferView & { readonly BYTES_PER_ELEMENT?: number };
    spent.bytes +=
      typeof length === 'number' && length > 0
        ? length * (view.BYTES_PER_ELEMENT ?? 1)
        : view.byteLength;
  });

  const texts = new WeakMap<object, string>();
  const stages = new WeakMap<object, WebGLShader[]>();
  const linked = new Map<WebGLProgram, Linked>();
  const current = new WeakMap<WebGL2RenderingContext, WebGLProgram>();
  const recent = new Set<Linked>();
  wrap('shaderSource', ([shader, text]) => texts.set(shader as object, String(text)));
  wrap('attachShader', ([program, shader]) => {
    const present = stages.get(program as object) ?? [];
    stages.set(program as object, [...present, shader as WebGLShader]);
  });
  wrap(
    'compileShader',
    ([shader]) => (spent.compiles += isSpecialisedText(texts.get(shader as object)) ? 0 : 1),
  );
  wrap('useProgram', ([program], self) => {
    if (program === null) {
      current.delete(self);
    } else {
      current.set(self, program as WebGLProgram);
    }
  });
  const { linkProgram } = gl;
  gl.linkProgram = function (program) {
    linkProgram.call(this, program);
    const of = (kind: number) =>
      (stages.get(program) ?? [])
        .filter((shader) => this.getShaderParameter(shader, gl.SHADER_TYPE) === kind)
        .map((shader) => texts.get(shader) ?? '')
        .join('');
    const text = { vertex: of(gl.VERTEX_SHADER), fragment: of(gl.FRAGMENT_SHADER) };
    if (!isSpecialisedText(text.fragment)) {
      spent.links += 1;
    }
    linked.set(program, { ...text, ...sizes(program, this), live: true, draws: 0 });
  };
  wrap('deleteProgram', ([program]) => {
    const one = linked.get(program as WebGLProgram);
    if (one !== undefined) {
      one.live = false;
    }
  });

  function isSpecialisedText(text = '') {
    return /#define (?:LIGHT_STATEMENTS|HAS_LIGHT_GRID)/.test(text);
  }

  function draw(self: WebGL2RenderingContext) {
    spent.draws += 1;
    const one = linked.get(current.get(self) ?? {});
    if (one === undefined) return;
    one.draws += 1;
    recent.add(one);
  }

  /** vec4s of a uniform's type without packing: an upper bound for any driver. */
  function vectors(type: number): number {
    if (type === gl.FLOAT_MAT4) return 4;
    if (type === gl.FLOAT_MAT3) return 3;
    return type === gl.FLOAT_MAT2 ? 2 : 1;
  }

  function sizes(program: WebGLProgram, self: WebGL2RenderingContext) {
    const before = spent.calls;
    const count = (what: number) => Number(self.getProgramParameter(program, what));
    let uniformVectors = 0;
    for (let i = 0; i < count(gl.ACTIVE_UNIFORMS); i++) {
      const [block] = self.getActiveUniforms(program, [i], gl.UNIFORM_BLOCK_INDEX) as number[];
      const info = self.getActiveUniform(program, i);
      if (block === -1 && info !== null) {
        uniformVectors += info.size * vectors(info.type);
      }
    }
    let blockBytes = 0;
    for (let i = 0; i < count(gl.ACTIVE_UNIFORM_BLOCKS); i++) {
      const bytes = self.getActiveUniformBlockParameter(
        program,
        i,
        gl.UNIFORM_BLOCK_DATA_SIZE,
      ) as number;
      blockBytes = Math.max(blockBytes, bytes);
    }
    spent.calls = before; // without the calls made here
    return { uniformVectors, blockBytes };
  }

  window.glLog = {
    take() {
      const taken = spent;
      spent = none();
      recent.clear();
      return taken;
    },
    programs: () => [...linked.values()],
    drawnWith: () => [...recent],
  };
}
