// Are the numbers of a text read exactly as `Number` reads them?
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { TextScanner } from '../../../src/extras/models/text/text-scanner.js';

const digits = fc.stringMatching(/^[1-9]\d{0,18}\.?\d{0,8}(e-?\d\d?)?$/);
const double = fc.double({ noNaN: true, noDefaultInfinity: true }).map(String);

it('reads a number as `Number` does, with few digits and with too many', () => {
  fc.assert(
    fc.property(fc.oneof(digits, double), (text) => {
      const scanner = new TextScanner(new TextEncoder().encode(`${text} #`));
      expect(scanner.number()).toBe(Number(text));
    }),
    { numRuns: 3000, examples: [['9007199254740993'], ['9007199254740992e22']] },
  );
});
