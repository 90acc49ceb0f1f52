// The long form of glsl/stress.spec.ts: more cases, all lights of the long programs at once, and drivers that err in
// one direction only.
import { testContract } from '../glsl/contract-run.js';

testContract({ driver: 'shipped', cases: 1e6, checks: 16384, everyLight: 1 }, '@release ');
for (const driver of ['up', 'down', 'either'] as const)
  testContract({ driver, cases: 2e5, checks: 16384, everyLight: 1 }, '@release ');
