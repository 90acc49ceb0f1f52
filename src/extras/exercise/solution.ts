// The GLSL that an exercise shows: what a function gets, what an empty one looks like, and the
// exact one.
import type { Task } from '../../phong/mistakes/sheet.js';

export const GIVEN_GLSL = `struct Light {
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
vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye)`;

export const STARTING_GLSL = `vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye) {
  return m.ka * light.ambient;
}`;

/** The exact function of an exercise, without what it does not ask for. */
export function solutionFor({ terms, kinds, reflection }: Task): string {
  const has = (term: Task['terms'][number]) => terms.includes(term);
  const isPlace = kinds.some((kind) => kind !== 'directional');
  const isSpot = kinds.includes('spot');
  const isSurface = has('diffuse') || has('specular');
  const att = isPlace ? ' * att' : '';
  const sum = [
    has('ambient') ? 'm.ka * light.ambient' : '',
    has('diffuse') ? `m.kd * light.diffuse * max(NoL, 0.0)${att}` : '',
    has('specular') ? `m.ks * light.specular * spec${att}` : '',
  ].filter(Boolean);
  const direction = isSurface ? 'vec3 D = light.position.xyz;' : '';
  const lines = [
    isPlace
      ? 'vec3 D = light.position.w == 0.0 ? light.position.xyz : light.position.xyz - p;'
      : direction,
    isSurface || isSpot ? 'vec3 L = normalize(D);' : '',
    isSpot
      ? `float c = dot(L, -normalize(light.axis));
  if (light.aperture < 180.0 && acos(clamp(c, -1.0, 1.0)) > radians(light.aperture)) return vec3(0.0);
  float decay = light.cutoff > 0.0 ? pow((c + 1.0) / 2.0, light.cutoff) : 1.0;`
      : '',
    isPlace && isSurface
      ? `float d = length(D);
  vec3 k = light.attenuation;
  float att = light.position.w == 0.0 ? 1.0 : 1.0 / max(k.x + k.y * d + k.z * d * d, 1.0);`
      : '',
    isSurface
      ? `vec3 N = normalize(normal);
  float NoL = dot(N, L);`
      : '',
    has('specular')
      ? `vec3 V = normalize(eye - p);
  float cosine = dot(${reflection === 'phong' ? 'reflect(-L, N), V' : 'N, normalize(L + V)'});
  float spec = NoL > 0.0 ? pow(max(cosine, 0.0), m.shininess) : 0.0;`
      : '',
    `return ${isSpot ? 'decay * (' : ''}${sum.join(' + ')}${isSpot ? ')' : ''};`,
  ];
  const body = lines.filter(Boolean).map((line) => `  ${line}\n`);
  return `vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye) {\n${body.join('')}}`;
}
