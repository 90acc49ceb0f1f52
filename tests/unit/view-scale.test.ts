// Does every view have a legend's title?
import { expect, it } from 'vitest';
import { VIEWS } from '../../src/material/views.js';
import { viewTitle } from '../../src/overlay/legend/legend.js';

it('the legend has a title for every view', () => {
  for (const view of VIEWS) expect(viewTitle(view, false), view).not.toBe('');
  expect(viewTitle('r-dot-v', true)).toBe('N · H');
});
