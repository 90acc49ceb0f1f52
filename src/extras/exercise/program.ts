// Runs a learner's function on points, in a WebGL 2 context of its own: whatever it does, it can
// only take its own away. The learner's text comes last in the program, so nothing in it reaches
// ours. Floats come back as bits in whole numbers, which every WebGL 2 can draw.
import {
  BufferGeometry,
  Camera,
  DataTexture,
  FloatType,
  GLSL3,
  Mesh,
  RawShaderMaterial,
  RGBAFormat,
  RGBAIntegerFormat,
  UnsignedIntType,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { GIVEN_GLSL } from './solution.js';
import type { Lamp } from '../../phong/mistakes/sheet.js';
import { type Fault, Refused, refused, TOO_MUCH } from './guard.js';
import type { Case, Work } from '../../phong/mistakes/judge.js';
import { inTasks } from '../explain/in-tasks.js';

const VERTEX = `void main() {
  gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);
}`;

/** Cases, and lamps, in a row of the texture; side of the largest tile. */
const WIDTH = 64;

/**
 * The GLSL before a learner's text. Errors give the text's own lines, as source 1. The guard puts `exerciseStop`
 * into each turn of a loop. GLSL leaves the power of a negative number undefined: here it is NaN, or
 * that of its absolute value, as some drivers have it. 0 to the power of 0, as for a lamp without
 * cutoff, is undefined too: here it is 1, as in the equation. `mediump` and `lowp` would be half floats on
 * phones, which make a right function wrong.
 */
const PRELUDE = `precision highp float;
precision highp int;
precision highp sampler2D;
${GIVEN_GLSL};
bool exerciseAbsolute = false;
float exercisePow(float x, float y) {
  if (x < 0.0 && !exerciseAbsolute) return uintBitsToFloat(0x7fc00000u);
  return y == 0.0 ? 1.0 : pow(abs(x), y);
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
uniform int exerciseMost;
int exerciseWork = 0, exerciseLine = 0;
bool exerciseStop(int line, int code) {
  exerciseWork += code;
  if (exerciseWork > exerciseMost && exerciseLine == 0) exerciseLine = line;
  return exerciseLine > 0;
}
uniform sampler2D exerciseData;
layout(location = 0) out uvec4 exerciseResult;
vec4 exerciseLight(int i, int k) {
  return texelFetch(exerciseData, ivec2(6 * (i % ${WIDTH}) + k, i / ${WIDTH}), 0);
}
vec4 exercisePoint(int k) {
  return texelFetch(exerciseData, ivec2(gl_FragCoord.xy) * ivec2(6, 1) + ivec2(k, 0), 0);
}
void main() {
  vec4 p = exercisePoint(0), normal = exercisePoint(1), eye = exercisePoint(2);
  vec4 a = exercisePoint(3), b = exercisePoint(4), c = exercisePoint(5);
  Material m = Material(a.xyz, vec3(a.w, b.xy), vec3(b.zw, c.x), eye.w);
  exerciseAbsolute = c.y > 0.0;
  vec3 sum = vec3(0.0);
  for (int i = int(p.w); i < int(p.w + normal.w); i++) {
    a = exerciseLight(i, 0); b = exerciseLight(i, 1); c = exerciseLight(i, 2);
    vec4 d = exerciseLight(i, 3), e = exerciseLight(i, 4), f = exerciseLight(i, 5);
    sum += shade(
      Light(
        a.xyz, vec3(a.w, b.xy), vec3(b.zw, c.x), vec4(c.yzw, d.x),
        d.yzw, e.x, e.y, vec3(e.zw, f.x)
      ),
      m, p.xyz, normal.xyz, eye.xyz
    );
  }
  exerciseResult = uvec4(floatBitsToUint(sum), exerciseLine + 1);
}
#define pow exercisePow
#define mediump highp
#define lowp highp
#line 1 1
`;

/** Milliseconds of drawing, after which no further tile is drawn. */
const PATIENCE = 2000;

/** Milliseconds: only after a quicker tile tiles grow. */
const QUICK = 100;

/**
 * Pixels of the first tile, and of the smallest. An endless loop may do 1.25e8 at a pixel: with the
 * slowest functions in it about 5e8 cycles of a GPU (estimated), a third of a second of a slow one.
 */
const FEWEST = 16;

/**
 * What the loops of a tile may do, in what the guard counts: half a second in software. A frame that
 * runs cannot be stopped, and a function may be slow at some points only.
 */
const MOST_WORK = 2e9;

/**
 * The sums at the cases, three numbers each. From the case `absolute` on a negative number has the
 * power of its absolute value. Throws {@link Refused} where there are none, and the
 * signal's reason after an abort.
 */
export async function run(
  glsl: string,
  cases: readonly Case[],
  absolute: number,
  signal: AbortSignal,
): Promise<Float32Array> {
  const context = document
    .createElement('canvas')
    .getContext('webgl2', { antialias: false, depth: false, powerPreference: 'low-power' });
  if (context === null) throw refused('An exercise needs WebGL 2.');
  try {
    const colors = await draw(context, glsl, cases, absolute, signal);
    if (!context.isContextLost()) return colors;
  } catch (error) {
    if (!context.isContextLost()) throw error;
  } finally {
    // Browsers keep few contexts, so none waits for the next run.
    context.getExtension('WEBGL_lose_context')?.loseContext();
  }
  // A driver has given up, or the page has taken the context away.
  throw refused('The graphics driver has stopped. The next run starts anew.');
}

/**
 * A renderer of one triangle over all pixels, by the learner's function, and what it draws to. The
 * uniform `exerciseMost` limits what the loops at a pixel may do. Throws {@link Refused} where the
 * program does not compile.
 */
function rendererOf(
  context: WebGL2RenderingContext,
  glsl: string,
  data: DataTexture,
  lines: number,
) {
  const geometry = new BufferGeometry();
  geometry.setDrawRange(0, 3);
  // Without prototypes: three.js would use what a page added to Object.prototype.
  Object.setPrototypeOf(geometry.attributes, null);
  // A function's parameters have the qualifiers of its prototype.
  const own = glsl.replace(/\bvec3\s+shade\s*\([^)]*\)/g, (head) => head.replace(/\bconst\b/g, ''));
  const uniforms = { exerciseData: { value: data }, exerciseMost: { value: 0 } };
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    defines: Object.create(null) as Record<string, string>,
    vertexShader: VERTEX,
    fragmentShader: PRELUDE + own,
    uniforms,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  const target = new WebGLRenderTarget(WIDTH, lines, {
    format: RGBAIntegerFormat,
    type: UnsignedIntType,
    depthBuffer: false,
  });
  target.scissorTest = true;
  // Without the canvas three.js does not hear of a lost context, which it would log and restore.
  const renderer = new WebGLRenderer({ context });
  // three.js would log what a driver remarks on a right program.
  renderer.debug.checkShaderErrors = false;
  renderer.compile(mesh, camera);
  requireLinked(context, renderer);
  return { renderer, mesh, target, uniforms };
}

/** The colours of {@link run}, drawn in tiles because a frame that runs cannot be stopped. */
async function draw(
  context: WebGL2RenderingContext,
  glsl: string,
  cases: readonly Case[],
  absolute: number,
  signal: AbortSignal,
) {
  const lines = Math.ceil(cases.length / WIDTH);
  const texels = await inTasks(packed(cases, absolute, WIDTH * lines), signal);
  const across = 6 * WIDTH;
  const data = new DataTexture(texels, across, texels.length / 4 / across, RGBAFormat, FloatType);
  data.needsUpdate = true;
  const { renderer, mesh, target, uniforms } = rendererOf(context, glsl, data, lines);
  const colors = new Float32Array(3 * cases.length);
  let at = 0;
  // Pixels of the next tile, and their upper bound: a fourth of a tile that was too much work.
  let count = FEWEST;
  let most = WIDTH ** 2;
  let spent = 0;
  let least = QUICK;
  while (at < cases.length) {
    // Timers of a hidden page wait for up to a second, and drawing would seem slow.
    if (document.hidden) {
      await new Promise((resolve) =>
        document.addEventListener('visibilitychange', resolve, { once: true }),
      );
    }
    signal.throwIfAborted();
    if (spent > PATIENCE) {
      throw refused('The function takes too long: drawing stopped after two seconds.');
    }
    const [x, y] = [at % WIDTH, Math.floor(at / WIDTH)];
    const width = Math.min(count, WIDTH - x);
    const height = width < WIDTH ? 1 : Math.min(count / WIDTH, lines - y);
    const start = performance.now();
    uniforms.exerciseMost.value = MOST_WORK / count;
    target.scissor.set(x, y, width, height);
    renderer.setRenderTarget(target);
    renderer.render(mesh, camera);
    await drawn(context);
    const bits = new Uint32Array(4 * width * height);
    // three.js reads only the driver's preferred format. Every WebGL 2 can read this one.
    context.readPixels(x, y, width, height, context.RGBA_INTEGER, context.UNSIGNED_INT, bits);
    const took = performance.now() - start;
    // What a frame takes apart from its pixels. The first one is not counted: in it drivers finish
    // compiling.
    least = Math.min(least, took);
    spent += at === 0 ? 0 : took - least;
    const floats = new Float32Array(bits.buffer);
    for (let i = 0; i < bits.length && at < cases.length; i += 4, at++) {
      // Cleared to 1, which stays where the function discards the pixel.
      const line = bits[i + 3]! - 1;
      if (line > 0) {
        if (count === FEWEST) throw refused(TOO_MUCH, line);
        most = count / 4;
        break;
      }
      colors.set(floats.subarray(i, i + 3), 3 * at);
    }
    count = Math.min(took - least < QUICK ? 4 * count : count, most);
  }
  return colors;
}

const camera = new Camera();

/**
 * The page goes on while the GPU draws. Rejects where the context is lost; three.js's own wait would
 * not end then.
 */
async function drawn(gl: WebGL2RenderingContext) {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  do {
    await new Promise((resolve) => setTimeout(resolve));
  } while (gl.clientWaitSync(fence!, 0, 0) === gl.TIMEOUT_EXPIRED);
}

/** Throws {@link Refused} with what the compiler has against the program, by the learner's lines. */
function requireLinked(gl: WebGL2RenderingContext, { info }: WebGLRenderer) {
  const [built] = info.programs!;
  const program = built!.program as WebGLProgram;
  if (gl.getProgramParameter(program, gl.LINK_STATUS) !== false) return;
  const log = gl.getShaderInfoLog(built!.fragmentShader) || gl.getProgramInfoLog(program) || '';
  // Some drivers end a log with a null character.
  const errors = log.match(/^ERROR: [^\n\0]*/gm) ?? [log];
  throw new Refused(errors.map(faultIn));
}

function faultIn(message: string): Fault {
  const [, part, line, said = message] = /^ERROR: (\d+):(\d+): (.*)$/.exec(message) ?? [];
  const [, name = ''] = /Recursive function call.*\b(\w+)$/.exec(said) ?? [];
  let text = said.replace(/exercisePow/g, 'pow');
  if (name !== '') {
    text = RECURSION;
  } else if (/same return type|Function shade\(\)/.test(said)) {
    text = NO_SHADE;
  } else if (said.includes('array size')) {
    text = ARRAY;
  }
  return { text, values: { name }, line: part === '1' ? Number(line) : null };
}

const ARRAY = 'An array has 1 to 63 elements.';
const RECURSION = 'A function calls itself: {name}. GLSL has no recursion.';
const NO_SHADE =
  'There is no function shade of this form: vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye).';

/** What a lamp's texels hold, in the order of the struct. */
export const LAMP = [
  'ambient',
  'diffuse',
  'specular',
  'position',
  'axis',
  'aperture',
  'cutoff',
  'attenuation',
] as const;

/** Six texels a case, and behind all of them six a lamp; each list of lamps once. */
function* packed(cases: readonly Case[], absolute: number, count: number): Work<Float32Array> {
  const rows: (readonly number[])[] = [];
  rows.length = count;
  const firsts = new Map<Lamp, number>();
  for (const [i, at] of cases.entries()) {
    yield;
    const [given] = at;
    if (given === undefined) continue;
    const { material: m, p, normal, eye, light } = given;
    const first = firsts.get(light) ?? rows.length;
    if (first === rows.length) {
      firsts.set(light, first);
      rows.push(...at.map((one) => LAMP.flatMap((key) => one.light[key])));
    }
    rows[i] = [
      ...p,
      first,
      ...normal,
      at.length,
      ...eye,
      m.shininess,
      ...m.ka,
      ...m.kd,
      ...m.ks,
      Number(i >= absolute),
    ];
  }
  const texels = new Float32Array(24 * WIDTH * Math.ceil(rows.length / WIDTH));
  // A case without a lamp has no row.
  rows.forEach((row, i) => texels.set(row, 24 * i));
  return texels;
}
