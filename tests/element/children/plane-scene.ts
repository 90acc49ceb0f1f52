// A small picture of a plane under a few lights, and its comparison with the picture of other markup. For tests of
// children.

import type { Page } from '@playwright/test';
import { compare, expect, type Picture } from '../../support/test.js';
import { shownBy } from '../support/viewer.js';

export const size = { width: 60, height: 40 };
export const red = '<phong-light name="red" diffuse="200 0 0" specular="0" position="1 1 0 0"></phong-light>';
export const green =
  '<phong-light name="green" diffuse="0 120 0" position="-0.3 0.5 0.2 1" ambient="0 9 0"></phong-light>';

export const open = '<phong-viewer geometry="plane" theta="0" phi="40" radius="1.2" target="0 0 0">';
export const scene = (...children: readonly string[]): string => `${open}${children.join('')}</phong-viewer>`;

/** The picture of this markup in a second viewer. */
export const shown = (page: Page, markup: string): Promise<Picture> => shownBy(page, markup, size);
export const same = (a: Picture, b: Picture): void => expect(compare(a, b).max).toBe(0);
export const different = (a: Picture, b: Picture): void => expect(compare(a, b).max).toBeGreaterThan(20);
