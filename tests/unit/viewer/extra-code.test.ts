// What happens to a user of an extra whose row is missing from the table of extras?

import { afterEach, expect, it, vi } from 'vitest';
import { fasterCode } from '../../../src/phong/lazy-code.js';
import { extraCode, reportMissing } from '../../../src/viewer/model/provided-code.js';

afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

it('an extra without a row rejects, and is reported once', async () => {
  const warn = vi.spyOn(console, 'warn').mockReturnValue();
  const code = extraCode<string>('the probe');
  for (let use = 0; use < 3; use++) {
    await code().catch(reportMissing);
  }
  expect(warn.mock.calls).toEqual([
    ['<phong-viewer>: This copy of the package has no code of the probe.'],
  ]);
});

it('an extra with a row is fetched once for all uses, and again after a failure', async () => {
  const code = extraCode<string>('the probe');
  const load = vi.fn((failures: number) =>
    failures === 0 ? Promise.reject(new Error('offline')) : Promise.resolve('code'),
  );
  code.provide(load);
  await expect(code()).rejects.toThrow(/The code of the probe could not be fetched/);
  await expect(Promise.all([code(), code()])).resolves.toEqual(['code', 'code']);
  expect(load.mock.calls).toEqual([[0], [1]]);
});

it('code that is only faster is requested once, and half a minute after a failure', async () => {
  vi.useFakeTimers();
  const load = vi.fn().mockRejectedValueOnce(new Error('offline')).mockResolvedValue('code');
  const code = fasterCode(load);
  for (const seconds of [0, 29, 2, 0, 40]) {
    await vi.advanceTimersByTimeAsync(1000 * seconds);
    code();
  }
  expect(load).toHaveBeenCalledTimes(2);
  await vi.advanceTimersByTimeAsync(0);
  expect(code()).toBe('code');
});
