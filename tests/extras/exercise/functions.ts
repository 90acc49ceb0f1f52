// Functions as learners write them: right ones in several writings, and wrong ones with the mistake
// that stands in their code.

const HEAD = 'vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye) {';

/** The whole equation, step by step. */
export const RIGHT = `${HEAD}
  vec3 N = normalize(normal);
  vec3 V = normalize(eye - p);
  vec3 toLight = light.position.w == 0.0 ? light.position.xyz : light.position.xyz - p;
  float d = length(toLight);
  vec3 L = toLight / d;
  float att = 1.0;
  if (light.position.w == 1.0) {
    att = 1.0 / max(light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d, 1.0);
  }
  vec3 A = normalize(light.axis);
  float c = dot(L, -A);
  if (light.aperture < 180.0 && c < cos(radians(light.aperture))) {
    return vec3(0.0);
  }
  float decay = light.cutoff > 0.0 ? pow((1.0 + c) / 2.0, light.cutoff) : 1.0;
  float NoL = dot(N, L);
  vec3 ambient = m.ka * light.ambient;
  vec3 diffuse = m.kd * light.diffuse * max(NoL, 0.0);
  vec3 specular = vec3(0.0);
  if (NoL > 0.0) {
    vec3 R = reflect(-L, N);
    specular = m.ks * light.specular * pow(max(dot(R, V), 0.0), m.shininess);
  }
  return decay * (ambient + att * (diffuse + specular));
}`;

/** The same in one expression after another, with what some people write. */
const SHORT = `#define saturate(x) clamp(x, 0.0, 1.0)
float falloff(vec3 k, float d) { return min(1.0 / dot(k, vec3(1.0, d, d * d)), 1.0); }
vec3 shade(const in Light light, Material m, in vec3 p, vec3 normal, vec3 eye) {
  vec3 D = mix(light.position.xyz, light.position.xyz - p, light.position.w);
  vec3 N = normalize(normal), L = normalize(D), V = normalize(eye - p);
  float angle = acos(clamp(-dot(L, normalize(light.axis)), -1.0, 1.0));
  float spot = degrees(angle) <= light.aperture ? pow(cos(angle / 2.0), 2.0 * light.cutoff) : 0.0;
  float lit = step(0.0, dot(N, L));
  vec3 R = 2.0 * dot(N, L) * N - L;
  vec3 sum = m.kd * light.diffuse * saturate(dot(N, L));
  sum += m.ks * light.specular * lit * pow(max(0.0, dot(V, R)), m.shininess);
  if (light.position.w > 0.5) sum *= falloff(light.attenuation, length(D));
  return spot * (m.ka * light.ambient + sum); // half-angle: (1 + cos a) / 2 = cos² (a / 2)
}`;

/** By a loop and a function for each term. */
const LONG = `const int CHANNELS = 3;
vec3 toLamp(Light light, vec3 p) {
  if (light.position.w < 0.5) { return light.position.xyz; }
  return light.position.xyz - p;
}
float lambert(vec3 n, vec3 l) {
  float x = dot(n, l);
  if (x < 0.) x = 0.;
  return x;
}
float lobe(vec3 n, vec3 l, vec3 v, float e) {
  if (lambert(n, l) <= 0.) return 0.;
  float x = dot(n * 2. * dot(n, l) - l, v);
  return x > 0. ? exp2(e * log2(x)) : 0.;
}
vec3 shade(Light lamp, Material mat, vec3 pos, vec3 n, vec3 camera) {
  vec3 way = toLamp(lamp, pos);
  vec3 l = way * inversesqrt(dot(way, way));
  n = normalize(n);
  vec3 v = (camera - pos) / distance(camera, pos);
  float dist = length(way);
  float denominator = lamp.attenuation.x + dist * (lamp.attenuation.y + dist * lamp.attenuation.z);
  float att = lamp.position.w < 0.5 || denominator < 1. ? 1. : 1. / denominator;
  float cosine = dot(-l, lamp.axis) / length(lamp.axis);
  float decay = 1.;
  if (lamp.aperture < 180. && cosine < cos(lamp.aperture * 3.14159265 / 180.)) decay = 0.;
  else if (lamp.cutoff > 0.) decay = pow(.5 + .5 * cosine, lamp.cutoff);
  vec3 color = vec3(0.);
  for (int i = 0; i < CHANNELS; i++) {
    color[i] += mat.ka[i] * lamp.ambient[i];
    color[i] += att * mat.kd[i] * lamp.diffuse[i] * lambert(n, l);
    color[i] += att * mat.ks[i] * lamp.specular[i] * lobe(n, l, v, mat.shininess);
  }
  return decay * color;
}`;

function replaced(source: string, from: string, to: string) {
  if (!source.includes(from)) throw new Error(`not in the function: ${from}`);
  return source.replaceAll(from, to);
}

/** The first writing with one piece or more replaced. */
const changed = (...pairs: readonly (readonly [from: string, to: string])[]) =>
  pairs.reduce((source, [from, to]) => replaced(source, from, to), RIGHT);

const inShort = (from: string, to: string) => replaced(SHORT, from, to);
const inLong = (from: string, to: string) => replaced(LONG, from, to);

const DIFFUSE = 'max(NoL, 0.0)';
const LOBE = 'pow(max(dot(R, V), 0.0), m.shininess)';
const GATE = 'if (NoL > 0.0) {';
const SUM = 'decay * (ambient + att * (diffuse + specular))';
const CONE = 'c < cos(radians(light.aperture))';

/** Right where the undefined power of a negative number is not above 0. */
export const UNDEFINED_POWER = changed([LOBE, 'max(pow(dot(R, V), m.shininess), 0.0)']);

export const RIGHT_ONES: Readonly<Record<string, string>> = {
  'step by step': RIGHT,
  'turned to the eye': changed(['toLight / d;', 'toLight / d; if (dot(N, V) < 0.) N = -N;']),
  'two gates': changed([GATE, '{'], [LOBE, `(NoL > 0.0 && dot(N, V) > 0.0 ? ${LOBE} : 0.0)`]),
  'with an array, and loops without braces': changed([
    'vec3 ambient = m.ka * light.ambient;',
    `const int COUNT = 2 * 2;
  float few[COUNT] = float[](1.0, 1.0, 1.0, 1.0), one = 0.0;
  for (int i = 0; i < 3; i++) if (NoL < 0.0) for (uint k = 0u; k < 3u; ++k) one += few[k] / 9.0;
  else one += few[i] / 3.0;
  if (NoL > 0.99) {
    int n = 0;
    for (int i = 0; i < 100; i++) for (int k = 0; k < 25; k++) { if (k % 2 == 0) continue; n++; }
    for (int i = 0; i < 100; i++) for (int k = 0; k < 100; k++) n++;
    for (int i = 0; i < 100; i++) for (int k = 0; k < 100; k++) n++;
    if (n != 21200) one = 0.0;
  }
  vec3 ambient = one * m.ka * light.ambient;`,
  ]),
  'a mirrored vector by hand': changed(['reflect(-L, N)', '-L - 2.0 * dot(N, -L) * N']),
  'the eye mirrored in place of the light': changed(['dot(R, V)', 'dot(L, reflect(-V, N))']),
  'in short': SHORT,
  'with functions and a loop': LONG,
  'the angle in degrees': changed([CONE, 'degrees(acos(c)) > light.aperture']),
  'its result between 0 and 1': changed([SUM, `clamp(${SUM}, 0.0, 1.0)`]),
  'in Portuguese, with words of precision': `precision mediump float;
// Iluminação de Phong: a cor de um ponto, com a luz «light»
const lowp float UM = 1.0;
${changed([DIFFUSE, 'max(NoL, UM - 1.0)'])}`,
  'with overloads and names used twice': `float lobe(float x, float e) { return x > 0.0 ? pow(x, e) : 0.0; }
float lobe(vec3 N, vec3 L, vec3 V, float e) {
  float lobe = dot(N, L) > 0.0 ? lobe(dot(reflect(-L, N), V), e) : 0.0;
  return lobe;
}
float positive(float x);
vec3 positive(vec3 x) { return vec3(positive(x.x), positive(x.y), positive(x.z)); }
float positive(float x) { return max(x, 0.0); }
${changed(
  [`pow(max(dot(R, V), 0.0), m.shininess)`, 'lobe(N, L, V, m.shininess)'],
  ['m.kd * light.diffuse * max(NoL, 0.0)', 'positive(m.kd * light.diffuse * NoL)'],
)}`,
  'with a macro over two lines': `#define LOBE(r, v) \\
  pow(max(dot(r, v), 0.0), m.shininess)
${changed([LOBE, 'LOBE(R, V)'])}`,
  'with spaces from elsewhere': `\uFEFF${RIGHT.replaceAll('  ', '\u00A0 ')}`,
  'with a power by hand': changed([LOBE, 'exp(m.shininess * log(max(dot(R, V), 1e-30)))']),
};

/** By what is wrong: two ids with a plus where both show. */
export const WRONG_ONES: Readonly<Record<string, Readonly<Record<string, string>>>> = {
  'no-clamp': {
    'plain dot': changed([DIFFUSE, 'NoL']),
    'in short': inShort('saturate(dot(N, L))', 'dot(N, L)'),
    'in a function': inLong('if (x < 0.) x = 0.;', '').replace(
      'if (lambert(n, l) <= 0.)',
      'if (dot(n, l) <= 0.)',
    ),
  },
  'abs-for-max': {
    diffuse: changed([DIFFUSE, 'abs(NoL)']),
    both: changed([DIFFUSE, 'abs(NoL)'], ['max(dot(R, V), 0.0)', 'abs(dot(R, V))']),
    'two-sided': changed([
      'vec3 N = normalize(normal);',
      'vec3 N = normalize(normal); if (dot(N, light.position.w == 0.0 ? light.position.xyz : light.position.xyz - p) < 0.0) N = -N;',
    ]),
  },
  'no-gate': {
    'no if': changed([GATE, '{']),
    'with a clamped result': changed([GATE, '{'], [SUM, `clamp(${SUM}, 0.0, 1.0)`]),
  },
  'half-lambert': {
    half: changed([DIFFUSE, '(0.5 * NoL + 0.5)']),
    squared: changed([DIFFUSE, 'pow(0.5 * NoL + 0.5, 2.0)']),
    'on the lit side': changed([DIFFUSE, '(NoL > 0.0 ? 0.5 * NoL + 0.5 : 0.0)']),
    'the gate too': changed(['float NoL = dot(N, L);', 'float NoL = dot(N, L) * 0.5 + 0.5;']),
  },
  'normal-not-unit': {
    all: changed(['normalize(normal)', 'normal']),
    'diffuse only': changed([DIFFUSE, 'max(dot(normal, L), 0.0)']),
  },
  'light-not-unit': {
    all: changed(['toLight / d', 'toLight']),
    'diffuse only': changed([DIFFUSE, 'max(dot(N, toLight), 0.0)']),
    'the sun only': changed(['toLight / d', 'light.position.w == 0.0 ? toLight : toLight / d']),
    'places only': changed(['toLight / d', 'light.position.w == 0.0 ? toLight / d : toLight']),
    'in short': inShort('L = normalize(D)', 'L = D').replace(
      'dot(L, normalize(light.axis))',
      'dot(normalize(L), normalize(light.axis))',
    ),
  },
  'view-not-unit': {
    all: changed(['normalize(eye - p)', 'eye - p']),
  },
  'half-not-unit': {
    'L + V': changed(['dot(R, V)', 'dot(N, L + V)']),
    'half of it': changed(['dot(R, V)', 'dot(N, (L + V) / 2.0)']),
  },
  'axis-not-unit': {
    all: changed(['normalize(light.axis)', 'light.axis']),
    'in a function': inLong(' / length(lamp.axis)', ''),
    'the cone of every light': changed([
      `light.aperture < 180.0 && ${CONE}`,
      'dot(-L, light.axis) < cos(radians(light.aperture))',
    ]),
    'with a clamped cosine': changed(
      ['normalize(light.axis)', 'light.axis'],
      ['dot(L, -A)', 'clamp(dot(L, -A), -1.0, 1.0)'],
    ),
  },
  'light-reversed': {
    'p minus place': changed(['light.position.xyz - p;', 'p - light.position.xyz;']),
    all: changed(['toLight / d', '-toLight / d']),
    'the axis': changed(['dot(L, -A)', 'dot(L, A)']),
    'all but the cone': changed(['toLight / d', '-toLight / d'], ['dot(L, -A)', 'dot(L, A)']),
    diffuse: changed([DIFFUSE, 'max(dot(N, -L), 0.0)']),
    'the normal': changed(['normalize(normal)', '-normalize(normal)']),
  },
  'view-reversed': {
    'p minus eye': changed(['normalize(eye - p)', 'normalize(p - eye)']),
    'reflect(L, N)': changed(['reflect(-L, N)', 'reflect(L, N)']),
  },
  'eye-at-origin': {
    'minus p': changed(['normalize(eye - p)', 'normalize(-p)']),
    'without p': changed(['normalize(eye - p)', 'normalize(eye)']),
  },
  'blinn-for-phong': {
    'half vector': changed(['dot(R, V)', 'dot(N, normalize(L + V))']),
    'with four times the exponent': changed(
      ['dot(R, V)', 'dot(N, normalize(L + V))'],
      ['m.shininess)', '4.0 * m.shininess)'],
    ),
  },
  'times-for-power': {
    times: changed([LOBE, 'max(dot(R, V), 0.0) * m.shininess']),
    'no exponent': changed([LOBE, 'max(dot(R, V), 0.0)']),
  },
  'exponent-on-diffuse': {
    pow: changed([DIFFUSE, `pow(${DIFFUSE}, m.shininess)`]),
    'in place of the highlight': changed(
      [DIFFUSE, `pow(${DIFFUSE}, m.shininess)`],
      [LOBE, 'max(dot(R, V), 0.0)'],
    ),
  },
  'specular-times-cosine': {
    times: changed([LOBE, `NoL * ${LOBE}`]),
    bracket: changed(
      [GATE, '{'],
      [`m.kd * light.diffuse * ${DIFFUSE}`, 'm.kd * light.diffuse'],
      [SUM, `decay * (ambient + att * ${DIFFUSE} * (diffuse + specular))`],
    ),
  },
  'ambient-attenuated': {
    'all of it': changed([SUM, 'decay * att * (ambient + diffuse + specular)']),
  },
  'no-ambient': {
    missing: changed([SUM, 'decay * att * (diffuse + specular)']),
    'on the far side': changed([SUM, `NoL > 0.0 ? ${SUM} : vec3(0.0)`]),
  },
  'no-diffuse': { missing: changed([SUM, 'decay * (ambient + att * specular)']) },
  'no-specular': { missing: changed([SUM, 'decay * (ambient + att * diffuse)']) },
  'no-diffuse + no-specular': { 'to begin with': changed([SUM, 'decay * ambient']) },
  'no-attenuation': {
    missing: changed([SUM, 'decay * (ambient + diffuse + specular)']),
    'by the length of L': changed(['toLight / d', 'toLight / d; d = length(L)']),
    'diffuse without': changed([SUM, 'decay * (ambient + diffuse + att * specular)']),
    'specular without': changed([SUM, 'decay * (ambient + att * diffuse + specular)']),
  },
  'distance-not-squared': {
    'd once': changed(['light.attenuation.z * d * d', 'light.attenuation.z * d']),
    'd twice': changed(['light.attenuation.z * d * d', 'light.attenuation.z * (d + d)']),
  },
  'attenuation-not-clamped': {
    'no max': changed([
      'max(light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d, 1.0)',
      '(light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d)',
    ]),
  },
  'w-ignored': {
    'always a place': changed([
      'light.position.w == 0.0 ? light.position.xyz : light.position.xyz - p',
      'light.position.xyz - p',
    ]),
    'always a direction': changed([
      'light.position.w == 0.0 ? light.position.xyz : light.position.xyz - p',
      'light.position.xyz',
    ]),
    'attenuates the sun': changed(['if (light.position.w == 1.0) {', '{']),
  },
  'aperture-in-radians': {
    cos: changed([CONE, 'c < cos(light.aperture)']),
    'of every light': changed([`light.aperture < 180.0 && ${CONE}`, 'c < cos(light.aperture)']),
  },
  'whole-aperture': {
    half: changed([CONE, 'c < cos(radians(light.aperture / 2.0))']),
    'of every light': changed([
      `light.aperture < 180.0 && ${CONE}`,
      'c < cos(radians(light.aperture / 2.0))',
    ]),
  },
  'no-cone': {
    missing: changed([`light.aperture < 180.0 && ${CONE}`, 'false']),
    'for the highlight': changed(
      ['return vec3(0.0);', 'cone = 0.0;'],
      [GATE, 'GATE'],
      ['float att = 1.0;', 'float att = 1.0; float cone = 1.0;'],
      ['GATE', GATE],
      [SUM, 'decay * (cone * ambient + att * (cone * diffuse + specular))'],
    ),
  },
  'ambient-outside-cone': {
    'returns ambient': changed(['return vec3(0.0);', 'return m.ka * light.ambient;']),
    'spot for two terms': inShort(
      'spot * (m.ka * light.ambient + sum)',
      'm.ka * light.ambient + spot * sum',
    ),
  },
  'cutoff-not-shifted': {
    // 0 to the power of 0 where a lamp has no cutoff.
    'plain c': changed([
      'light.cutoff > 0.0 ? pow((1.0 + c) / 2.0, light.cutoff) : 1.0',
      'pow(max(c, 0.0), light.cutoff)',
    ]),
    'without max': changed(['pow((1.0 + c) / 2.0, light.cutoff)', 'pow(c, light.cutoff)']),
  },
  'no-decay': {
    missing: changed([SUM, 'ambient + att * (diffuse + specular)']),
    'diffuse only': changed([SUM, 'ambient + att * (decay * diffuse + specular)']),
    'not ambient': changed([SUM, 'ambient + decay * att * (diffuse + specular)']),
  },
  'colours-added': {
    all: changed(
      ['m.ka * light.ambient', '(m.ka + light.ambient)'],
      ['m.kd * light.diffuse', '(m.kd + light.diffuse)'],
      ['m.ks * light.specular', '(m.ks + light.specular)'],
    ),
    ambient: changed(['m.ka * light.ambient', '(m.ka + light.ambient)']),
  },
  'scale-255': {
    divided: changed([SUM, `${SUM} / 255.0`]),
    times: changed([SUM, `255.0 * ${SUM}`]),
    ambient: changed(['m.ka * light.ambient', 'm.ka * light.ambient / 255.0']),
  },
  'exponent-on-diffuse + no-ambient': {
    'without max': changed(
      [DIFFUSE, 'pow(NoL, m.shininess)'],
      [SUM, 'decay * att * (diffuse + specular)'],
    ),
  },
  'no-clamp + specular-times-cosine': {
    'all times N·L': changed(
      [GATE, '{'],
      [`m.kd * light.diffuse * ${DIFFUSE}`, 'm.kd * light.diffuse'],
      [SUM, 'decay * (ambient + att * NoL * (diffuse + specular))'],
    ),
  },
  'no-clamp + no-gate': { both: changed([DIFFUSE, 'NoL'], [GATE, '{']) },
  'no-ambient + no-attenuation': { both: changed([SUM, 'decay * (diffuse + specular)']) },
  'normal-not-unit + view-reversed': {
    both: changed(['normalize(normal)', 'normal'], ['normalize(eye - p)', 'normalize(p - eye)']),
  },
  'no-gate + no-cone': {
    both: changed([GATE, '{'], [`light.aperture < 180.0 && ${CONE}`, 'false']),
  },
};

/** Wrong in ways that no usual mistake is: none may be named. */
export const UNUSUAL_ONES: Readonly<Record<string, string>> = {
  black: `${HEAD} return vec3(0.0); }`,
  'a constant': `${HEAD} return vec3(0.5, 0.2, 0.7); }`,
  'a power of negative numbers': changed(['max(dot(R, V), 0.0)', 'dot(R, V)']),
  'a toon': changed([SUM, `floor(4.0 * ${SUM}) / 4.0`]),
  'another falloff': changed([
    '1.0 / max(light.attenuation.x',
    '1.0 / max(1.0 + light.attenuation.x',
  ]),
  'not a number': `${HEAD} return vec3(sqrt(-1.0 - dot(p, p))); }`,
  'nothing drawn': `${HEAD} discard; return vec3(1.0); }`,
};

/** As much as the guard lets through, at some points only: tiles have grown by then. */
export const SLOW = `${HEAD}
  vec3 x = p;
  for (int i = 0; i < (gl_FragCoord.y > 50.0 ? 100 : 0); i++) for (int j = 0; j < 100; j++) { ${'x=sin(x+x.yzx);'.repeat(40)} }
  return x;
}`;

/** What the guard refuses, before anything is compiled, by a part of the reason. */
export const REFUSED_ONES: Readonly<Record<string, readonly [source: string, reason: string]>> = {
  'calls that double': [
    `float f0() { return 1.0; }
${Array.from({ length: 30 }, (_, i) => `float f${i + 1}() { return f${i}() + f${i}(); }`).join('\n')}
${HEAD} return vec3(f30()); }`,
    'The function does too much',
  ],
  'overloads that double': [
    `${Array.from({ length: 30 }, (_, i) => `struct S${i} { float x; }; float f(S${i} s);`).join('\n')}
${Array.from({ length: 29 }, (_, i) => `float f(S${i + 1} s) { return f(S${i}(s.x)) + f(S${i}(s.x)); }`).join('\n')}
float f(S0 s) { return s.x; } ${HEAD} return vec3(f(S29(1.0))); }`,
    'The function does too much',
  ],
  'a macro that doubles what it is given': [
    `#define D(x) ((x)+(x))\n${HEAD} return ${'D('.repeat(24)}p${')'.repeat(24)}; }`,
    'The function does too much',
  ],
  'a macro that is given to a macro': [
    `#define D(x) ((x)+(x))\n#define C(f, x) ${'f('.repeat(24)}x${')'.repeat(24)}\n${HEAD} return C(D, p); }`,
    'only #define is allowed',
  ],
  'a macro in place of the name of a function': [
    `#define F(n) float n(float x)\nF(f0) { return x; } F(f1) { return f0(x) + f0(x); } ${HEAD} return p; }`,
    'not allowed here: {',
  ],
  'a function that is given to a macro': [
    `#define F(n, b) float n(float x) b\nF(f0, { return x; }) ${HEAD} return p; }`,
    'Braces or brackets do not match',
  ],
  'a struct that a macro takes away': [
    `#define struct\n#define S\nfloat f(float x) struct S { return x; } ${HEAD} return p; }`,
    'not allowed here: {',
  ],
  'a block outside of functions': [`{ float x; } ${RIGHT}`, 'not allowed here: {'],
  while: [`${HEAD} while (true) {} return p; }`, 'A loop must be a for'],
  'the head of a loop in a macro': [
    `#define X(x) x\n${HEAD} for X((;;)) {} return p; }`,
    'A loop must be a for',
  ],
  'a loop in a macro': [
    `#define LOOP for(;;)\n${HEAD} LOOP {} return p; }`,
    'only #define is allowed',
  ],
  'an end of loops that a macro takes away': [
    `#define break\n${HEAD} for (;;) {} return p; }`,
    'only #define is allowed',
  ],
  'a bracket in a macro': [
    `#define OPEN (\n${HEAD} for OPEN;;) {} return p; }`,
    'Braces or brackets do not match',
  ],
  'turns that are counted anew': [
    `${HEAD} for (;;) { exerciseTurns = 0; } return p; }`,
    'not allowed here: exerciseTurns',
  ],
  'an open comment': [`${RIGHT}\n/* and the rest`, 'not allowed here: /*'],
  'a brace too many': [`${RIGHT} }`, 'Braces or brackets do not match'],
  'a brace too few': [RIGHT.slice(0, -1), 'Braces or brackets do not match'],
  'a long macro in many places': [
    `#define A ${'sin(p.x)+'.repeat(900)}0.0\n${HEAD} return vec3(${'A+'.repeat(900)}0.0); }`,
    'The function does too much',
  ],
  'a long function that is called often': [
    `float f(float x) { ${'x=sin(x);'.repeat(900)} return x; } ${HEAD} float x = p.x; ${'x=f(x);'.repeat(400)} return vec3(x); }`,
    'The function does too much',
  ],
  'a long function in a loop': [
    `${HEAD} vec3 x = p; for (int i = 0; i < 9; i++) { ${'x=sin(x);'.repeat(900)} } return x; }`,
    'The function does too much',
  ],
  'matrices by the hundred': [
    `${HEAD} mat4 a = mat4(p.x); ${'a=a*a;'.repeat(1500)} return a[0].xyz; }`,
    'The function does too much',
  ],
  'powers by the hundred': [
    `${HEAD} vec4 x = p.xyzx; ${'x=pow(x,x);'.repeat(1500)} return x.xyz; }`,
    'The function does too much',
  ],
  'a letter that looks like another': [RIGHT.replace('NoL', 'NоL'), '(U+043E)'],
  'too long': [`${RIGHT}\n${'//'.padEnd(25_000, 'x')}`, 'The text is too long'],
};

const LOOPS = 'Line 1: The function does too much';

/** What the compiler refuses, or the count of what loops do ends. */
export const STOPPED_ONES: Readonly<Record<string, readonly [source: string, reason: string]>> = {
  'no function': ['float x = 1.0;', 'There is no function shade'],
  'a prototype alone': [HEAD.replace(' {', ';'), 'There is no function shade'],
  'other parameters': [
    `vec3 shade(vec3 p) { return p; }`,
    'There is no function shade of this form',
  ],
  'our main': [`void main() {} ${RIGHT}`, "Line 1: 'main'"],
  'our struct': [`struct Light { vec3 a; };\n${RIGHT}`, "Line 1: 'Light'"],
  'two that call each other': [
    `float b(float x); float a(float x) { return b(x); } float b(float x) { return a(x); } ${HEAD} return vec3(a(1.0)); }`,
    'A function calls itself: ',
  ],
  'a wrong name': [RIGHT.replace('max(NoL', 'max(NoX'), 'Line 19: '],
  'a missing semicolon': [
    RIGHT.replace('float d = length(toLight);', 'float d = length(toLight)'),
    'Line 6: ',
  ],
  'a long array': [`${HEAD} float a[10 * 10]; return vec3(a[3]); }`, 'Line 1: An array has'],
  'an endless loop': [`${HEAD} for (;;) {}\nfor (;;) {} return p; }`, LOOPS],
  'a loop that is long at some points': [
    `${HEAD} float s = 0.0; for (int i = 0; i < (p.x > 0.4 ? 2000000000 : 1); i++) s += 1.0; return vec3(s); }`,
    LOOPS,
  ],
  'a counter that is set back': [
    `void back(inout int i) { i = 0; } ${HEAD} for (int i = 0; i < 9; i++) { back(i); } return p; }`,
    LOOPS,
  ],
  'loops in calls': [
    `float f() { float s = 0.0; for (int i = 0; i < 20000; i++) { s += 1.0; } return s; } ${HEAD} float s = 0.0; for (int i = 0; i < 20000; i++) { s += f(); } return vec3(s); }`,
    LOOPS,
  ],
  'a float': [
    RIGHT.replace('vec3 shade', 'float shade'),
    'Line 1: There is no function shade of this form',
  ],
  'an overload that calls itself': [
    `float f(float x) { return x; } vec2 f(vec2 x) { return f(x); } ${HEAD} return vec3(f(p.xy), f(1.0)); }`,
    'A function calls itself: f.',
  ],
};
