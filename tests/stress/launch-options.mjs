// @ts-check
// How a tool's Chromium is started: the named program with the named arguments, or this machine's own with software GL.

/**
 * What is not named is looked up in .ci/, which a machine without the repository has not.
 * @param {string} browser
 * @param {string[]} args
 */
export async function launchOptions(browser, args) {
  if (browser !== '' && args.length > 0) {
    return { executablePath: browser, args: ['--no-sandbox', '--disable-background-networking', ...args] };
  }
  const { ensureBrowser, softwareGl } = await import('../../.ci/browser.mjs');
  const own = args.length > 0 ? ['--no-sandbox', '--disable-background-networking', ...args] : softwareGl;
  return { executablePath: browser === '' ? await ensureBrowser() : browser, args: own };
}
