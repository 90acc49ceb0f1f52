// @ts-check
// A Playwright reporter that says, every 15 s, how many tests have ended and how much time is left. How long each test
// took last time is kept in node_modules/.cache: the longest tenth of the tests takes two fifths of the time.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Progress } from './command-line.mjs';

const file = fileURLToPath(new URL('../../node_modules/.cache/phong-viewer/test-ms.json', import.meta.url));

/** @typedef {import('@playwright/test/reporter').TestCase} TestCase */

/** @param {TestCase} test */
const nameOf = (test) => test.titlePath().join(' › ');

export default class TimeLeft {
  #progress = new Progress({ oneLine: false });
  /** Milliseconds of each test in its last run. @type {Record<string, number>} */
  #known = existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
  /**
   * Expected milliseconds of each test of this run: a new test counts as an average one.
   * @type {Map<string, number>}
   */
  #expected = new Map();
  #total = 0;
  #done = 0;
  #ended = 0;

  /**
   * @param {import('@playwright/test/reporter').FullConfig} _config
   * @param {import('@playwright/test/reporter').Suite} suite
   */
  onBegin(_config, suite) {
    const names = suite.allTests().map(nameOf);
    const known = names.flatMap((name) => this.#known[name] ?? []);
    const average = known.length === 0 ? 1 : Math.round(known.reduce((a, b) => a + b, 0) / known.length);
    for (const name of names) this.#expected.set(name, this.#known[name] ?? average);
    for (const ms of this.#expected.values()) this.#total += ms;
  }

  /** @param {TestCase} test @param {import('@playwright/test/reporter').TestResult} result */
  onTestEnd(test, { status, duration }) {
    const name = nameOf(test);
    this.#ended += 1;
    this.#done += this.#expected.get(name) ?? 0;
    if (status === 'passed') this.#known[name] = Math.round(duration);
    const tests = `${this.#ended} of ${this.#expected.size} browser tests`;
    this.#progress.show(this.#done, this.#total, tests);
  }

  onEnd() {
    mkdirSync(dirname(file), { recursive: true });
    writeFileSync(file, JSON.stringify(this.#known));
  }
}
