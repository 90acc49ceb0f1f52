// What shadeAt explains and toBlob encodes, taken at their call: the code that does it may still have to come, and the scene
// goes on meanwhile. Knows neither rays nor files.
import type { LightValues } from '../../light/light-state.js';
import type { SceneSnapshot } from '../../scene/snapshot/scene-snapshot.js';
import type { Viewport } from '../../scene/viewport.js';
import type { PhongLight } from '../phong-light.js';
import type { PhongMesh } from '../phong-mesh.js';
import type { PhongViewer } from '../phong-viewer.js';
import type { PictureOptions } from './picture-blob.js';
import type { ViewerChildren } from './children.js';

export interface ViewerSnapshot {
  /** Null while the picture has no place on the page. */
  readonly snapshot: SceneSnapshot<PhongMesh | PhongViewer> | null;
  /** The picture's, in the CSS pixels that pointer events count in. */
  readonly width: number;
  readonly height: number;
  readonly lights: readonly {
    /** Null for the light at the eye that a viewer without any has. */
    readonly light: PhongLight | null;
    readonly name: string;
    readonly values: LightValues;
  }[];
}

/** `size` is the picture's, in CSS pixels before any transform or zoom. */
export function viewerSnapshot(
  viewer: PhongViewer,
  viewport: Viewport,
  children: Pick<ViewerChildren, 'elementOf' | 'lightOf'>,
  size: { readonly width: number; readonly height: number },
): ViewerSnapshot {
  const { holder } = viewport;
  // Inside CSS zoom pointer events count in the page's pixels, sizes in the element's own. Not all browsers know the name.
  const zoom = (holder as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
  return {
    snapshot:
      holder.getClientRects().length > 0
        ? viewport.snapshot((mesh) => children.elementOf(mesh) ?? viewer)
        : null,
    width: size.width * zoom,
    height: size.height * zoom,
    lights: viewport.lighting.lights.lights.map((state) => {
      const light = children.lightOf(state);
      return { light, name: light?.name ?? 'head-light', values: { ...state.values } };
    }),
  };
}

/** The picture in that size, by default the canvas's own; null where that is no size. */
export function pictureOf(viewport: Viewport, options: PictureOptions): HTMLCanvasElement | null {
  const width = options.width ?? Math.max(viewport.width, 1);
  const height = options.height ?? Math.max(viewport.height, 1);
  const isSize = [width, height].every((side) => Number.isInteger(side) && side >= 1);
  return isSize ? viewport.capture(width, height) : null;
}
