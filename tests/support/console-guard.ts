// No stray line: everything that pages say on the console, every uncaught error and every report of
// the Content-Security-Policy fails the test, unless the test has claimed it beforehand; so does a
// claim that nothing met.

import type { BrowserContext } from '@playwright/test';

interface Claim {
  readonly pattern: RegExp;
  readonly times: number | 'any' | undefined;
  readonly met: string[];
}

// Remarks that depend on the machine's pace, not on the page: the graphics driver's about reading
// pixels back, and the browser's about its own work in what it skips (that the package asks for
// none of it is counted: `layouts` of ../element/support/counting.ts), and about a chunk that is
// requested ahead and comes seconds before the one that imports it. The package's own about a
// viewer without a name, and of values that look like those of another unit: most tests make theirs
// by script and are about other things. Tests of these warnings claim them.
const remark =
  /GL Driver Message \(OpenGL, Performance|^verbose: Rendering was performed in a subtree hidden|^warning: The resource \S+\/chunks\/\S+ was preloaded using link preload but not used within|^warning: A <phong-viewer> has no alt|^warning: <phong-[^>]*> is (nearly black|a cone narrower)/;

/** Whether a message such as `warning: …` needs no claim. */
export const isRemark = (text: string): boolean => remark.test(text);

export class ConsoleGuard {
  readonly #claims: Claim[] = [];
  readonly #strays: string[] = [];

  /** Watches all pages of the context from now on. */
  async watch(context: BrowserContext): Promise<void> {
    context.on('console', (message) => this.#hear(`${message.type()}: ${message.text()}`));
    context.on('weberror', (error) => this.#hear(`uncaught: ${String(error.error())}`));
    context.on('page', (page) => page.on('crash', () => this.#hear('crash: the page is gone')));
    await context.addInitScript(() => {
      addEventListener('securitypolicyviolation', (event) =>
        console.error(`CSP report: ${event.effectiveDirective} refused ${event.blockedURI}`),
      );
    });
  }

  /**
   * Claims the messages that match, among them `warning: …`, `error: …`, `log: …`, `uncaught: …`.
   * @param times how many there must be; default: at least one; 'any': none, too.
   * @returns the messages as they come.
   */
  allow(pattern: RegExp, times?: number | 'any'): readonly string[] {
    const met: string[] = [];
    this.#claims.push({ pattern, times, met });
    return met;
  }

  /** Throws if a message has no claim, or a claim was not met as often as stated. */
  check(): void {
    const faults = this.#strays.map((text) => `unexpected on the console: ${text}`);
    for (const { pattern, times, met } of this.#claims) {
      if (times === 'any' || (times === undefined ? met.length > 0 : met.length === times))
        continue;
      faults.push(`${String(pattern)} was met ${met.length} times, not ${times ?? 'once or more'}`);
    }
    if (faults.length > 0) throw new Error(faults.join('\n'));
  }

  #hear(text: string) {
    const claim = this.#claims.find(({ pattern }) => pattern.test(text));
    if (claim !== undefined) {
      claim.met.push(text);
    } else if (!isRemark(text)) {
      this.#strays.push(text);
    }
  }
}
