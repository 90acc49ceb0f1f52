// Runs a learner's function on points, in a WebGL 2 context of its own: whatever it does, it can
// only take its own away. The learner's text comes last in the program, so nothing in it reaches
// ours. Floats come back as bits in whole numbers, which every WebGL 2 can draw.
import type { Lamp } from '../../phong/mistakes/sheet.js';
import { ALL_TURNS, type Fault, faultOf, loopFault } from './guard.js';
import type { Case, Work } from '../../phong/mistakes/judge.js';
import { inTasks } from '../explain/in-tasks.js';

const VERTEX = `#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);
}`;

/** Cases, and lamps, in a row of the textures; side of the largest tile. */
const WIDTH = 64;

/**
 * What a learner's text stands behind; `exerciseStop` is asked in each turn of a loop. The power of a negative number is undefined in GLSL, and some
 * drivers give that of its amount: here it is not a number.
 * Words of less precision are those of phones, where half floats would make a right function wrong.
 */
const PRELUDE = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
struct Light {
  vec3 ambient, diffuse, specular;
  vec4 position;
  vec3 axis;
  float aperture;
  float cutoff;
  vec3 attenuation;
};
struct Material {
  vec3 ka, kd, ks;
  float shininess;
};
vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye);
float exercisePow(float x, float y) {
  return x < 0.0 ? uintBitsToFloat(0x7fc00000u) : pow(x, y);
}
vec2 exercisePow(vec2 x, vec2 y) {
  return vec2(exercisePow(x.x, y.x), exercisePow(x.y, y.y));
}
vec3 exercisePow(vec3 x, vec3 y) {
  return vec3(exercisePow(x.xy, y.xy), exercisePow(x.z, y.z));
}
vec4 exercisePow(vec4 x, vec4 y) {
  return vec4(exercisePow(x.xy, y.xy), exercisePow(x.zw, y.zw));
}
int exerciseTurns, exerciseLine = 0;
bool exerciseStop(int line) {
  if (++exerciseTurns > ${ALL_TURNS}) exerciseLine = line;
  return exerciseLine > 0;
}
uniform sampler2D exercisePoints;
uniform sampler2D exerciseLights;
out uvec4 exerciseResult;
vec4 exerciseLight(int i, int k) {
  return texelFetch(exerciseLights, ivec2(6 * (i % ${WIDTH}) + k, i / ${WIDTH}), 0);
}
vec4 exercisePoint(int k) {
  return texelFetch(exercisePoints, ivec2(gl_FragCoord.xy) * ivec2(6, 1) + ivec2(k, 0), 0);
}
void main() {
  vec4 p = exercisePoint(0), normal = exercisePoint(1), eye = exercisePoint(2);
  Material m = Material(
    exercisePoint(3).xyz, exercisePoint(4).xyz, exercisePoint(5).xyz, eye.w
  );
  vec3 sum = vec3(0.0);
  for (int i = int(p.w); i < int(p.w + normal.w); i++) {
    vec4 ambient = exerciseLight(i, 0), diffuse = exerciseLight(i, 1);
    exerciseTurns = 0;
    sum += shade(
      Light(
        ambient.xyz, diffuse.xyz, exerciseLight(i, 2).xyz, exerciseLight(i, 3),
        exerciseLight(i, 4).xyz, ambient.w, diffuse.w, exerciseLight(i, 5).xyz
      ),
      m, p.xyz, normal.xyz, eye.xyz
    );
  }
  exerciseResult = uvec4(floatBitsToUint(sum), exerciseLine + 1);
}
#define pow exercisePow
#define mediump highp
#define lowp highp
`;

const LINES = PRELUDE.split('\n').length - 1;

/** Milliseconds of drawing, after which no further tile is drawn. */
const PATIENCE = 2000;

/** Milliseconds: a frame that runs cannot be stopped, so only after a quicker one tiles grow. */
const QUICK = 100;

const SLOW = faultOf('The function takes too long: drawing stopped after two seconds.');

/** Milliseconds for one tile, after which drivers give up themselves. */
const WATCHDOG = 20_000;

/** Null where there is no WebGL 2. */
export const openContext = (): WebGL2RenderingContext | null =>
  document
    .createElement('canvas')
    .getContext('webgl2', { antialias: false, depth: false, powerPreference: 'low-power' });

export class Program {
  readonly #gl: WebGL2RenderingContext;
  readonly #pixels: WebGLBuffer | null;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#pixels = gl.createBuffer();
  }

  /** A driver has given up, or the page has taken the context away. Then any method may throw. */
  isLost(): boolean {
    return this.#gl.isContextLost();
  }

  /**
   * The sums at the cases, three numbers each; or why they take too long. Throws the signal's
   * reason after an abort.
   */
  async run(cases: readonly Case[], signal: AbortSignal): Promise<Float32Array | Fault> {
    const gl = this.#gl;
    const height = Math.ceil(cases.length / WIDTH);
    const [points, lamps] = await inTasks(packed(cases, WIDTH * height), signal);
    this.#upload(0, points);
    this.#upload(1, lamps);
    const target = gl.createTexture();
    gl.activeTexture(gl.TEXTURE2);
    gl.bindTexture(gl.TEXTURE_2D, target);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, WIDTH, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    gl.viewport(0, 0, WIDTH, height);
    gl.enable(gl.SCISSOR_TEST);
    const colors = new Float32Array(3 * cases.length).fill(NaN);
    let [at, count, spent, least] = [0, 1, 0, QUICK];
    while (at < cases.length) {
      // Its timers wait for a second, so that drawing would seem slow.
      if (document.hidden) {
        await new Promise((resolve) =>
          document.addEventListener('visibilitychange', resolve, { once: true }),
        );
      }
      signal.throwIfAborted();
      if (spent > PATIENCE) return SLOW;
      const [x, y] = [at % WIDTH, Math.floor(at / WIDTH)];
      const width = Math.min(count, WIDTH - x);
      const rows = width < WIDTH ? 1 : Math.min(count / WIDTH, height - y);
      const start = performance.now();
      const bits = await this.#draw(x, y, width, rows);
      const took = performance.now() - start;
      // What a frame takes without its pixels. Drivers finish a program in its first one.
      least = Math.min(least, took);
      spent += at === 0 ? 0 : took - least;
      const floats = new Float32Array(bits.buffer);
      for (let i = 0; i < bits.length && at < cases.length; i += 4, at++) {
        const line = bits[i + 3]! - 1;
        if (line > 0) return loopFault(line);
        // Where the function has discarded the pixel nothing is written.
        if (line === 0) {
          colors.set(floats.subarray(i, i + 3), 3 * at);
        }
      }
      if (took - least < QUICK) {
        count = Math.min(4 * count, WIDTH ** 2);
      }
    }
    return colors;
  }

  /** Browsers keep few contexts, so none waits for the next run. */
  dispose(): void {
    this.#gl.getExtension('WEBGL_lose_context')?.loseContext();
  }

  /** The page goes on while the GPU draws. */
  async #draw(x: number, y: number, width: number, height: number): Promise<Uint32Array> {
    const gl = this.#gl;
    const bits = new Uint32Array(4 * width * height);
    gl.scissor(x, y, width, height);
    gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.#pixels);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, bits.byteLength, gl.STREAM_READ);
    gl.readPixels(x, y, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, 0);
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const end = performance.now() + WATCHDOG;
    do {
      await new Promise((resolve) => setTimeout(resolve));
      if (performance.now() > end) {
        this.dispose();
      }
      if (drawn === null || this.isLost()) throw new Error('lost');
    } while (gl.clientWaitSync(drawn, 0, 0) === gl.TIMEOUT_EXPIRED);
    gl.deleteSync(drawn);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, bits);
    return bits;
  }

  /** Rows of six texels for each of WIDTH. */
  #upload(unit: number, texels: Float32Array): void {
    const gl = this.#gl;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    const height = texels.length / 24 / WIDTH;
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 6 * WIDTH, height, 0, gl.RGBA, gl.FLOAT, texels);
  }

  /** What the compiler has against it; empty where it can run. */
  build(glsl: string): readonly Fault[] {
    const gl = this.#gl;
    const program = gl.createProgram();
    // A function's parameters have the qualifiers of its prototype.
    const own = glsl.replace(/\bvec3\s+shade\s*\([^)]*\)/g, (head) =>
      head.replace(/\bconst\b/g, ''),
    );
    for (const [type, source] of [
      [gl.VERTEX_SHADER, VERTEX],
      [gl.FRAGMENT_SHADER, PRELUDE + own],
    ] as const) {
      const shader = gl.createShader(type)!;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (gl.getShaderParameter(shader, gl.COMPILE_STATUS) === false) {
        return messagesIn(gl.getShaderInfoLog(shader) ?? '', own);
      }
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (gl.getProgramParameter(program, gl.LINK_STATUS) === false) {
      return messagesIn(gl.getProgramInfoLog(program) ?? '', own);
    }
    gl.useProgram(program);
    gl.uniform1i(gl.getUniformLocation(program, 'exercisePoints'), 0);
    gl.uniform1i(gl.getUniformLocation(program, 'exerciseLights'), 1);
    return [];
  }
}

/** What the compiler says, by the learner's lines. */
function messagesIn(log: string, glsl: string): Fault[] {
  const lines = log
    .replace(/\0/g, '')
    .split('\n')
    .map((line) => line.trim())
    .filter((line) => line !== '' && !line.startsWith('WARNING'));
  return (lines.length > 0 ? lines : [log]).map((line) => {
    const [, number, text = line] = /^ERROR: \d+:(\d+): (.*)$/.exec(line) ?? [];
    const own = Number(number) - LINES;
    const at = own > 0 ? own : null;
    const [, name] = /Recursive function call.*\b(\w+)$/.exec(text) ?? [];
    if (name !== undefined) {
      return faultOf('A function calls itself: {name}. GLSL has no recursion.', { name });
    }
    const isOther = /same return type/.test(text) && /\bshade\b/.test(glsl.split('\n')[own - 1]!);
    if (isOther || text.includes('Function shade()')) {
      return faultOf(/\bshade\s*\(/.test(glsl) ? OTHER_SHADE : NO_SHADE, {}, at);
    }
    return { text: text.replace(/exercisePow/g, 'pow'), values: {}, line: at };
  });
}

const NO_SHADE =
  'There is no function shade. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).';
const OTHER_SHADE =
  'shade has other parameters. Write vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).';

/** Six texels a case, and six a lamp; each list of lamps once. */
function* packed(
  cases: readonly Case[],
  count: number,
): Work<readonly [points: Float32Array, lamps: Float32Array]> {
  const points = new Float32Array(24 * count);
  const lamps: Lamp[] = [];
  const firsts = new Map<Lamp, number>();
  for (const [i, at] of cases.entries()) {
    const [given] = at;
    yield;
    if (given === undefined) continue;
    const { material: m, p, normal, eye, light } = given;
    let first = firsts.get(light);
    if (first === undefined) {
      firsts.set(light, (first = lamps.length));
      lamps.push(...at.map((one) => one.light));
    }
    points.set(
      [...p, first, ...normal, at.length, ...eye, m.shininess, ...m.ka, 0, ...m.kd, 0, ...m.ks, 0],
      24 * i,
    );
  }
  const rows = new Float32Array(24 * WIDTH * Math.max(Math.ceil(lamps.length / WIDTH), 1));
  for (const [i, { ambient, diffuse, specular, position, axis, ...rest }] of lamps.entries()) {
    rows.set([...ambient, rest.aperture, ...diffuse, rest.cutoff, ...specular, 0], 24 * i);
    rows.set([...position, ...axis, 0, ...rest.attenuation, 0], 24 * i + 12);
  }
  return [points, rows];
}
