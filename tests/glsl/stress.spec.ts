// Does the shipped GLSL with the shipped packing keep the numerical contract, on this browser's
// driver and on the worst lawful one? tests/release runs forty times as many cases or more, `npm
// run stress` eight thousand times as many.
import { testContract } from './contract-run.js';

testContract({ driver: 'shipped', cases: 1.25e4, checks: 4096, everyLight: 1 });
testContract({ driver: 'either', cases: 5e3, checks: 4096, everyLight: 4 });
