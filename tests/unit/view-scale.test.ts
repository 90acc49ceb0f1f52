// Does every view have a legend's title?
import { describe, expect, it } from 'vitest';
import { VIEWS } from '../../src/material/views.js';
import { titleOf } from '../../src/overlay/legend/view-scale.js';

describe('the legend', () => {
  it('has a title for every view', () => {
    for (const view of VIEWS) expect(titleOf(view, false), view).not.toBe('');
    expect(titleOf('r-dot-v', true)).toBe('N · H');
  });
});
