// What shadeAt explains and toBlob encodes, copied when they are called: their code may still have to be fetched, and
// the scene changes meanwhile.
import type { ViewerExtras } from './extras.js';
import { lazyCode } from '../../model/lazy-code.js';
import type { LightState, LightValues } from '../../light/light-state.js';
import type { Size } from '../../scene/gpu/atlas.js';
import type { SceneSnapshot } from '../../scene/snapshot/scene-snapshot.js';
import type { Viewport } from '../../scene/viewport.js';
import { zoomOf } from '../dom.js';
import { phrase, type ViewerTexts } from '../fields/texts.js';
import type { PhongLight, PhongMesh, PhongViewer } from '../elements.js';
import { numberedName } from '../phong-light.js';
import type { PictureOptions } from './picture-blob.js';
import type { ViewerChildren } from './children.js';
import { elementOf } from './children.js';

export interface ViewerSnapshot {
  /** Null while the picture has no box on the page. */
  readonly scene: SceneSnapshot<PhongMesh | PhongViewer> | null;
  /** Size of the picture, in the CSS pixels of pointer events. */
  readonly width: number;
  readonly height: number;
  readonly lights: readonly {
    /** Null for the head-light. */
    readonly light: PhongLight | null;
    readonly name: string;
    readonly values: LightValues;
  }[];
}

/** As the panel and explanations name a light; `index` counts the viewer's lights from 0. */
export const lightName = (
  light: PhongLight | null,
  { values }: LightState,
  index: number,
  texts: ViewerTexts | null = null,
): string => (light === null ? phrase(texts, 'head-light') : values.name || numberedName(index, texts));

/** `size` is the picture's size in CSS pixels, before any transform or zoom. */
export function viewerSnapshot(
  viewer: PhongViewer,
  viewport: Viewport,
  children: Pick<ViewerChildren, 'lightOf'>,
  size: { readonly width: number; readonly height: number },
): ViewerSnapshot {
  const { holder, picture, still } = viewport;
  // Inside CSS zoom, pointer events use the page's pixels and sizes use the element's own.
  const zoom = zoomOf(holder);
  return {
    // The triangles of the picture that is shown.
    scene:
      holder.getClientRects().length > 0
        ? picture.snapshot(viewport, Math.max(still.samples, 1), (mesh) => elementOf(mesh) ?? viewer)
        : null,
    width: size.width * zoom,
    height: size.height * zoom,
    lights: picture.lighting.lights.lights.map((state, index) => {
      const light = children.lightOf(state);
      return { light, name: lightName(light, state, index, viewer.texts), values: { ...state.values } };
    }),
  };
}

/** The picture as a file, with what `extras` draw over it. Waits for their code. */
export async function blobOf(
  viewport: Viewport,
  extras: Pick<ViewerExtras, 'pending' | 'drawOver'>,
  options: PictureOptions,
): Promise<Blob> {
  const { pending } = extras;
  if (pending !== null) await pending;
  const { samples } = options;
  if (samples !== undefined && !(Number.isInteger(samples) && samples >= 1 && samples <= MOST_SAMPLES))
    throw new RangeError(`toBlob: samples must be a whole number from 1 to 1024, got ${String(samples)}`);
  const size = sizeOf(viewport, options);
  const picture =
    size && (samples === undefined ? viewport.capture(size) : await viewport.still.capture(size, samples));
  const drawn = picture === null ? null : extras.drawOver(picture, options);
  const { pictureBlob } = await lazy.picture();
  await drawn;
  return pictureBlob(picture, options);
}

const MOST_SAMPLES = 1024;

/** The picture's size, by default the canvas's own; null for an invalid one. */
function sizeOf(viewport: Viewport, options: PictureOptions): Size | null {
  const width = options.width ?? Math.max(viewport.width, 1);
  const height = options.height ?? Math.max(viewport.height, 1);
  return [width, height].every((side) => Number.isInteger(side) && side >= 1) ? { width, height } : null;
}

/** Code that the snapshots are for. */
export const lazy = {
  picture: /* @__PURE__ */ lazyCode(() => import('./picture-blob.js'), 'toBlob'),
  shadeAt: /* @__PURE__ */ lazyCode(() => import('./shade-at.js'), 'shadeAt'),
};
