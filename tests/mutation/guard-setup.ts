// Puts one guard's wrong functions in place before the test file is loaded. Which one: PHONG_VIEWER_GUARD, its index.

import { vi } from 'vitest';
import { GUARDS } from './guards.js';

const guard = GUARDS[Number(process.env['PHONG_VIEWER_GUARD'])]!;
vi.doMock(`../../${guard.module}`, async (importOriginal) => {
  const real = await importOriginal<never>();
  return { ...(real as object), ...guard.wrong(real) };
});
