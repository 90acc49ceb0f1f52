// Twenty behaviours that some test must hold on to. Each guard puts a wrong function in place of an exported one and
// names the test file that must notice. Plain functions, so that no source text is matched and names are checked by the
// compiler.

import type * as drag from '../../src/camera/drag.js';
import type * as fit from '../../src/camera/fit.js';
import type * as step from '../../src/camera/step.js';
import type * as turntable from '../../src/camera/turntable.js';
import type * as attributeText from '../../src/element/fields/attribute-text.js';
import type * as fieldStore from '../../src/fields/field-store.js';
import type * as angle from '../../src/math/angle.js';
import type * as color from '../../src/math/color.js';
import type * as vector from '../../src/math/vector.js';
import type * as equation from '../../src/reference/equation.js';
import type * as linkedUrls from '../../src/model/model-content.js';
import type * as nearDepth from '../../src/scene/near-depth.js';
import type * as sampling from '../../src/scene/snapshot/sample.js';

interface Guard {
  readonly behaviour: string;
  readonly module: string;
  /** The test file that must fail. */
  readonly test: string;
  /** Wrong exports, made from the right ones. */
  readonly wrong: (real: never) => object;
}

function guard<M>(behaviour: string, module: string, test: string, wrong: (real: M) => Partial<M>): Guard {
  return { behaviour, module: `src/${module}.ts`, test: `tests/unit/${test}.test.ts`, wrong };
}

type Shade = Parameters<typeof equation.shade>;
/** The reference with every light changed. */
const withLights =
  (change: Partial<Shade[2][number]>) =>
  ({ shade }: typeof equation): Partial<typeof equation> => ({
    shade: (fragment, surface, lights, options) =>
      shade(
        fragment,
        surface,
        lights.map((light) => ({ ...light, ...change })),
        options,
      ),
  });

export const GUARDS: readonly Guard[] = [
  ...(
    [
      ['a cone cuts off everything outside', { aperture: 180 }],
      ['a spot decays away from its axis', { cutoff: 0 }],
      ['a lamp fades with distance', { attenuation: [1, 0, 0] }],
      ['an inactive light adds nothing', { active: true }],
    ] as const
  ).map(([behaviour, change]) =>
    guard<typeof equation>(behaviour, 'reference/equation', 'equation-limits', withLights(change)),
  ),
  guard<typeof color>('colours above 1 keep their power branch', 'math/color', 'color', ({ srgbDecode }) => ({
    srgbDecode: (x) => srgbDecode(Math.min(x, 1)),
  })),
  guard<typeof color>('linear light is decoded before it is summed', 'math/color', 'equation-limits', () => ({
    srgbDecode: (x) => x,
  })),
  guard<typeof vector>('vectors of any length become unit vectors', 'math/vector', 'vector', () => ({
    normalize: ([x, y, z]) => {
      const length = Math.sqrt(x * x + y * y + z * z);
      return length === 0 ? [0, 0, 0] : [x / length, y / length, z / length];
    },
  })),
  guard<typeof vector>('the cross product is right-handed', 'math/vector', 'vector', ({ cross }) => ({
    cross: (a, b) => cross(b, a),
  })),
  guard<typeof angle>('quarter turns are exact', 'math/angle', 'angle', ({ radians }) => ({
    cosDegrees: (degrees) => Math.cos(radians(degrees)),
  })),
  guard<typeof angle>('the shown azimuth lies in [-180, 180)', 'math/angle', 'angle', ({ wrapDegrees }) => ({
    wrapDegrees: (degrees) => (degrees === 180 ? 180 : wrapDegrees(degrees)),
  })),
  guard<typeof drag>(
    'a drag that ends where it began leaves no trace',
    'camera/drag',
    'camera-drag-traces',
    ({ turnBy, turn }) => ({
      turn: (noted, dx, dy, view) => turnBy(turn(noted, dx, dy, view), 1e-9, 0),
    }),
  ),
  guard<typeof drag>('zooming stops at its limits', 'camera/drag', 'camera-laws', () => ({
    zoomBy: (noted, factor) => ({ ...noted, radius: noted.radius * factor }),
  })),
  guard<typeof drag>('shifting keeps the point under the pointer', 'camera/drag', 'camera-laws', ({ shift }) => ({
    shift: (noted, dx, dy, view) => shift(noted, dx * 1.01, dy, view),
  })),
  guard<typeof fit>(
    'the fit considers the smaller of both fields of view',
    'camera/fit',
    'camera-fit',
    ({ fitRadius }) => ({
      fitRadius: (radius, fov) => fitRadius(radius, fov, 1),
    }),
  ),
  guard<typeof fit>('near and far hold the scene', 'camera/fit', 'camera-fit', ({ depthRange }) => ({
    depthRange: (pose, bounds, out) => {
      const range = depthRange(pose, bounds, out);
      range.far *= 0.9;
      return range;
    },
  })),
  guard<typeof nearDepth>('nothing in view is cut', 'scene/near-depth', 'near-depth', () => ({
    nearestDepth: (_root, _view, limit) => limit,
  })),
  guard<typeof step>('many small wheel turns zoom as far as one large one', 'camera/step', 'camera-laws', () => ({
    wheelZoom: (noted, { deltaY }) => ({ ...noted, radius: noted.radius * (1 + deltaY / 1000) }),
  })),
  guard<typeof turntable>('turning for ever keeps the angle small', 'camera/turntable', 'camera-turntable', () => ({
    turnedBy: (speed, milliseconds) => (speed * milliseconds) / 1000,
  })),
  guard<typeof attributeText>(
    'a number followed by anything else is refused',
    'element/fields/attribute-text',
    'attribute-text',
    ({ parseText }) => ({
      parseText: (text, of) => parseText(text, of) ?? (Number.parseFloat(text) || undefined),
    }),
  ),
  guard<typeof fieldStore>('a value is compared by what it holds', 'fields/field-store', 'field-store', () => ({
    sameValue: (a: unknown, b: unknown) => a === b,
  })),
  guard<typeof linkedUrls>('a model’s files come from its own folder', 'model/model-content', 'model-sources', () => ({
    linkedUrl: (uri, model) => new URL(uri, model),
  })),
  guard<typeof sampling>('textures are interpolated', 'scene/snapshot/sample', 'sample', ({ sampleTexture }) => ({
    sampleTexture: (texels, map, u, v) =>
      sampleTexture(texels, map, (Math.floor(u * texels.width) + 0.5) / texels.width, v),
  })),
];
