// What does a screen reader find in the controls and probes of a lesson? axe, also in forced colours.

import { expectNoFaults } from '../support/axe.js';
import { expect, test } from '../support/test.js';

const scene = `<phong-viewer id="v" alt="A torus" geometry="torus"><phong-light id="spot" position="0 2 0"
  aperture="30" cutoff="8"></phong-light></phong-viewer>`;
const of = (attributes: string, label = '') =>
  `<phong-control ${attributes}>${label}</phong-control>`;
const all = [
  of('for="spot" attribute="aperture"'),
  of('for="spot" attribute="diffuse"', 'its colour'),
  of('for="spot" attribute="position"'),
  of('for="spot" attribute="active"'),
  of('for="v" attribute="shading"', 'shading'),
  of('for="v" attribute="terms"', 'terms of the sum'),
  of('for="v" attribute="terms" values="ambient | ambient diffuse"', 'the sum'),
];
const probes = ['', 'as="formula"', 'as="ask"'].map(
  (as) => `<phong-probe for="v" at="0.5 0 0" ${as}></phong-probe>`,
);
const css = 'phong-viewer { display: block; width: 160px; height: 100px }';

test('controls in a text and alone, and probes of every form, have no fault that axe finds', async ({
  page,
  mount,
}) => {
  await mount(
    `<main><h1>A lesson</h1>${scene}<p>Turn ${all.join(', ')}.</p>${all.join('')}${probes.join('')}</main>`,
    { css },
  );
  const answer = page.locator('[as=ask]').getByRole('textbox').first();
  await answer.fill('1');
  await answer.press('Enter');
  await expect(page.getByRole('status').first()).not.toHaveText('');
  await expect(page.getByRole('spinbutton', { name: 'aperture' })).toHaveCount(2);
  await expect(page.getByRole('group', { name: 'terms of the sum' })).toHaveCount(2);
  await expectNoFaults(page);
});
