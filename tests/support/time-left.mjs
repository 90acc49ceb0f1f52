// @ts-check
// A Playwright reporter that says, every 15 s, how many tests have ended and about how much time is
// left.

import { Progress } from './command-line.mjs';

export default class TimeLeft {
  #progress = new Progress({ oneLine: false });
  #total = 0;
  #ended = 0;

  /**
   * @param {import('@playwright/test/reporter').FullConfig} _config @param
   * {import('@playwright/test/reporter').Suite} suite
   */
  onBegin(_config, suite) {
    this.#total = suite.allTests().length;
  }

  onTestEnd() {
    this.#ended += 1;
    this.#progress.show(this.#ended, this.#total, `${this.#ended} of ${this.#total} browser tests`);
  }
}
