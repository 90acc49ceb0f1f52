// The colours of a screenshot, and their contrast as WCAG 2.2 defines it.

import type { Locator } from '@playwright/test';
import { decodePng, pixelAt } from '../support/picture.js';

/** Codes 0–255; of a screenshot with alpha. */
export type Rgb = readonly [number, number, number, ...number[]];

function luminance(color: Rgb) {
  const [r, g, b] = color.map((code) => {
    const c = code / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
}

/** The ratio of two colours' luminances, at least 1. */
export function contrast(a: Rgb, b: Rgb): number {
  const [dark, light] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (light! + 0.05) / (dark! + 0.05);
}

/** Takes a screenshot. Returns the colour at a pixel, rounded to whole ones. */
export async function screenshot(of: Locator): Promise<(x: number, y: number) => Rgb> {
  const picture = decodePng(await of.screenshot());
  return (x, y) => pixelAt(picture, Math.round(x), Math.round(y));
}
