// Does every attribute and property behave as its row of the table says? The elements are outside the document: parsing
// needs no picture, and nothing is fetched.

import { expect, test } from '../../support/test.js';
import { type Row, tables } from './attribute-rows.js';
import { assign } from '../support/viewer.js';

const propertyOf = ({ attribute, property }: Row): string =>
  property ?? attribute.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());

for (const [tag, rows] of Object.entries(tables)) {
  test(`attributes of <${tag}> behave as their table says`, async ({ page, mount }) => {
    await mount('<main></main>');
    for (const row of rows) {
      const faults = await page.evaluate(checkAttribute, { tag, row, property: propertyOf(row) });
      expect(faults, row.attribute).toEqual([]);
    }
  });

  test(`properties of <${tag}> accept typed values and strings, and refuse the rest`, async ({
    page,
    mount,
  }) => {
    await mount('<main></main>');
    for (const row of rows) {
      const faults = await page.evaluate(checkProperty, { tag, row, property: propertyOf(row) });
      expect(faults, row.attribute).toEqual([]);
    }
  });

  test(`the table of <${tag}> lists all of its attributes`, async ({ page, mount }) => {
    await mount('<main></main>');
    const observed = await page.evaluate(
      (name) => (customElements.get(name) as unknown as { observedAttributes: string[] }).observedAttributes,
      tag,
    );
    const known = [...rows.map(({ attribute }) => attribute), 'aria-label', 'aria-labelledby', 'role'];
    expect(observed.filter((attribute) => !known.includes(attribute))).toEqual([]);
  });
}

test('internals of an element are not properties', async ({ page, mount }) => {
  await mount('<main></main>');
  for (const [tag, rows] of Object.entries(tables)) {
    if (tag === 'phong-viewer' || tag === 'phong-compare') continue; // they have Lit’s as well
    const found = await page.evaluate((name) => {
      const element = document.createElement(name);
      const names = new Set(Object.getOwnPropertyNames(element));
      for (
        let at: object = Object.getPrototypeOf(element) as object;
        at !== HTMLElement.prototype;
        at = Object.getPrototypeOf(at) as object
      )
        // prettier-ignore
        for (const key of Object.getOwnPropertyNames(at)) names.add(key);
      return [...names];
    }, tag);
    const known = ['constructor', ...rows.map(propertyOf)];
    expect(found.filter((name) => !known.includes(name) && !name.endsWith('Callback'))).toEqual([]);
  }
  const found = await page.evaluate(() =>
    ['phong-viewer', 'phong-compare'].flatMap((name) => {
      const element = document.createElement(name);
      return ['state', 'declared', 'moveFrom', 'store', 'binding', 'context'].filter((key) => key in element);
    }),
  );
  expect(found).toEqual([]);
});

interface Case {
  readonly tag: string;
  readonly row: Row;
  readonly property: string;
}

/** Runs in the page. Returns what is wrong with an attribute. */
function checkAttribute({ tag, row, property }: Case): string[] {
  const { attribute, fallback, valid, malformed, outside } = row;
  const faults: string[] = [];
  const warnings: string[] = [];
  const warn = console.warn;
  console.warn = (...given: unknown[]) => warnings.push(given.join(' '));
  const element = document.createElement(tag);
  const check = (what: string, wanted: unknown): void => {
    const value = Reflect.get(element, property) as unknown;
    const got = JSON.stringify(value);
    if (got !== JSON.stringify(wanted)) faults.push(`${what} gives ${got}, not ${JSON.stringify(wanted)}`);
    const numbers: unknown[] = Array.isArray(value) ? value : [value];
    if (numbers.some((n) => Object.is(n, -0))) faults.push(`${what} gives -0`);
    if (Array.isArray(value) && !Object.isFrozen(value))
      faults.push(`${what} gives a list that is not frozen`);
  };
  check('absence', fallback);
  for (const [text, value] of valid) {
    element.setAttribute(attribute, text);
    check(`"${text}"`, value);
    element.removeAttribute(attribute);
    check(`removal after "${text}"`, fallback);
  }
  if (warnings.length > 0) faults.push(`good values are warned of: ${warnings.join(' | ')}`);
  for (const text of [...malformed, ...outside]) {
    warnings.length = 0;
    element.setAttribute(attribute, valid[0]?.[0] ?? '');
    element.setAttribute(attribute, text);
    check(`"${text}"`, fallback);
    element.setAttribute(attribute, valid[0]?.[0] ?? '');
    check(`a valid value after "${text}"`, valid[0]?.[1]);
    element.setAttribute(attribute, text);
    const instead =
      fallback === null
        ? 'none'
        : Array.isArray(fallback)
          ? fallback.join(' ')
          : `${fallback as string | number}`;
    const [first = '', ...more] = warnings;
    const named = [`<${tag}>`, attribute, JSON.stringify(text), 'expected', instead];
    const missing = named.filter((part) => !first.includes(part));
    if (missing.length > 0) faults.push(`the warning of "${text}" lacks ${missing.join(', ')}: ${first}`);
    if (more.length > 0) faults.push(`"${text}" is warned of ${String(warnings.length)} times`);
  }
  console.warn = warn;
  return faults;
}

/** Runs in the page. Returns what is wrong with a property. */
function checkProperty({ tag, row, property }: Case): string[] {
  const { attribute, fallback, valid, refused } = row;
  const faults: string[] = [];
  const element = document.createElement(tag);
  const check = (what: string, wanted: unknown): void => {
    const got = JSON.stringify(Reflect.get(element, property));
    if (got !== JSON.stringify(wanted)) faults.push(`${what} gives ${got}, not ${JSON.stringify(wanted)}`);
  };
  for (const [text, value] of valid) {
    for (const [what, given] of [
      ['the string', text],
      ['the value', value],
    ] as const) {
      Reflect.set(element, property, given);
      check(`${what} ${JSON.stringify(given)}`, value);
      const own = Reflect.get(element, property) as unknown;
      if (own === given && Array.isArray(given)) faults.push('keeps the list that it was given');
      for (const nothing of [null, undefined]) {
        Reflect.set(element, property, given);
        Reflect.set(element, property, nothing);
        check(`${String(nothing)} after ${JSON.stringify(given)}`, fallback);
      }
    }
  }
  const [text, value] = valid[0] ?? ['', fallback];
  Reflect.set(element, property, text);
  for (const [bad, wanted] of refused) {
    let thrown = 'nothing';
    try {
      (element as unknown as Record<string, unknown>)[property] = bad;
    } catch (error) {
      if (error instanceof Error) thrown = error.name;
      if (!String(error).includes(`<${tag}>`))
        faults.push(`the error does not name the element: ${String(error)}`);
    }
    if (thrown !== wanted) faults.push(`${JSON.stringify(bad)} throws ${thrown}, not ${wanted}`);
    check(`the refusal of ${JSON.stringify(bad)}`, value);
  }
  if (element.hasAttribute(attribute)) faults.push('is reflected');
  return faults;
}

test('values set before the upgrade are used if valid, and give a warning if not', async ({
  page,
  site,
  consoleGuard,
}) => {
  const warnings = consoleGuard.allow(/^warning: <phong-/, 3);
  await page.goto(
    site.page('<phong-viewer><phong-light></phong-light><phong-mesh></phong-mesh></phong-viewer>'),
  );
  await assign(page.locator('phong-viewer'), {
    fov: 33,
    target: [1, 2, 3],
    theta: 'north',
    autoRotate: null,
  });
  await assign(page.locator('phong-light'), { diffuse: '#fc8', cutoff: -3, name: 'early' });
  await assign(page.locator('phong-mesh'), { geometry: 'torus', scale: {} });
  await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js' });
  await page.evaluate(() => customElements.whenDefined('phong-viewer'));
  const values = await page.evaluate(() => {
    const viewer = document.querySelector('phong-viewer')!;
    const [light] = viewer.lights;
    const [mesh] = viewer.meshes;
    return [
      [viewer.fov, viewer.target, viewer.theta, viewer.autoRotate],
      [light?.diffuse, light?.cutoff, light?.name],
      [mesh?.geometry, mesh?.scale],
    ];
  });
  expect(values).toEqual([
    [33, [1, 2, 3], 30, 0],
    [[255, 204, 136], 0, 'early'],
    ['torus', [1, 1, 1]],
  ]);
  expect([...warnings].sort().map((line) => /<[\w-]+> [\w-]+/.exec(line)?.[0])).toEqual([
    '<phong-light> cutoff',
    '<phong-mesh> scale',
    '<phong-viewer> theta',
  ]);
  await assign(page.locator('phong-light'), { cutoff: 3 });
  expect(await page.evaluate(() => document.querySelector('phong-light')?.cutoff)).toBe(3);
});

test('colours of other spaces are converted to sRGB as the browser does', async ({ page, mount }) => {
  await mount('<main></main>');
  for (const [text, wanted] of [
    ['oklch(1 0 0)', [255, 255, 255]],
    ['oklch(0.7 0.1 200)', [64.2, 177.0, 182.8]],
    ['lab(50% 0 0)', [118.9, 118.9, 118.9]],
    ['color(display-p3 0.5 0.5 0.5)', [127.5, 127.5, 127.5]],
    ['color(srgb-linear 0.5 0.5 0.5)', [187.5, 187.5, 187.5]],
  ] as const) {
    const color = await page.evaluate((given) => {
      const light = document.createElement('phong-light');
      light.setAttribute('diffuse', given);
      return light.diffuse;
    }, text);
    for (const i of [0, 1, 2] as const)
      expect(Math.abs(color[i] - wanted[i]), `${text}: ${color.join(' ')}`).toBeLessThan(0.1);
  }
});

test('each bad value of each element gives one warning', async ({ mount, consoleGuard }) => {
  const warnings = consoleGuard.allow(/^warning: <phong-light> cutoff/, 3);
  const bad = '<phong-light cutoff="x"></phong-light>';
  const viewer = await mount(`<phong-viewer>${bad}${bad}</phong-viewer>`);
  await viewer
    .locator('phong-light')
    .first()
    .evaluate((light) => {
      light.setAttribute('cutoff', 'y');
      light.setAttribute('cutoff', 'x');
      light.remove();
    });
  expect(warnings.length).toBeLessThanOrEqual(3);
});

test('a warning repeats no more than a part of a long value', async ({ mount, consoleGuard }) => {
  const warnings = consoleGuard.allow(/^warning: <phong-light> (cutoff|diffuse|space)/, 3);
  const light = (await mount('<phong-viewer><phong-light></phong-light></phong-viewer>')).locator(
    'phong-light',
  );
  await light.evaluate((element) => {
    for (const key of ['cutoff', 'diffuse', 'space']) element.setAttribute(key, `${'😀'.repeat(5e4)}"`);
  });
  expect(warnings).toHaveLength(3);
  for (const text of warnings) {
    expect(text.length).toBeLessThan(400);
    expect(text).toMatch(/="(😀){50}\.\.\.": expected .*; using .* instead\.$/u);
  }
});

test('objects without a text form may be set before the upgrade', async ({ page, site, consoleGuard }) => {
  consoleGuard.allow(/^warning: <phong-light> \w+=an object: expected/, 3);
  await page.goto(site.page('<phong-viewer><phong-light></phong-light></phong-viewer>'));
  await page.evaluate(() => {
    const light = document.querySelector('phong-light');
    for (const key of ['name', 'diffuse', 'cutoff']) Reflect.set(light!, key, Object.create(null));
  });
  await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js' });
  expect(await page.evaluate(() => document.querySelector('phong-viewer')?.lights[0]?.diffuse)).toEqual([255, 255, 255]); // prettier-ignore
});

test('text that is too long or too deep for a colour never reaches the browser’s parser', async ({
  page,
  mount,
}) => {
  await page.addInitScript(() => {
    const { set, get } = Object.getOwnPropertyDescriptor(CanvasRenderingContext2D.prototype, 'fillStyle')!;
    Object.assign(window, { asked: [] });
    Object.defineProperty(CanvasRenderingContext2D.prototype, 'fillStyle', {
      get: get!,
      set(text: string) {
        (window as unknown as { asked: string[] }).asked.push(text);
        set?.call(this, text);
      },
    });
  });
  await mount('<main></main>');
  const outcome = await page.evaluate(() => {
    const { asked } = window as unknown as { asked: string[] };
    asked.length = 0;
    const light = document.createElement('phong-light');
    const accepts = (text: string): boolean => {
      try {
        light.diffuse = text;
        return true;
      } catch {
        return false;
      }
    };
    const refused = [
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
    const untouched = asked.length === 0;
    const deep = 'color-mix(in srgb, rgb(calc((100 + 100)) 0 0), rgb(200 0 0))';
    return [refused, untouched, accepts(deep)];
  });
  expect(outcome).toEqual([[], true, true]);
});

test('values that were refused are not kept', async ({ page, mount, consoleGuard }) => {
  const warnings = consoleGuard.allow(/^warning: <phong-light> diffuse=/);
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
  expect(warnings.length).toBeLessThan(400);
});
