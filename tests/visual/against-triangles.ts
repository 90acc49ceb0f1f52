// How far is a picture from its own triangles in float64? In 8-bit codes. Under Gouraud shading the
// colours of their vertices are interpolated.
import { type BufferGeometry, Matrix3, Vector3 } from 'three';
import { flatGeometry } from '../../src/phong/material/flat-geometry.js';
import { srgbEncode } from '../../src/phong/math/color.js';
import { add, map, scale, type Vec3 } from '../../src/phong/math/vector.js';
import { shade } from '../../src/phong/reference/equation.js';
import { createGeometry } from '../../src/phong/model/shapes/shapes.js';
import { coneMargin } from '../stress/contract.js';
import type { CastScene } from '../../src/extras/still/cast-scene.js';
import { Tracer } from '../../src/extras/still/tracer.js';
import { shadedAt } from '../support/shaded-at.js';
import type { Picture } from '../support/test.js';
import { around, compareChannel, CONE_EDGE, type Errors, remembered } from './against-reference.js';
import {
  type CastMesh,
  castSceneOf,
  type DeclaredScene,
  matrixOf,
  trianglesOf,
} from './ray-cast.js';

/**
 * Whose square of this half side lies in one triangle, in pixels, a pixel is of one sample: also
 * where edges are snapped to the coarsest grid that OpenGL ES allows, 1/16 of a pixel.
 */
const WHOLE = 1 / 2 + 1 / 16;

/**
 * Of channels inside triangles. `snapped`: those more than a code off, which snapped vertices may
 * explain.
 */
interface TriangleErrors extends Errors {
  snapped: number;
}

/**
 * Rasterisers move vertices to a grid of `1 / 2^subpixelBits` pixels, so what is interpolated is
 * that of a point up to half a step away on each axis. A channel more than a code off is held
 * against the range of colours among which that is.
 */
export function compareWithTriangles(
  picture: Picture,
  scene: DeclaredScene,
  shading: string,
  subpixelBits: number,
): TriangleErrors {
  const { inside, colorAt } = seenOf(scene, picture.width, picture.height, shading);
  const errors: TriangleErrors = { max: 0, at: '', compared: 0, exact: 0, snapped: 0 };
  const reach = 2 ** -subpixelBits / 2;
  for (const { x, y, color, margin } of inside) {
    if (margin < CONE_EDGE) continue;
    for (let channel = 0; channel < 3; channel++) {
      compareChannel(errors, picture, { x, y, channel }, 255 * color[channel]!, () => {
        errors.snapped += 1;
        return around(reach, (dx, dy) => code(colorAt(x + dx, y + dy).color, channel));
      });
    }
  }
  return errors;
}

const code = (color: Vec3, channel: number) => Math.round(color[channel]! * 255);

/**
 * A colour, 0–1, and the angle to the nearest cone's edge: the least of the vertices' under
 * Gouraud.
 */
interface Seen {
  readonly color: Vec3;
  readonly margin: number;
}

/** The pixels inside triangles, but those at the picture's border, and the colour anywhere. */
const seenOf = remembered(
  (scene: DeclaredScene, width: number, height: number, shading: string) => {
    const geometry = cornersOf(scene.meshes[0]!, shading);
    const cast = castSceneOf(scene, () => trianglesOf(geometry));
    const tracer = new Tracer(cast, width, height);
    const triangleAt = (x: number, y: number) => {
      const { t, triangle } = tracer.hitAt(x + 0.5, y + 0.5);
      return t < Infinity ? triangle : -1;
    };
    const colorAt =
      shading === 'gouraud' ? perVertex(scene, tracer, geometry) : perFragment(scene, tracer, cast);
    const inside: (Seen & { readonly x: number; readonly y: number })[] = [];
    for (let y = 1; y < height - 1; y++) {
      for (let x = 1; x < width - 1; x++) {
        const triangle = triangleAt(x, y);
        const isWhole = around(WHOLE, (dx, dy) => triangleAt(x + dx, y + dy)).every(
          (other) => other === triangle,
        );
        if (triangle >= 0 && isWhole) {
          inside.push({ x, y, ...colorAt(x, y) });
        }
      }
    }
    return { inside, colorAt };
  },
);

/** The mesh's own triangles. Corners share nothing. */
function cornersOf({ geometry, segments }: CastMesh, shading: string) {
  const made = createGeometry(geometry, segments) as BufferGeometry;
  const split = shading === 'flat' ? flatGeometry(made) : made;
  return split.index === null ? split : split.toNonIndexed();
}

type ColorAt = (x: number, y: number) => Seen;

const perFragment =
  (scene: DeclaredScene, tracer: Tracer, cast: CastScene): ColorAt =>
  (x, y) => {
    const shaded = shadedAt(tracer, cast, x + 0.5, y + 0.5)!;
    return { color: shaded.color, margin: Math.abs(coneMargin(scene.lights, shaded)) };
  };

/**
 * Gouraud: the vertices' colours are interpolated before they are clamped and, for linear light,
 * encoded.
 */
function perVertex(scene: DeclaredScene, tracer: Tracer, geometry: BufferGeometry): ColorAt {
  const [mesh] = scene.meshes as [CastMesh];
  const matrix = matrixOf(mesh);
  const normalMatrix = new Matrix3().getNormalMatrix(matrix);
  const { camera } = tracer.screen;
  // One picture of a sphere never shows both sides of a vertex.
  const known = new Map<number, { readonly sum: Vec3; readonly margin: number }>();
  const shadeCorner = (corner: number, front: boolean) => {
    const present = known.get(corner);
    if (present) return present;
    const at = (name: string) =>
      new Vector3().fromBufferAttribute(geometry.getAttribute(name), corner);
    const p = at('position').applyMatrix4(matrix).toArray();
    const normal = scale(at('normal').applyNormalMatrix(normalMatrix).toArray(), front ? 1 : -1);
    const shaded = shade({ p, normal, eye: camera.eye }, mesh, scene.lights, {
      ...scene.options,
      camera,
    });
    const terms = shaded.shares.flatMap((s) =>
      s === null ? [] : [s.ambient, s.diffuse, s.specular],
    );
    const made = {
      sum: terms.reduce(add, [0, 0, 0]),
      margin: Math.abs(coneMargin(scene.lights, shaded)),
    };
    known.set(corner, made);
    return made;
  };
  return (x, y) => {
    const { triangle, front, a, b, c } = tracer.hitAt(x + 0.5, y + 0.5);
    const corners = [0, 1, 2].map((k) => shadeCorner(3 * triangle + k, front));
    const sum = [a, b, c].map((share, k) => scale(corners[k]!.sum, share)).reduce(add);
    const encoded = scene.options.linear === true ? map(sum, srgbEncode) : sum;
    return {
      color: map(encoded, (one) => Math.min(Math.max(one, 0), 1)),
      margin: Math.min(...corners.map(({ margin }) => margin)),
    };
  };
}
