// The long form of the contract: more cases, all lights of the long programs at once, and drivers that err one way alone.
import { testContract } from '../glsl/contract-run.js';

testContract({ driver: 'shipped', cases: 1e6, checks: 16384, everyLight: 1 }, '@release ');
for (const driver of ['up', 'down', 'either'] as const)
  testContract({ driver, cases: 2e5, checks: 16384, everyLight: 1 }, '@release ');
