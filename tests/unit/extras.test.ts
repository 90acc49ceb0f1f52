// Can an extra be taken out? Two of them, by types.

import { describe, expect, it } from 'vitest';
import { tableWithout, typeErrors, withDependents } from '../support/without-extra.js';

describe('an extra', () => {
  it('goes with those that depend on it', () => {
    expect([...withDependents('explain')].sort()).toEqual(['explain', 'overlay']);
    expect([...withDependents('panel')]).toEqual(['panel']);
  });

  it('goes from the table with its rows and what only they import', () => {
    const left = tableWithout(new Set(['overlay', 'panel']));
    expect(left).not.toMatch(/panel|overlay/i);
    expect(left).toContain("'../extras/compare/camera-group.js'");
  });

  it.each(['panel', 'explain'])(
    '%s is not needed by what is left',
    { timeout: 120_000 },
    (name) => {
      expect(typeErrors(withDependents(name))).toEqual([]);
    },
  );
});
