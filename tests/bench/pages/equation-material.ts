// The element's equation as a ShaderMaterial of plain three.js: the package's light loop in a
// page's own program. With an opaque base texture at most, which is what the bench's whole pictures
// have.
import {
  CanvasTexture,
  DoubleSide,
  FrontSide,
  Matrix3,
  type Matrix4,
  NoColorSpace,
  ShaderMaterial,
  type Texture,
  Vector3,
} from 'three';
import {
  declaredFeatures,
  emptyPack,
  LIGHT_LOOP_GLSL,
  type LightValues,
  packLights,
  type PhongMaterial,
  type Vec3,
} from 'phong-viewer/core';
import { IDENTITY } from '../../support/matrices.js';

export type ShownMaterial = Pick<PhongMaterial, 'surface' | 'look' | 'sides'>;

const VERTEX = `
out vec3 vPoint;
out vec3 vOutward;
out vec2 vUv;
uniform mat3 uMapTransform;
uniform mat3 uNormals;
void main() {
  vec4 p = modelMatrix * vec4(position, 1.0);
  vPoint = p.xyz;
  vOutward = normalize(uNormals * normal);
#ifdef HAS_TEXTURE
  vUv = (uMapTransform * vec3(uv, 1.0)).xy;
#endif
  gl_Position = projectionMatrix * viewMatrix * p;
}`;

const FRAGMENT = `
precision highp int;
${LIGHT_LOOP_GLSL}
in vec3 vPoint;
in vec3 vOutward;
in vec2 vUv;
uniform vec3 uEyePoint;
uniform vec3 uKa;
uniform vec3 uKd;
uniform vec3 uKs;
uniform float uShininess;
uniform sampler2D uMap;
void main() {
  vec3 base = vec3(1.0);
#ifdef HAS_TEXTURE
  base = texture(uMap, vUv).rgb;
#endif
  vec3 normal = gl_FrontFacing ? vOutward : -vOutward;
  vec3 color = surfaceColor(vPoint, normal, uEyePoint, base * uKa, base * uKd, uKs, uShininess);
  gl_FragColor = vec4(min(color, 1.0), 1.0);
#ifdef DECODES
  gl_FragColor = sRGBTransferEOTF(gl_FragColor);
#endif
  #include <colorspace_fragment>
}`;

/**
 * `eye` and the mesh's `matrix` are in world space. `decodes`: writes linear light, which three.js
 * encodes on its way to the canvas; otherwise the equation's codes.
 */
export function equationMaterial(
  { surface, look, sides }: ShownMaterial,
  lights: Iterable<Readonly<LightValues>>,
  { eye, matrix }: { readonly eye: Vec3; readonly matrix: Matrix4 },
  decodes: boolean,
): ShaderMaterial {
  if (look.metalness > 0 || look.roughness !== null || look.unlit || look.alphaMode !== 'opaque') {
    throw new Error('this material is more than a base colour');
  }
  const values = [...lights];
  const packed = emptyPack();
  packLights(
    values,
    { worldToShading: IDENTITY, cameraToShading: IDENTITY, linear: false },
    packed,
  );
  const channels = (k: Vec3, base: Vec3) =>
    new Vector3(...k.map((value, i) => (value / 255) * base[i]!));
  const { map, baseColor } = look;
  return new ShaderMaterial({
    defines: {
      LIGHT_STORAGE: 'STORAGE_UNIFORMS',
      LIGHT_ROWS: packed.rows,
      DECLARED_FEATURES: declaredFeatures(values),
      ...(map !== null && { HAS_TEXTURE: '' }),
      ...(decodes && { DECODES: '' }),
    },
    uniforms: {
      uLightRows: { value: packed.data.slice(0, 4 * packed.rows) },
      uNormals: { value: new Matrix3().getNormalMatrix(matrix) },
      uEyePoint: { value: new Vector3(...eye) },
      uKa: { value: channels(surface.ka, baseColor) },
      uKd: { value: channels(surface.kd, baseColor) },
      uKs: { value: channels(surface.ks, [1, 1, 1]) },
      uShininess: { value: surface.shininess },
      uMap: { value: map === null ? null : copyOf(map) },
      uMapTransform: { value: map?.matrix.clone() ?? null },
    },
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: sides === 'closed' ? FrontSide : DoubleSide,
  });
}

/** A viewer that is removed closes its images. */
function copyOf(texture: Texture): Texture {
  const { wrapS, wrapT, magFilter, minFilter, generateMipmaps } = texture;
  const sampling = { wrapS, wrapT, magFilter, minFilter, generateMipmaps };
  const copy = new CanvasTexture(pictureOf(texture));
  return Object.assign(copy, sampling, { colorSpace: NoColorSpace, flipY: false });
}

export function pictureOf(texture: Texture): HTMLCanvasElement {
  const image = texture.image as ImageBitmap;
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext('2d', { willReadFrequently: true })!.drawImage(image, 0, 0);
  return canvas;
}
