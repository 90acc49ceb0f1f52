// Does every view have a legend's title, and its function in the GLSL?
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { viewEntry, viewValue } from '../../src/material/view/view-table.js';
import { VIEWS } from '../../src/material/views.js';
import { viewTitle } from '../../src/overlay/legend/view-scale.js';

describe('the legend', () => {
  it('has a title for every view', () => {
    for (const view of VIEWS) expect(viewTitle(view, false), view).not.toBe('');
    expect(viewTitle('r-dot-v', true)).toBe('N · H');
  });
});

it('every view of a quantity calls a function of view_quantity.glsl', () => {
  const glsl = readFileSync('shaders/view_quantity.glsl', 'utf8');
  for (const view of VIEWS) {
    if (viewEntry(view).shows.by !== 'quantity') continue;
    const [call] = /view\w+/.exec(viewValue(view))!;
    expect(glsl, view).toMatch(new RegExp(`(vec3|float) ${call}\\(Viewed at\\)`));
  }
});
