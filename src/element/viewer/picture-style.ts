// Passes the values that change the picture as a whole to the viewport.
import type { Viewport } from '../../scene/viewport.js';
import type { ViewerValues } from '../fields/viewer-fields.js';

const STYLE_KEYS = ['shading', 'reflection', 'terms', 'antialias'] as const;

/** `changed`: the values that were written. */
export function applyStyle(
  viewport: Pick<Viewport, 'fov' | 'linear' | 'style' | 'samples'>,
  { fov, colorInterpolation, shading, reflection, terms, antialias, samples }: Readonly<ViewerValues>,
  changed: { has(key: string): boolean },
): void {
  viewport.fov = fov;
  viewport.linear = colorInterpolation === 'linear';
  viewport.samples = antialias === 'full' ? samples : 0;
  if (STYLE_KEYS.some((key) => changed.has(key))) viewport.style = { shading, reflection, terms, antialias };
}
