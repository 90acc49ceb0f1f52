// Does a <phong-probe> show a point of its viewer, judge answers, and act as a control of forms?

import type { Locator, Page } from '@playwright/test';
import type { PhongProbe } from '../../../src/viewer/index.js';
import { assign, Fingers, record } from '../../element/support/viewer.js';
import { expect, type Mount, test } from '../../support/test.js';

/** A floor below a lamp at 60 degrees, 2 away, seen from above. */
const scene = (attributes = '') =>
  `<phong-viewer id="v" alt="A floor" geometry="plane" theta="0" phi="30" radius="4" target="0 0 0" ka="255" kd="200" ks="255" ${attributes}>
     <phong-light id="lamp" name="lamp" position="1.7320508 1 0 1" ambient="51" diffuse="204" specular="128" attenuation="1 0 0.75"></phong-light></phong-viewer>`;

const probe = (attributes: string) => `<phong-probe for="v" ${attributes}></phong-probe>`;
const size = { width: 300, height: 200 };

/** The line of this title. */
const line = (within: Page | Locator, title: string) =>
  within.getByRole('listitem').filter({ hasText: title });

/** The texts of a line's formulas: symbols, numbers, result. */
const formulas = (of: Locator) =>
  of
    .locator('math')
    .allTextContents()
    .then((texts) => texts.join(''));

test('shows the table, the equation or questions of the declared point, as `as` says', async ({
  page,
  mount,
}) => {
  // The sum is the brightest in red, in which the diffuse term is none.
  await mount(scene().replace(/51(.*)204/, 'maroon$1blue') + probe('at="0 0 0"'), size);
  const element = page.locator('phong-probe');
  await expect(element.getByRole('row').filter({ hasText: 'lamp' })).toContainText('0.25');
  await assign(element, { as: 'formula' });
  const diffuse = line(page, 'lamp · diffuse');
  await expect(diffuse).toBeVisible();
  expect(await formulas(diffuse)).toBe('Kd·Id·att·max(N·L,0)=0.78·(001)·0.25·0.50=(000.10)');
  await expect(element.getByRole('table')).toHaveCount(0);
  await assign(element, { as: 'ask' });
  await expect(element.getByRole('textbox')).toHaveCount(3);
  await expect(element).not.toContainText('0.10');
  await assign(page.locator('phong-light'), { ambient: '#811' });
  await expect(element.getByRole('textbox', { name: 'blue' })).toHaveCount(3);
  await assign(element, { as: null, ask: 'diffuse lamp' });
  await expect(element.getByRole('textbox')).toHaveAccessibleName('lamp · diffuse · blue');
  await assign(element, { ask: 'sum' });
  await expect(element.getByRole('textbox', { name: 'sum' })).toBeVisible();
  await expect(element.getByRole('listitem')).toHaveCount(4);
  const viewer = page.locator('phong-viewer');
  await assign(viewer, { colorInterpolation: 'linear' });
  expect(await formulas(line(page, 'sum'))).toBe('sRGB(Σ)=');
  await assign(viewer, { shading: 'gouraud' });
  await expect(element.getByRole('table'), 'corners have no equation here').toBeVisible();
});

test('looks the same on a page without a doctype', async ({ page, mount }) => {
  await mount(
    `<main>${scene('probe probe-at="0 0 0"')}${probe('as="ask"')}</main><iframe></iframe>`,
  );
  await page.evaluate(() => {
    const { body } = document.querySelector('iframe')!.contentDocument!;
    body.append(document.querySelector('main')!);
  });
  const inner = page.frameLocator('iframe');
  await expect(inner.locator('form').first()).toHaveCSS('margin-bottom', '0px');
  await expect(inner.locator('table')).toHaveCSS('color', 'rgb(236, 236, 241)');
});

/** A viewer with two probes: the formula that one shows, and the facts of the other's question. */
async function mountTwo(page: Page, mount: Mount) {
  const viewer = await mount(scene() + probe('as="formula"') + probe('as="ask"'), size);
  const [formula, ask] = [0, 1].map((i) =>
    line(page.locator('phong-probe').nth(i), 'lamp · diffuse'),
  );
  const facts = ask!.locator('.facts');
  await expect(facts).toBeVisible();
  return { viewer, shown: () => formulas(formula!), facts, asked: (await facts.textContent())! };
}

test('follows the mouse, a finger and a pin, questions the pin alone, and Escape takes it away', async ({
  page,
  mount,
}) => {
  const { viewer, shown, facts, asked } = await mountTwo(page, mount);
  const first = await shown();
  await page.mouse.move(165, 100);
  await expect.poll(shown).not.toBe(first);
  expect(await facts.textContent()).toBe(asked);
  await page.mouse.click(160, 92);
  await expect(facts).not.toHaveText(asked);
  const pinned = await shown();
  await page.mouse.move(140, 105);
  await page.mouse.move(141, 105);
  expect(await shown()).toBe(pinned);
  await viewer.press('Escape');
  await page.mouse.move(135, 106);
  await expect.poll(shown).not.toBe(pinned);
  await assign(viewer, { probe: true, probeAt: [0.1, 0, 0.1] });
  await page.mouse.move(500, 500);
  await expect(facts).not.toHaveText(asked);
  const before = (await facts.textContent())!;
  const fingers = await Fingers.on(page);
  await fingers.down([165, 100]);
  await fingers.up();
  await expect(facts).not.toHaveText(before);
});

test('the arrow keys move its ring over the surface, for all probes of the viewer, and Escape lets go', async ({
  page,
  mount,
}) => {
  const { viewer, shown, facts, asked } = await mountTwo(page, mount);
  const first = await shown();
  const ring = viewer.getByRole('application', { name: 'Probe' });
  await expect(ring.and(page.locator('[tabindex="0"]')), 'one stop for both').toHaveCount(1);
  await ring.first().focus();
  await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(shown).not.toBe(first);
  await expect(facts).not.toHaveText(asked);
  const right = await shown();
  await page.keyboard.press('Shift+ArrowLeft');
  await expect.poll(shown).toBe(first);
  for (let i = 0; i < 10; i++) {
    await page.keyboard.press('ArrowRight');
  }
  await expect.poll(shown).toBe(right);
  await page.mouse.move(140, 105);
  await page.mouse.move(141, 105);
  expect(await shown()).toBe(right);
  await page.keyboard.press('Escape');
  await page.mouse.move(135, 106);
  await expect.poll(shown).not.toBe(right);
});

test('has its answers again after a way back to the page', async ({ page, mount }) => {
  await mount(`${scene()}<form>${probe('at="0 0 0" as="ask" name="q"')}</form>`, size);
  const fields = page.getByRole('textbox');
  await fields.nth(1).fill('0,078');
  await page.goto('about:blank');
  await page.goBack();
  await expect(fields.nth(1)).toHaveValue('0,078');
  await expect(fields.first()).toHaveValue('');
});

test('judges by keyboard, marks right and wrong by more than words, and keeps the focus', async ({
  page,
  mount,
}) => {
  await mount(scene() + probe('at="0 0 0" ask="diffuse"'), size);
  const field = page.getByRole('textbox', { name: 'lamp · diffuse' });
  const verdict = page.getByRole('status');
  const answers = await record(page.locator('phong-probe'), 'answer');
  await page.evaluate(() =>
    document.addEventListener('keydown', ({ key }) => (document.body.title += key)),
  );
  const mark = () => verdict.evaluate((output) => getComputedStyle(output, '::before').content[1]!);
  await field.fill('0.314');
  await field.press('Enter');
  await expect(verdict).toHaveText('That is the value without att.');
  expect(await mark()).toBe('✗');
  await expect(field).toBeFocused();
  await field.fill('0,0784');
  await field.press('Enter');
  await expect(verdict).toHaveText('Right.');
  expect(await mark()).toBe('✓');
  const same = {
    term: 'diffuse',
    light: '<phong-light>',
    channel: null,
    expected: expect.closeTo(0.0784, 3) as unknown,
  };
  expect((await answers.take()).map(({ detail }) => detail)).toEqual([
    { ...same, text: '0.314', value: 0.314, correct: false, mistake: 'without-att' },
    { ...same, text: '0,0784', value: 0.0784, correct: true, mistake: null },
  ]);
  expect(await page.evaluate(() => document.body.title), 'shortcuts of the page').toBe('');
  const show = page.getByRole('button', { name: 'Show' });
  await show.click();
  await expect(show).toBeFocused();
  await expect(line(page, 'lamp · diffuse')).toContainText('=0.078');
});

test('is a control of its form: name, value, reset, validity, FormData, and sends nothing itself', async ({
  page,
  mount,
}) => {
  await mount(
    `${scene()}<form>${probe('at="0 0 0" as="ask" name="q" required')}<button>Send</button></form>`,
    size,
  );
  const form = page.locator('body > form');
  await form.evaluate((own: HTMLFormElement) =>
    own.addEventListener('submit', (event) => {
      event.preventDefault();
      Reflect.set(window, 'sent', [...new FormData(own)]);
    }),
  );
  const element = page.locator('phong-probe');
  const fields = element.getByRole('textbox');
  await expect(fields).toHaveCount(4);
  const read = () =>
    element.evaluate((one: PhongProbe) => [
      one.value,
      one.checkValidity(),
      one.validity.valueMissing,
      [...new FormData(one.form!)].map(([key, value]) => `${key}=${value as string}`).join('&'),
    ]);
  const sent = () => page.evaluate(() => Reflect.get(window, 'sent') as unknown);
  expect(await read()).toEqual(['; ; ; ', false, true, 'q=&q=&q=&q=']);
  for (const i of [0, 1, 2, 3]) {
    await fields.nth(i).fill(`0; ${i}`);
    await fields.nth(i).press('Enter');
  }
  expect(await sent(), 'Enter in a field checks it').toBeUndefined();
  expect(await read(), 'wrong answers are valid').toEqual([
    '0;0; 0;1; 0;2; 0;3',
    true,
    false,
    'q=0; 0&q=0; 1&q=0; 2&q=0; 3',
  ]);
  await page.getByRole('button', { name: 'Send' }).click();
  expect(await sent()).toEqual([0, 1, 2, 3].map((i) => ['q', `0; ${i}`]));
  await form.evaluate((own: HTMLFormElement) => own.reset());
  await expect(fields.first()).toHaveValue('');
  await expect(element.getByRole('status').first()).toHaveText('');
  await assign(element, { value: '1; 2', required: false });
  await expect(fields.nth(1)).toHaveValue('2');
  expect(await read()).toEqual(['1; 2; ; ', true, false, 'q=1&q=2&q=&q=']);
  await form.evaluate((own) => own.firstElementChild!.toggleAttribute('disabled', true));
  await expect(fields.first()).toBeDisabled();
});

test('`seed` is another point and other numbers for each text, the same for the same', async ({
  page,
  mount,
}) => {
  const seeds = ['Maria', 'Maria', 'João'];
  const probes = seeds.map((seed) => probe(`ask="specular lamp" seed="${seed}"`)).join('');
  await mount(scene('segments="8"') + probes, size);
  const lines = page.locator('phong-probe').getByRole('listitem');
  await expect(lines).toHaveCount(3);
  const [first, again, other] = await lines.allTextContents();
  expect(again).toBe(first);
  expect(other).not.toBe(first);
  const rings = page.locator('phong-viewer .pointed:not([hidden])');
  await expect(rings).toHaveCount(3);
  await page.locator('phong-probe').nth(1).getByRole('textbox').focus();
  await expect(page.locator('phong-viewer [data-strong]')).toHaveCount(1);
});

test('says in one warning which viewer or light is missing, and takes one that comes later', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const missing = consoleGuard.allow(
    /<phong-probe for="w">: no viewer has the id "w". Did you mean "v"\?/,
  );
  consoleGuard.allow(/<phong-probe ask="diffuse sun">: no light of the viewer adds such a term/);
  consoleGuard.allow(/probe="ask": expected true or false; <phong-probe for="id" as="formula">/);
  await mount(
    `${scene('probe="ask"')}${probe('at="0 0 0" ask="diffuse sun"')}<phong-probe for="w" at="0 0 0"></phong-probe>`,
    size,
  );
  await expect(page.getByRole('textbox')).toHaveCount(4);
  const late = page.locator('[for=w]');
  await expect(late.getByRole('table')).toHaveCount(0);
  await expect.poll(() => missing.length).toBe(1);
  await page.locator('phong-viewer').evaluate((viewer) => (viewer.id = 'w'));
  await expect(late.getByRole('table')).toBeVisible();
});

test('a copy that has no clipboard says so, and shows the text selected', async ({
  page,
  mount,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await mount(scene() + probe('as="formula" at="0 0 0"'), size);
  const element = page.locator('phong-probe');
  const [text, latex] = [0, 1].map((i) => element.locator('p button').nth(i));
  await expect(page.getByRole('textbox')).toHaveCount(0);
  await page.evaluate(() =>
    Object.defineProperty(navigator, 'clipboard', { value: undefined, configurable: true }),
  );
  await latex!.click();
  await expect(latex!).toHaveText('select and copy below');
  const field = page.getByRole('textbox', { name: 'Copy as LaTeX' });
  await expect(field).toBeFocused();
  const selected = await field.evaluate((area: HTMLTextAreaElement) =>
    area.value.slice(area.selectionStart, area.selectionEnd),
  );
  expect(selected).toContain('\\cdot');
  await expect(latex!).toHaveText('Copy as LaTeX');
  await page.evaluate(() => Reflect.deleteProperty(navigator, 'clipboard'));
  await text!.click();
  await expect(text!).toHaveText('copied ✓');
  await expect(field).toHaveCount(0);
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain('·');
});

test('has the numbers of the language around it, and English words in an English part', async ({
  page,
  mount,
}) => {
  const part = (lang: string) =>
    `<section lang="${lang}">${probe('as="formula" at="0 0 0"')}</section>`;
  await mount(scene() + part('de') + part('fa') + part('en'), {
    ...size,
    head: `<script type="application/json" data-phong-viewer-texts>{"en":"de","diffuse":"diffus"}</script>`,
  });
  const [german, persian, english] = [0, 1, 2].map((i) =>
    page.locator('phong-probe').nth(i).getByRole('listitem').nth(1),
  );
  await expect(german!).toContainText(/lamp · diffus\b[^]*0,078/);
  await expect(persian!).toContainText('۰٫۰۷۸');
  await expect(english!).toContainText(/lamp · diffuse[^]*0\.078/);
});

test('is as wide as its place, with all fields in view on a phone, and whole on paper far down the page', async ({
  page,
  mount,
}) => {
  await page.setViewportSize({ width: 390, height: 800 });
  await mount(
    `${scene().replace('</phong-viewer>', '<phong-light name="red" position="-1 2 1 1" diffuse="255 60 30" attenuation="1 0.1 0.2" aperture="60" cutoff="3" axis="1 -2 -1"></phong-light></phong-viewer>')}${probe('as="ask" at="0 0 0"')}${probe('as="formula" at="0 0 0"')}`,
    { width: 300, height: 200, css: 'body { font-size: 24px; padding-top: 3000px }' },
  );
  const fields = page.getByRole('textbox');
  await expect(fields).toHaveCount(6);
  const ends = await fields.evaluateAll((all) =>
    all.map((one) => one.getBoundingClientRect().right),
  );
  expect(Math.max(...ends)).toBeLessThanOrEqual(390);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  await page.emulateMedia({ media: 'print' });
  const lines = page.locator('phong-probe').last().getByRole('listitem');
  await expect(lines).toHaveCount(6);
  const cut = await lines.evaluateAll(
    (all) =>
      all.filter((one) => one.scrollWidth > one.clientWidth || one.clientHeight === 0).length,
  );
  expect(cut).toBe(0);
});

test('explains a point of a viewer that was moved by a drag, once a frame', async ({
  page,
  mount,
}) => {
  const viewer = await mount(
    scene('probe-at="0 0 0" terms="specular" shininess="2"') + probe('as="formula"'),
    size,
  );
  const specular = line(page, 'lamp · specular');
  await expect(specular).toBeVisible();
  const before = await formulas(specular);
  await assign(viewer, { theta: 60 });
  await expect.poll(() => formulas(specular)).not.toBe(before);
  // That of one term.
  expect(await formulas(line(page, 'sum'))).toMatch(/^Σ=[\d.]+$/);
});
