// Does the shipped GLSL with the shipped packing keep the numerical contract, on this browser's driver and on the worst
// lawful one? tests/release runs twenty times as many cases, `npm run stress` two thousand times as many.
import { testContract } from './contract-run.js';

testContract({ driver: 'shipped', cases: 5e4, checks: 4096, everyLight: 1 });
testContract({ driver: 'either', cases: 2e4, checks: 4096, everyLight: 4 });
