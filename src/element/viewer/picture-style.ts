// Which of the viewer's values change how the picture is drawn as a whole? Passes them to the viewport. Knows neither meshes nor lights.
import type { Viewport } from '../../scene/viewport.js';
import type { ViewerValues } from '../fields/viewer-fields.js';

const STYLE_KEYS = ['shading', 'reflection', 'terms', 'antialias'] as const;

/** `changed`: the values that were written. */
export function applyStyle(
  viewport: Pick<Viewport, 'fov' | 'linear' | 'style'>,
  { fov, colorInterpolation, shading, reflection, terms, antialias }: Readonly<ViewerValues>,
  changed: { has(key: string): boolean },
): void {
  viewport.fov = fov;
  viewport.linear = colorInterpolation === 'linear';
  if (STYLE_KEYS.some((key) => changed.has(key))) viewport.style = { shading, reflection, terms, antialias };
}
