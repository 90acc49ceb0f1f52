// Is <phong-exercise> a part of a page like others: form, keyboard, screen reader, phone, paper,
// languages, strict policy, and what happens to a context that is lost?

import type { Page } from '@playwright/test';
import type { PhongExercise } from '../../../src/viewer/index.js';
import { accessibleNodes } from '../../a11y/tree.js';
import { axeOn } from '../../support/axe.js';
import { patch } from '../../support/gltf.js';
import { readyTexts } from '../../support/texts.js';
import { expect, strictPolicy, test } from '../../support/test.js';
import { RIGHT, WRONG_ONES } from './functions.js';

const css = 'phong-viewer { display: block; width: 150px; height: 100px }';
const lamp = `<phong-viewer id="v" alt="A torus under a lamp" geometry="torus">
  <phong-light position="1 1 1" ambient="40" attenuation="1 0 0.5"></phong-light></phong-viewer>`;
const exercise = (attributes: string, source: string) =>
  `<phong-exercise for="v" ${attributes}><script type="text/plain">\n${source}\n</script></phong-exercise>`;
const GLOWING = patch({ material: { emissiveFactor: [0.2, 0.1, 0] } });
const NO_CLAMP = WRONG_ONES['no-clamp']!['plain dot']!;

const textArea = (page: Page) => page.locator('phong-exercise').first().getByRole('textbox');
const verdict = (page: Page) => page.locator('[part=verdict]').first();

async function runFirst(page: Page) {
  await page.getByRole('button', { name: 'Run', exact: true }).first().click();
  await expect(verdict(page).locator('strong')).toBeVisible({ timeout: 30_000 });
}

test('nothing runs before run is pressed, and the text to begin with comes back', async ({
  mount,
  page,
}) => {
  await page.addInitScript(() => {
    let made = 0;
    const { createShader } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.createShader = function (type) {
      document.documentElement.dataset['shaders'] = String(++made);
      return createShader.call(this, type);
    };
    // Direct3D remarks on programs that are right. A learner's page does not repeat it.
    WebGL2RenderingContext.prototype.getProgramInfoLog = () => 'warning X3571: pow(f, e)';
  });
  await mount(lamp + exercise('', `  ${NO_CLAMP.replaceAll('\n', '\n  ')}`), { css });
  // Without the indentation of the markup.
  await expect(textArea(page)).toHaveValue(NO_CLAMP);
  const made = () => page.evaluate(() => document.documentElement.dataset['shaders']);
  const before = await made();
  await textArea(page).fill(RIGHT);
  await page.waitForTimeout(300);
  expect(await made()).toBe(before);
  await runFirst(page);
  await expect(verdict(page)).toContainText('Right: within one 8-bit step at all');
  await page.getByRole('button', { name: 'Start again' }).click();
  await expect(textArea(page)).toHaveValue(NO_CLAMP);
  // It was about another function.
  await expect(verdict(page)).toHaveText('');
  // A slip of the finger loses nothing.
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(textArea(page)).toHaveValue(RIGHT);
});

test('says what is right in this picture only, and shows it under another light', async ({
  mount,
  page,
}) => {
  const source = WRONG_ONES['attenuation-not-clamped']!['no max']!;
  await mount(lamp + exercise('', source), { css });
  await runFirst(page);
  await expect(verdict(page)).toContainText('Right in this picture, but not under other lights.');
  await expect(verdict(page)).toContainText('The attenuation may be above 1');
  await page.getByRole('button', { name: 'Bring the lamp close' }).click();
  await expect(verdict(page)).toContainText('Not right yet', { timeout: 30_000 });
  await expect(verdict(page)).toContainText(/Pixel \d+, \d+: yours/);
  // The button that was pressed is gone.
  await expect(page.getByRole('button', { name: 'Run' })).toBeFocused();
  await expect(page.getByRole('img', { name: 'The exact picture' })).toBeVisible();
  await textArea(page).fill('float x;');
  await page.getByRole('button', { name: 'Run' }).click();
  await expect(page.getByRole('alert')).toContainText('There is no function shade');
  await expect(page.getByRole('img', { name: 'The exact picture' })).toHaveCount(0);
});

test('hints say as much as they are asked to, a solution comes after a right answer, and phones and paper show all of it', async ({
  mount,
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 800 });
  const source = RIGHT.replace('m.ka * light.ambient', 'm.ka');
  await mount(lamp + exercise('hint="where" solution', source), { css });
  await runFirst(page);
  await expect(verdict(page)).toContainText('It differs in: Ambient term.');
  await expect(verdict(page)).not.toContainText('missing');
  const one = page.locator('phong-exercise');
  const hint = (much: string) =>
    one.evaluate((own, value) => own.setAttribute('hint', value), much);
  await hint('verdict');
  await expect(verdict(page)).toHaveText(/^\s*Not right yet\.\s*$/);
  await expect(one.getByText('The difference')).toHaveCount(0);
  await hint('none');
  await expect(verdict(page)).toHaveText('');
  await expect(one.getByText('The exact function')).toHaveCount(0);
  await hint('what');
  await textArea(page).fill(RIGHT);
  await runFirst(page);
  const solution = one.locator('details[open] pre');
  await expect(solution).toBeVisible();
  // The exact function is right itself.
  const exact = await solution.innerText();
  await textArea(page).fill(exact);
  await runFirst(page);
  await expect(verdict(page)).toContainText('Right: within one 8-bit step at all');
  for (const code of [solution, textArea(page)]) {
    const hidden = await code.evaluate(
      (box) => box.scrollWidth - box.clientWidth + box.scrollHeight - box.clientHeight,
    );
    expect(hidden).toBe(0);
  }
  await page.emulateMedia({ media: 'print' });
  await expect(page.locator('.printed')).toBeVisible();
  await expect(page.locator('.printed')).toHaveText(exact);
  await expect(page.getByRole('button', { name: 'Run' })).toBeHidden();
});

test('is a control of a form: value, required, reset, disabled', async ({ mount, page }) => {
  await mount(
    `${lamp}<form id="f"><fieldset>${exercise('name="phong" required', NO_CLAMP)}</fieldset></form>`,
    { css },
  );
  await expect(textArea(page)).toBeVisible();
  const form = page.locator('form');
  const valid = () => form.evaluate((f: HTMLFormElement) => f.checkValidity());
  const sent = () => form.evaluate((f: HTMLFormElement) => new FormData(f).get('phong'));
  expect(await valid()).toBe(false);
  await textArea(page).fill(RIGHT);
  expect(await valid()).toBe(true);
  expect(await sent()).toBe(RIGHT);
  await form.evaluate((f: HTMLFormElement) => f.reset());
  await expect(textArea(page)).toHaveValue(NO_CLAMP);
  expect(await valid()).toBe(false);
  await page.locator('fieldset').evaluate((f: HTMLFieldSetElement) => (f.disabled = true));
  await expect(textArea(page)).toBeDisabled();
});

test('what was written is there again when the page comes back', async ({ mount, page }) => {
  await mount(lamp + exercise('name="phong"', NO_CLAMP), { css });
  await textArea(page).fill(RIGHT);
  await page.goto('about:blank');
  await page.goBack();
  await expect(textArea(page)).toHaveValue(RIGHT);
  // Nothing written: the page's text, which may be another by then.
  await page.getByRole('button', { name: 'Start again' }).click();
  await page.goto('about:blank');
  await page.goBack();
  await expect(textArea(page)).toHaveValue(NO_CLAMP);
  const one = page.locator('phong-exercise');
  await one.evaluate((element) => element.setAttribute('required', ''));
  await expect(one).toHaveJSProperty('validationMessage', 'Write the function first.');
});

test('the picture has the light that a surface gives off, and says what Gouraud shading is', async ({
  mount,
  page,
}) => {
  await mount(
    `<phong-viewer id="v" alt="A shape that glows" shading="gouraud" src="${GLOWING}">
    <phong-light position="1 1 1" ambient="0" diffuse="0" specular="0"></phong-light></phong-viewer>${exercise('', RIGHT)}`,
    { css },
  );
  await runFirst(page);
  const shown = await page.locator('phong-exercise').evaluate((element) => {
    const canvas = element.shadowRoot!.querySelector<HTMLCanvasElement>('.own')!;
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    const colors = new Set<string>();
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] === 255) {
        colors.add(data.slice(i, i + 3).join(' '));
      }
    }
    return [...colors];
  });
  // 0.2, 0.1 and 0 in linear light.
  expect(shown).toEqual(['124 89 0']);
  await expect(page.getByText('The viewer shades at the corners of triangles')).toBeVisible();
});

test('several on a page, by keyboard, under a strict policy, in Portuguese, on a phone', async ({
  mount,
  page,
}) => {
  await page.setViewportSize({ width: 390, height: 800 });
  const texts = JSON.stringify(readyTexts('pt'));
  await mount(
    `<main><h1>Luz</h1><script type="application/json" data-phong-viewer-texts>${texts}</script>
    ${lamp}${exercise('', NO_CLAMP)}${exercise('terms="diffuse" kinds="point"', NO_CLAMP)}</main>`,
    { css, csp: strictPolicy, nameless: true },
  );
  const boxes = page.getByRole('textbox', { name: 'Sua função' });
  await expect(boxes).toHaveCount(2);
  // A screen reader tells exercises apart by their viewers.
  await page.locator('phong-viewer').evaluate((viewer) => viewer.setAttribute('alt', 'Um toro'));
  const named = async () =>
    (await accessibleNodes(page)).filter(({ role, name }) => role === 'group' && name === 'Um toro')
      .length;
  await expect.poll(named).toBe(2);
  await boxes.first().focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.press('Control+Enter');
  await expect(verdict(page)).toContainText('N·L não é limitado a 0', { timeout: 30_000 });
  // The tab key leaves the text.
  await page.keyboard.press('Tab');
  await expect(page.getByRole('button', { name: 'Executar' }).first()).toBeFocused();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    expect((await axeOn(page).analyze()).violations).toEqual([]);
  }
  // Without its viewer it still has the page's language.
  await page.locator('phong-viewer').evaluate((viewer) => (viewer.id = 'w'));
  await page.getByRole('button', { name: 'Executar' }).first().click();
  await expect(page.getByRole('alert').first()).toContainText('Não há nenhum phong-viewer com');
  // It leaves a viewer that comes second to another one.
  await page.locator('phong-viewer').evaluate(
    (viewer) =>
      new Promise<void>((resolve) => {
        Object.assign(viewer, { removeController: () => resolve() });
        viewer.before(viewer.cloneNode());
      }),
  );
});

test('a lost context and an exponent that is too high are said, and the next run is a new one', async ({
  mount,
  page,
}) => {
  // Once, at the call that the page names, in the exercise's own context.
  await page.addInitScript(() => {
    const calls = WebGL2RenderingContext.prototype as unknown as Record<string, () => unknown>;
    for (const name of ['createTexture', 'createShader', 'linkProgram', 'readPixels']) {
      const call = calls[name]!;
      calls[name] = function (this: WebGL2RenderingContext, ...given) {
        const { dataset } = document.documentElement;
        if (dataset['lose'] === name) {
          delete dataset['lose'];
          this.getExtension('WEBGL_lose_context')!.loseContext();
        }
        return call.apply(this, given);
      };
    }
  });
  await mount(lamp + exercise('', RIGHT), { css });
  await expect(textArea(page)).toBeVisible();
  for (const name of ['createTexture', 'createShader', 'linkProgram', 'readPixels']) {
    await page.evaluate((call) => (document.documentElement.dataset['lose'] = call), name);
    await page.getByRole('button', { name: 'Run' }).click();
    await expect(page.getByRole('alert'), name).toContainText('The graphics driver has stopped.');
    await runFirst(page);
    await expect(verdict(page), name).toContainText('Right: within one 8-bit step at all');
  }
  await page.locator('phong-viewer').evaluate((viewer) => viewer.setAttribute('shininess', '300'));
  await page.getByRole('button', { name: 'Run' }).click();
  await expect(page.getByRole('alert')).toContainText('The exponent is 300 in this picture');
});

test('a run stops where the function changes or the exercise leaves, and the next one counts', async ({
  mount,
  page,
}) => {
  await mount(lamp + exercise('', NO_CLAMP), { css });
  await expect(textArea(page)).toBeVisible();
  const found = await page.locator('phong-exercise').evaluate(async (element, right) => {
    const own = element as PhongExercise;
    const button = own.shadowRoot!.querySelector('button')!;
    const mistakes: string[] = [];
    own.addEventListener('check', ({ detail }) => mistakes.push(detail.mistakes.join()));
    const checked = () =>
      new Promise((resolve) => own.addEventListener('check', resolve, { once: true }));
    button.click();
    own.value = right;
    const first = checked();
    button.click();
    await first;
    button.click();
    const { parentNode } = own;
    own.remove();
    await new Promise((resolve) => setTimeout(resolve));
    parentNode!.append(own);
    await new Promise((resolve) => setTimeout(resolve));
    const isFree = button.getAttribute('aria-disabled') === 'false';
    const second = checked();
    button.click();
    await second;
    return { mistakes, isFree };
  }, RIGHT);
  expect(found).toEqual({ mistakes: ['', ''], isFree: true });
});

test('a run waits while its page is hidden, where each timer would look like slow drawing', async ({
  mount,
  page,
}) => {
  await mount(lamp + exercise('', RIGHT), { css });
  await expect(textArea(page)).toBeVisible();
  const draws = await page.locator('phong-exercise').evaluate(async (element) => {
    const { prototype } = WebGL2RenderingContext;
    const { drawArrays } = prototype;
    let drawn = 0;
    let isHidden = true;
    Object.defineProperty(document, 'hidden', { configurable: true, get: () => isHidden });
    prototype.drawArrays = function (...given) {
      drawn++;
      drawArrays.apply(this, given);
    };
    const waiting = new Promise<void>((resolve) => {
      const listen = document.addEventListener;
      document.addEventListener = (...given: Parameters<typeof listen>) => {
        listen.apply(document, given);
        if (given[0] === 'visibilitychange') {
          resolve();
        }
      };
    });
    const checked = new Promise((resolve) =>
      element.addEventListener('check', resolve, { once: true }),
    );
    element.shadowRoot!.querySelector('button')!.click();
    await waiting;
    await new Promise((resolve) => setTimeout(resolve));
    const before = drawn;
    isHidden = false;
    document.dispatchEvent(new Event('visibilitychange'));
    await checked;
    prototype.drawArrays = drawArrays;
    Reflect.deleteProperty(document, 'addEventListener');
    return { before, after: drawn > 0 };
  });
  expect(draws).toEqual({ before: 0, after: true });
});
