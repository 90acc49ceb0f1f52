// What must hold in every browser: element, camera, panel, helpers, views, probe, comparisons,
// models, and pictures against the equation. One list of pages and checks, for whatever drives the
// browser. Viewers are 600 × 400 CSS pixels at the page's top left unless a check says otherwise.
import { expect } from '@playwright/test';
import { inPageModule } from '../../.ci/in-page.js';
import type * as InPage from '../../src/extras/playwright/in-page.js';
import { verdictOf } from '../../src/extras/playwright/verdict.js';
import type { PhongViewer } from '../element/support/viewer.js';
import { decodePng, type Picture } from '../support/picture.js';
import { named, wasmPolicy } from '../support/site.js';
import { randomScene, sceneMarkup } from '../visual/random-scene.js';
import type { Tab } from './tabs.js';

const { judgeInPage, settleInPage } = (await import(
  `data:text/javascript,${encodeURIComponent(await inPageModule())}`
)) as typeof InPage;

interface Check {
  readonly title: string;
  readonly markup: string;
  /** Size of every viewer in CSS pixels, default 600 × 400. */
  readonly size?: { readonly width: number; readonly height: number };
  /** Of every viewer, default `block`. */
  readonly display?: 'inline-block';
  /** The page's policy, default the strict one. */
  readonly csp?: string;
  /** The viewer is ready. */
  readonly holds: (tab: Tab) => Promise<void>;
  /** What the page may print. Default: nothing. */
  readonly said?: RegExp;
}

const SMALL = { width: 180, height: 120 };
const TINY = { width: 120, height: 90 };

const LIGHTS = `<phong-light name="sun" position="1 2 1 0" ambient="30 20 40" diffuse="180 180 170" specular="90"></phong-light>
  <phong-light name="lamp" position="2 2 0 1" diffuse="#fc8" attenuation="1 0.2 0.05"></phong-light>
  <phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20" cutoff="12"></phong-light>`;

const SEVERAL = [
  'geometry="sphere"',
  'geometry="torus" phi="60"',
  'geometry="teapot" theta="30"',
  'geometry="box" view="n-dot-l"',
  'src="/assets/models/bunny.glb"',
  'geometry="sphere" segments="12" shading="flat"',
  'geometry="torus-knot" shininess="2000"',
];

const AMBIENT =
  '<phong-light position="0 0 1 0" ambient="255" diffuse="0" specular="0"></phong-light>';

const cameraOf = (tab: Tab) =>
  tab.run(() => {
    const { theta, phi, radius } = document.querySelector<PhongViewer>('phong-viewer')!.camera;
    return { theta, phi, radius };
  });

/** What `toBlob` of one of the page's viewers gives. */
async function blobOf(
  tab: Tab,
  size: { readonly width?: number; readonly height?: number } = {},
  index = 0,
) {
  const base64 = await tab.run(
    async ([options, at]) => {
      const viewer = document.querySelectorAll<PhongViewer>('phong-viewer')[at]!;
      const bytes = new Uint8Array(await (await viewer.toBlob(options)).arrayBuffer());
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
    },
    [size, index] as const,
  );
  return decodePng(Buffer.from(base64, 'base64'));
}

/**
 * Waits until every viewer of the page is ready. Its own picture counts, so the frame after is
 * waited for as well.
 */
export const allReady = (tab: Tab): Promise<null> =>
  tab.run(async () => {
    await customElements.whenDefined('phong-viewer');
    for (const viewer of document.querySelectorAll<PhongViewer>('phong-viewer')) {
      await viewer.ready;
    }
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    return null;
  });

/** The first viewer's picture against the equation, at this share of its pixels at least. */
async function showsTheEquation(tab: Tab, what: string, share: number) {
  const judgement = await tab.onViewer(judgeInPage, { codes: 1, pixels: null, seed: 1, most: 5 });
  const { pass, message } = verdictOf(judgement, { codes: 1, share }, 1);
  expect(pass, `${what}: ${message}`).toBe(true);
}

const show = (tab: Tab, markup: string) =>
  tab.run(async (text) => {
    document.querySelector('phong-viewer')!.outerHTML = text;
    await document.querySelector<PhongViewer>('phong-viewer')!.ready;
    return null;
  }, named(markup));

/** Opens the panel's folder and types into one of its rows. */
const typeIntoPanel = (tab: Tab, folder: string, name: string, text: string) =>
  tab.onViewer(
    async (viewer, [title, label, value]) => {
      const found = async <T extends HTMLElement>(selector: string, words: string) => {
        for (let frames = 0; frames < 600; frames++) {
          const all = viewer.shadowRoot!.querySelectorAll<T>(selector);
          const one = [...all].find(({ textContent }) => textContent === words);
          if (one !== undefined) return one;
          await new Promise(requestAnimationFrame);
        }
        throw new Error(`the panel shows no ${words}`);
      };
      const button = await found('.lil-title', title);
      if (button.getAttribute('aria-expanded') === 'false') {
        button.click();
      }
      const row = (await found('.lil-name', label)).closest('.lil-controller')!;
      const input = [...row.querySelectorAll('input')].find(({ type }) => type !== 'range')!;
      input.focus();
      input.value = value;
      for (const type of ['input', 'change']) {
        input.dispatchEvent(new Event(type, { bubbles: true }));
      }
      return null;
    },
    [folder, name, text] as const,
  );

export const CHECKS: readonly Check[] = [
  {
    title:
      'element: reads colours of CSS, warns of mistakes, reports changes, and draws nothing while nothing changes',
    markup: `<phong-viewer geometry="box" fov="wide"><phong-light diffuse="oklch(70% 0.1 50)"></phong-light></phong-viewer>`,
    said: /fov="wide"/,
    async holds(tab) {
      const found = await tab.onViewer(async (viewer) => {
        const events = new Set<string>();
        for (const type of ['render', 'light-change', 'camera-change'] as const) {
          viewer.addEventListener(type as 'render', () => events.add(type));
        }
        const isRead = viewer.lights[0]!.diffuse.every((c) => c > 0 && c < 256);
        viewer.append(document.createElement('phong-light'), document.createElement('phong-mesh'));
        viewer.theta = 40;
        await viewer.ready;
        const counts = [viewer.lights.length, viewer.meshes.length];
        await new Promise((resolve) => setTimeout(resolve, 100));
        const { frames } = viewer.stats;
        await new Promise((resolve) => setTimeout(resolve, 500));
        return { isRead, counts, events: [...events].sort(), idle: viewer.stats.frames - frames };
      });
      const events = ['camera-change', 'light-change', 'render'];
      expect(found).toEqual({ isRead: true, counts: [2, 1], events, idle: 0 });
    },
  },
  {
    title: 'element: the window shows what toBlob gives, for each of three viewers',
    markup: `<phong-viewer geometry="box">${LIGHTS}</phong-viewer><phong-viewer geometry="sphere">${LIGHTS}</phong-viewer><phong-viewer geometry="torus" kd="200 60 40"></phong-viewer>`,
    size: SMALL,
    async holds(tab) {
      const { width, data } = decodePng(Buffer.from(await tab.screenshot()));
      for (const index of [0, 1, 2]) {
        const { data: picture } = await blobOf(tab, {}, index);
        let differing = 0;
        for (let y = 0; y < SMALL.height; y++) {
          for (let i = 0; i < 4 * SMALL.width; i++) {
            const at = 4 * y * SMALL.width + i;
            const alpha = i % 4 === 3 ? 0 : picture[at | 3]!;
            const onWhite = 255 + ((picture[at]! - 255) * alpha) / 255;
            const shown = data[4 * (y + index * SMALL.height) * width + i]!;
            if (Math.abs(shown - onWhite) > 1.5) {
              differing += 1;
            }
          }
        }
        // The browser blends translucent edges by arithmetic of its own.
        expect(differing / picture.length, `viewer ${index}`).toBeLessThan(0.001);
        expect(new Set(picture).size, `tones of viewer ${index}`).toBeGreaterThan(20);
      }
    },
  },
  {
    title:
      'camera: drags, keys and the wheel turn and zoom; without the focus the wheel scrolls the page',
    markup:
      '<phong-viewer geometry="box" theta="30" phi="70" radius="5"></phong-viewer><div></div>',
    async holds(tab) {
      const start = { theta: 30, phi: 70, radius: 5 };
      await tab.wheel([300, 200], 40);
      await expect.poll(() => tab.run(() => scrollY)).toBeGreaterThan(0);
      expect(await cameraOf(tab)).toEqual(start);
      await tab.run(() => scrollTo(0, 0));
      // 360° a width and 180° a height, and exactly back.
      await tab.drag([300, 200], [60, 40]);
      expect(await cameraOf(tab)).toEqual({ theta: -6, phi: 52, radius: 5 });
      await tab.drag([300, 200], [-60, -40]);
      expect(await cameraOf(tab)).toEqual(start);
      await tab.press('ArrowRight');
      await tab.press('+');
      const moved = await cameraOf(tab);
      expect(moved.theta).toBe(25);
      expect(moved.radius).toBeCloseTo(5 / 1.1, 7); // as it is written
      await tab.press('Home');
      expect(await cameraOf(tab)).toEqual(start);
      await tab.wheel([300, 200], 100);
      await expect.poll(async () => (await cameraOf(tab)).radius).toBeGreaterThan(5.05);
      expect(await tab.run(() => scrollY)).toBe(0);
    },
  },
  {
    title: 'panel: opens, moves the camera, and follows a drag',
    markup: `<phong-viewer gui geometry="box" theta="30" phi="70">${LIGHTS}</phong-viewer>`,
    async holds(tab) {
      await typeIntoPanel(tab, 'Camera', 'θ azimuth °', '75');
      await expect.poll(async () => (await cameraOf(tab)).theta).toBe(75);
      await tab.drag([150, 200], [60, 0]);
      await expect.poll(async () => (await cameraOf(tab)).theta).toBe(39);
      const shown = () =>
        tab.run(
          () =>
            [
              ...document
                .querySelector('phong-viewer')!
                .shadowRoot!.querySelectorAll('.lil-controller'),
            ]
              .find((row) => row.querySelector('.lil-name')?.textContent === 'θ azimuth °')
              ?.querySelector<HTMLInputElement>('input:not([type=range])')?.value,
        );
      await expect.poll(shown).toBe('39');
    },
  },
  {
    title: 'helpers: a light follows a drag in the plane of the view, and the camera stays',
    markup: `<phong-viewer helpers geometry="box" theta="0" phi="90" radius="4" target="0 0 0" fov="90">
      <phong-light name="lamp" position="0.5 0.4 0 1"></phong-light></phong-viewer>`,
    async holds(tab) {
      await tab.run(async () => {
        const root = document.querySelector('phong-viewer')!.shadowRoot!;
        while (root.querySelector('[role=option]') === null) {
          await new Promise(requestAnimationFrame);
        }
      });
      // 50 pixels are a unit at the target: the light stands at 325, 180.
      await tab.drag([325, 180], [-60, 30]);
      const found = await tab.run(() => {
        const viewer = document.querySelector<PhongViewer>('phong-viewer')!;
        return { position: viewer.lights[0]!.position, theta: viewer.camera.theta };
      });
      expect(found.theta).toBe(0);
      [-0.7, -0.2, 0, 1].forEach((x, i) =>
        expect(found.position[i], `position ${i}`).toBeCloseTo(x, 2),
      );
    },
  },
  {
    title: 'view: a pixel has the colour of the quantity, and the legend names it',
    markup: `<phong-viewer view="n-dot-l" geometry="box" theta="0" phi="90">
      <phong-light name="sun" position="0 1 1 0" specular="0"></phong-light></phong-viewer>`,
    async holds(tab) {
      const { width, data } = decodePng(Buffer.from(await tab.screenshot()));
      // The box's front faces the eye, and N·L is √½ there.
      const at = 4 * (200 * width + 300);
      for (const code of data.slice(at, at + 3)) {
        expect(Math.abs(code - 255 * Math.SQRT1_2)).toBeLessThan(1.01);
      }
      const legend = () =>
        tab.onViewer((viewer) => viewer.shadowRoot!.querySelector('.legend')?.textContent);
      expect(await legend()).toContain('N · L');
    },
  },
  {
    title: 'probe: a click pins a point, whose table has the colour that shadeAt gives',
    markup: `<phong-viewer probe geometry="sphere" theta="0" phi="90" radius="1.6" target="0 0 0">${LIGHTS}</phong-viewer>`,
    size: { width: 600, height: 560 }, // room for a row for each light
    async holds(tab) {
      const shown = () =>
        tab.onViewer((viewer) => {
          const box = viewer.shadowRoot!.querySelector<HTMLElement>('[part=probe]');
          if (box === null || box.offsetWidth === 0) return null;
          return {
            pinned: box.classList.contains('pinned'),
            codes: box.querySelector('.codes')!.textContent,
            rows: Array.from(box.querySelectorAll<HTMLElement>('tbody th'))
              .filter(({ offsetWidth }) => offsetWidth > 0)
              .map(({ textContent }) => textContent),
          };
        });
      const expected = await tab.onViewer(async (viewer) => {
        const fragment = await viewer.shadeAt(280, 130);
        return fragment!.color.map((c) => (255 * c).toFixed(0)).join(' ');
      });
      await tab.drag([280, 130], [0, 0]);
      await expect.poll(shown).toMatchObject({
        pinned: true,
        codes: expected,
        rows: [/^sun/, /^lamp/, /^spot/].map((name) => expect.stringMatching(name) as unknown),
      });
      await tab.drag([5, 395], [0, 0]);
      await expect.poll(shown).toBeNull();
    },
  },
  {
    title:
      'comparison: shows a viewer on each side of the divider, which follows a drag and then the keys',
    markup: `<phong-compare><phong-viewer geometry="sphere" ka="255 0 0" kd="0" ks="0">${AMBIENT}</phong-viewer>
      <phong-viewer geometry="sphere" ka="0 0 255" kd="0" ks="0">${AMBIENT}</phong-viewer></phong-compare>`,
    async holds(tab) {
      const place = () =>
        tab.run(() => {
          const root = document.querySelector('phong-compare')!.shadowRoot;
          return root?.querySelector('[role=separator]')?.getAttribute('aria-valuenow');
        });
      await expect.poll(place).toBe('50');
      // The comparison is 300 × 150 pixels, and the sphere in its middle.
      const colors = async (...xs: readonly number[]) => {
        await allReady(tab);
        const { width, data } = decodePng(Buffer.from(await tab.screenshot()));
        return xs.map((x) => [...data.slice(4 * (75 * width + x), 4 * (75 * width + x) + 3)]);
      };
      const red = [255, 0, 0];
      const blue = [0, 0, 255];
      expect(await colors(125, 175)).toEqual([red, blue]);
      await tab.drag([150, 20], [60, 0]);
      expect(await place()).toBe('70');
      expect(await colors(125, 175)).toEqual([red, red]);
      await tab.press('ArrowRight');
      expect(await place()).toBe('71');
      await tab.press('Home');
      expect(await place()).toBe('0');
      expect(await colors(125, 175)).toEqual([blue, blue]);
    },
  },
  {
    title:
      'models: Draco, textures, vertex colours, alpha masks and embedded files are shown as the equation says',
    markup: '<phong-viewer></phong-viewer>',
    size: SMALL,
    async holds(tab) {
      for (const [file, share] of [
        ['/fixtures/models/textured.glb', 0.3],
        ['/fixtures/models/vertex-colours.glb', 0.3],
        ['/fixtures/models/mask.glb', 0.1],
        ['/fixtures/models/data-uris.gltf', 0.1],
        ['/assets/models/bunny.glb', 0.1],
      ] as const) {
        await show(tab, `<phong-viewer src="${file}">${LIGHTS}</phong-viewer>`);
        if (file.endsWith('bunny.glb')) {
          // Close by, so that triangles are larger than a few pixels.
          await tab.run(() => {
            const viewer = document.querySelector<PhongViewer>('phong-viewer')!;
            viewer.radius = viewer.camera.radius / 4;
          });
        }
        await showsTheEquation(tab, file, share);
      }
    },
  },
  {
    title: 'models: a KTX2 texture is shown as the equation says',
    markup: `<phong-viewer src="/fixtures/models/ktx2.glb">${LIGHTS}</phong-viewer>`,
    size: SMALL,
    csp: wasmPolicy,
    async holds(tab) {
      await showsTheEquation(tab, 'ktx2.glb', 0.3);
    },
  },
  {
    title:
      'pictures: every shading, reflection and interpolation follows the equation, by both kinds of programs',
    markup: '<phong-viewer></phong-viewer>',
    size: SMALL,
    async holds(tab) {
      const linear = 'reflection="blinn-phong" color-interpolation="linear"';
      for (const geometry of ['box', 'sphere']) {
        for (const style of ['', 'shading="gouraud"', 'shading="flat"', linear]) {
          const attributes = `geometry="${geometry}" segments="12" radius="1.6" ${style}`;
          await show(tab, `<phong-viewer ${attributes}>${LIGHTS}</phong-viewer>`);
          await showsTheEquation(tab, attributes, 0.3);
        }
      }
      await tab.onViewer(settleInPage, 60_000);
      await showsTheEquation(tab, 'specialised programs', 0.3);
    },
  },
  {
    title: 'pictures: random scenes follow the equation, seeds 1 to 24',
    markup: '<phong-viewer></phong-viewer>',
    size: SMALL,
    async holds(tab) {
      for (let seed = 1; seed <= 24; seed++) {
        const markup = sceneMarkup(randomScene(seed, seed % 3 === 0 ? 'box' : 'plane'));
        await show(tab, markup);
        const { data } = await blobOf(tab);
        if (data.some((code, i) => i % 4 === 3 && code > 0)) {
          await showsTheEquation(tab, `seed ${seed}: ${markup}`, 0.2);
        }
      }
    },
  },
  {
    title:
      'pictures: antialias="full" converges to the mean of a larger picture, among other viewers, and then rests',
    markup: [...SEVERAL, ...SEVERAL]
      .map((scene) => `<phong-viewer antialias="full" ${scene}>${LIGHTS}</phong-viewer>`)
      .join(''),
    display: 'inline-block',
    size: TINY,
    async holds(tab) {
      const { width, height } = TINY;
      /** Premultiplied codes, each the mean of `times`² pixels. */
      const codesOf = (picture: Picture, times: number) => {
        const means = new Array<number>(4 * width * height).fill(0);
        picture.data.forEach((code, i) => {
          const [x, y] = [(i >> 2) % picture.width, Math.floor((i >> 2) / picture.width)];
          const to = 4 * (Math.floor(y / times) * width + Math.floor(x / times)) + (i % 4);
          means[to]! += (i % 4 === 3 ? code : (code * picture.data[i | 3]!) / 255) / times ** 2;
        });
        return means;
      };
      const shown = codesOf(await blobOf(tab), 1);
      const mean = codesOf(await blobOf(tab, { width: 4 * width, height: 4 * height }), 4);
      const { samples, idle } = await tab.onViewer(async (viewer) => {
        const { frames, samples } = viewer.stats;
        await new Promise((resolve) => setTimeout(resolve, 300));
        return { samples, idle: viewer.stats.frames - frames };
      });
      const offs = shown.map((code, i) => Math.abs(code - mean[i]!));
      const off = Math.sqrt(offs.reduce((sum, one) => sum + one ** 2, 0) / offs.length);
      expect({ samples, idle }).toEqual({ samples: 64, idle: 0 });
      expect(off, 'codes').toBeLessThan(2);
    },
  },
];
