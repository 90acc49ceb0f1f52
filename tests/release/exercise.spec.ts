// Does <phong-exercise> find right functions right, and name mistakes, in Firefox and in WebKitGTK
// with software GL: with their compilers, their drivers and their way to read floats back?
import { expect, test } from '@playwright/test';
import { RIGHT_ONES, WRONG_ONES } from '../extras/exercise/functions.js';
import { strictPolicy } from '../support/site.js';
import { inEachBrowser, type Tab } from './tabs.js';

const markup = `<phong-viewer id="v" alt="A torus under three lamps" geometry="torus" shininess="20">
  <phong-light position="1 1 1" ambient="40" attenuation="1 0 0.5"></phong-light>
  <phong-light position="-2 1 1 0" diffuse="120 40 40"></phong-light>
  <phong-light position="1 2 2" axis="-1 -2 -2" aperture="20" cutoff="4"></phong-light></phong-viewer>
<phong-exercise for="v"></phong-exercise>`;

interface Check {
  readonly right: boolean;
  readonly mistakes: readonly string[];
}

/** What the verdict is, or why there is none. */
const checkOf = (tab: Tab, source: string) =>
  tab.run(async (text) => {
    await customElements.whenDefined('phong-exercise');
    const exercise = document.querySelector<HTMLElement & { value: string }>('phong-exercise')!;
    while ((exercise.shadowRoot?.querySelector('button') ?? null) === null) {
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    const root = exercise.shadowRoot!;
    exercise.value = text;
    const checked = new Promise<CustomEvent<Check>>((resolve) => {
      exercise.addEventListener('check', (event) => resolve(event as CustomEvent<Check>), {
        once: true,
      });
    });
    root.querySelector('button')!.click();
    const { right, mistakes } = (await checked).detail;
    await new Promise((resolve) => setTimeout(resolve));
    const isJudged = root.querySelector('.verdict strong') !== null;
    if (!isJudged) return root.querySelector('.editor')!.textContent + root.textContent;
    return right ? 'right' : mistakes.join(' + ');
  }, source);

inEachBrowser(900_000, (open) => {
  const openMarkup = () =>
    open(markup, {
      csp: strictPolicy,
      head: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
      css: 'phong-viewer { display: block; width: 150px; height: 100px }',
    });

  test('right functions are right, in every writing', async () => {
    const tab = await openMarkup();
    for (const [form, source] of Object.entries(RIGHT_ONES)) {
      expect.soft(await checkOf(tab, source), form).toBe('right');
    }
  });

  test('one function of each mistake is named', async () => {
    const tab = await openMarkup();
    for (const [ids, forms] of Object.entries(WRONG_ONES)) {
      const [[form, source] = ['', '']] = Object.entries(forms);
      expect.soft(await checkOf(tab, source), `${ids}, ${form}`).toBe(ids);
    }
  });
});
