// Does every attribute and property behave as its row of the table says? The elements are outside
// the document: parsing needs no picture, and nothing is fetched.

import { expect, test } from '../../support/test.js';
import { type Row, tables } from './attribute-rows.js';
import { assign } from '../support/viewer.js';

const propertyOf = ({ attribute, property }: Row): string =>
  property ?? attribute.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());

for (const [tag, rows] of Object.entries(tables)) {
  test(`attributes and properties of <${tag}> behave as their complete table says`, async ({
    page,
    mount,
  }) => {
    await mount('<main></main>');
    for (const row of rows) {
      const faults = await page.evaluate(faultsOf, { tag, row, property: propertyOf(row) });
      expect(faults, row.attribute).toEqual([]);
    }
    const [observed, keys] = await page.evaluate((name) => {
      const { observedAttributes } = customElements.get(name) as unknown as {
        observedAttributes: string[];
      };
      const element = document.createElement(name);
      const names = new Set(Object.getOwnPropertyNames(element));
      for (
        let at: object = Object.getPrototypeOf(element) as object;
        at !== HTMLElement.prototype;
        at = Object.getPrototypeOf(at) as object
      ) {
        for (const key of Object.getOwnPropertyNames(at)) {
          names.add(key);
        }
      }
      return [observedAttributes, [...names]] as const;
    }, tag);
    const known = [
      ...rows.map(({ attribute }) => attribute),
      'aria-label',
      'aria-labelledby',
      'role',
    ];
    expect(observed.filter((attribute) => !known.includes(attribute))).toEqual([]);
    // Internals are not properties. Viewers and comparisons have methods and Lit’s properties as
    // well.
    const internals = ['state', 'declared', 'moveFrom', 'store', 'binding', 'context'];
    const inside =
      tag === 'phong-viewer' || tag === 'phong-compare'
        ? keys.filter((key) => internals.includes(key))
        : keys.filter(
            (key) =>
              !['constructor', ...rows.map(propertyOf)].includes(key) && !key.endsWith('Callback'),
          );
    expect(inside).toEqual([]);
  });
}

/** Runs in the page. Returns what is wrong with an attribute and its property. */
function faultsOf({ tag, row, property }: { tag: string; row: Row; property: string }): string[] {
  const { attribute, fallback, valid, bad, refused } = row;
  const faults: string[] = [];
  const warnings: string[] = [];
  const warn = console.warn;
  console.warn = (...given: unknown[]) => warnings.push(given.join(' '));
  let element = document.createElement(tag);
  const texts = Object.entries(valid);
  const [good, itsValue] = texts[0]!;
  const check = (what: string, wanted: unknown): void => {
    const value = Reflect.get(element, property) as unknown;
    const got = JSON.stringify(value);
    if (got !== JSON.stringify(wanted)) {
      faults.push(`${what} gives ${got}, not ${JSON.stringify(wanted)}`);
    }
    if ([value].flat().some((n) => Object.is(n, -0))) {
      faults.push(`${what} gives -0`);
    }
    if (Array.isArray(value) && !Object.isFrozen(value)) {
      faults.push(`${what} gives a list that is not frozen`);
    }
  };
  check('absence', fallback);
  for (const [text, value] of texts) {
    element.setAttribute(attribute, text);
    check(`"${text}"`, value);
    element.removeAttribute(attribute);
    check(`removal after "${text}"`, fallback);
  }
  if (warnings.length > 0) {
    faults.push(`good values are warned of: ${warnings.join(' | ')}`);
  }
  for (const text of bad) {
    warnings.length = 0;
    element.setAttribute(attribute, good);
    element.setAttribute(attribute, text);
    check(`"${text}"`, fallback);
    element.setAttribute(attribute, good);
    check(`a valid value after "${text}"`, itsValue);
    element.setAttribute(attribute, text);
    const instead = fallback === null ? 'none' : [fallback].flat().join(' ');
    const named = [`<${tag}>`, attribute, JSON.stringify(text), 'expected', instead];
    const missing = named.filter((part) => warnings[0]?.includes(part) !== true);
    if (missing.length > 0) {
      faults.push(`the warning of "${text}" lacks ${missing.join()}: ${warnings[0]}`);
    }
    if (warnings.length > 1) {
      faults.push(`"${text}" is warned of ${warnings.length} times`);
    }
  }
  console.warn = warn;

  element = document.createElement(tag);
  for (const [text, value] of texts) {
    for (const given of [text, value]) {
      const what = JSON.stringify(given);
      Reflect.set(element, property, given);
      check(`the property ${what}`, value);
      if (Array.isArray(given) && Reflect.get(element, property) === given) {
        faults.push('keeps the list that it was given');
      }
      for (const nothing of [null, undefined]) {
        Reflect.set(element, property, given);
        Reflect.set(element, property, nothing);
        check(`${nothing} after ${what}`, fallback);
      }
    }
  }
  Reflect.set(element, property, good);
  for (const [kind, values] of Object.entries(refused)) {
    for (const wrong of values) {
      let error = 'nothing';
      try {
        (element as unknown as Record<string, unknown>)[property] = wrong;
      } catch (thrown) {
        error = String(thrown);
      }
      const what = JSON.stringify(wrong);
      if (!error.startsWith(kind) || !error.includes(`<${tag}>`)) {
        faults.push(`${what} throws ${error}, not a ${kind} that names the element`);
      }
      check(`the refusal of ${what}`, itsValue);
    }
  }
  if (element.hasAttribute(attribute)) {
    faults.push('is reflected');
  }
  return faults;
}

test('values set before the upgrade are used, or give a warning if invalid', async ({
  page,
  site,
  consoleGuard,
}) => {
  const warnings = consoleGuard.allow(/^warning: <phong-/, 6);
  const light = '<phong-light></phong-light>';
  await page.goto(
    site.page(`<phong-viewer>${light}<phong-mesh></phong-mesh>${light}</phong-viewer>`),
  );
  const ofViewer = { fov: 33, target: [1, 2, 3], theta: 'north', autoRotate: null };
  await assign(page.locator('phong-viewer'), ofViewer);
  const first = page.locator('phong-light').first();
  await assign(first, { diffuse: '#fc8', cutoff: -3, name: 'early' });
  await assign(page.locator('phong-mesh'), { geometry: 'torus', scale: {} });
  await page.evaluate(() => {
    // Objects without a text form.
    const second = document.querySelectorAll('phong-light')[1]!;
    for (const key of ['name', 'diffuse', 'cutoff']) {
      Reflect.set(second, key, Object.create(null));
    }
  });
  await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js' });
  await page.evaluate(() => customElements.whenDefined('phong-viewer'));
  const values = await page.evaluate(() => {
    const viewer = document.querySelector('phong-viewer')!;
    const [light, other] = viewer.lights;
    const [mesh] = viewer.meshes;
    return [
      [viewer.fov, viewer.target, viewer.theta, viewer.autoRotate],
      [light?.diffuse, light?.cutoff, light?.name],
      [other?.diffuse, other?.cutoff, other?.name],
      [mesh?.geometry, mesh?.scale],
    ];
  });
  expect(values).toEqual([
    [33, [1, 2, 3], 30, 0],
    [[255, 204, 136], 0, 'early'],
    [[255, 255, 255], 0, 'light 2'],
    ['torus', [1, 1, 1]],
  ]);
  expect([...warnings].sort().map((line) => /<[\w-]+> [\w-]+/.exec(line)?.[0])).toEqual([
    '<phong-light> cutoff',
    '<phong-light> cutoff',
    '<phong-light> diffuse',
    '<phong-light> name',
    '<phong-mesh> scale',
    '<phong-viewer> theta',
  ]);
  await assign(first, { cutoff: 3 });
  expect(await page.evaluate(() => document.querySelector('phong-light')?.cutoff)).toBe(3);
});

test('the browser converts colours to sRGB; text too long or too deep never reaches it', async ({
  page,
  mount,
}) => {
  await mount('<main></main>');
  for (const [text, wanted] of [
    ['oklch(1 0 0)', [255, 255, 255]],
    ['oklch(0.7 0.1 200)', [64.2, 177.0, 182.8]],
    ['lab(50% 0 0)', [118.9, 118.9, 118.9]],
    ['color(display-p3 0.5 0.5 0.5)', [127.5, 127.5, 127.5]],
    ['color(srgb-linear 0.5 0.5 0.5)', [187.5, 187.5, 187.5]],
  ] as const) {
    const color = await page.evaluate(
      (diffuse) => Object.assign(document.createElement('phong-light'), { diffuse }).diffuse,
      text,
    );
    wanted.forEach((code, i) => expect(Math.abs(Number(color[i]) - code), text).toBeLessThan(0.1));
  }
  const outcome = await page.evaluate(() => {
    const parser = Object.getOwnPropertyDescriptor(
      CanvasRenderingContext2D.prototype,
      'fillStyle',
    )!;
    let asked = 0;
    Object.defineProperty(CanvasRenderingContext2D.prototype, 'fillStyle', {
      ...parser,
      set(text: string) {
        asked += 1;
        parser.set!.call(this, text);
      },
    });
    const light = document.createElement('phong-light');
    const accepts = (text: string): boolean => {
      try {
        light.diffuse = text;
        return true;
      } catch {
        return false;
      }
    };
    const accepted = [
      'color-mix('.repeat(40),
      'color-mix(in srgb, '.repeat(5),
      '('.repeat(5e4),
      `rgb(${')'.repeat(50)}${'('.repeat(50)}`,
      'color-mix(/*)*/'.repeat(13),
      `color-mix(")"`.repeat(13),
      'color-mix(\\)'.repeat(13),
      `rgb(1 2 3${' '.repeat(200)}/ 1)`,
      `${' '.repeat(200)}#fc8`,
    ].filter(accepts);
    const before = asked;
    const deep = 'color-mix(in srgb, rgb(calc((100 + 100)) 0 0), rgb(200 0 0))';
    return [accepted, before, accepts(deep), asked > 0];
  });
  expect(outcome).toEqual([[], 0, true, true]);
});

test('values that were refused are not kept', async ({ page, mount, consoleGuard }) => {
  consoleGuard.allow(/^warning: <phong-light> diffuse=/);
  const light = (await mount('<phong-viewer><phong-light></phong-light></phong-viewer>')).locator(
    'phong-light',
  );
  const session = await page.context().newCDPSession(page);
  const heap = async (): Promise<number> => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize;
  };
  const write = (count: number): Promise<void> =>
    light.evaluate((element, times) => {
      for (let i = 0; i < times; i++) {
        const text = `${String(i)} ${'color-mix('.repeat(1e5)}`;
        element.setAttribute('diffuse', text);
        element.setAttribute('diffuse', `#fc8${text}`.slice(0, 199 + i));
        element.removeAttribute('diffuse');
      }
    }, count);
  await write(2);
  const before = await heap();
  await write(150);
  expect((await heap()) - before).toBeLessThan(4e6);
});
