// Loads hostile models one after the other in one viewer, and holds what must be true after each:
// an event, the picture, nothing unhandled, no request, bounded memory. Memory is read from the
// system, so only on Linux.
import { readFileSync } from 'node:fs';
import type { Browser, Page } from '@playwright/test';
import { Random } from '../stress/random.js';
import type { ConsoleGuard } from '../support/console-guard.js';
import { type ViewerLocator, expect, type Mount } from '../support/test.js';
import { barClaimsGlb, barGlb, hostileFile, triangleGlb } from './models.js';

/** Largest growth of the page's and the GPU's processes together, for any file. */
export const GROWTH_LIMIT_MB = 1000;

/** Milliseconds after which a file counts as hanging. Refusing one takes milliseconds. */
const HANG_MS = 30_000;

/** Real files to be changed; served at `/fixtures/` and `/assets/`. */
const REAL = [
  'tests/fixtures/models/textured.glb',
  'tests/fixtures/models/vertex-colours.glb',
  'tests/fixtures/models/mask.glb',
  'tests/fixtures/models/no-normals.glb',
  'demo/assets/models/bunny.glb',
];

const root = new URL('../../', import.meta.url);

interface FuzzOptions {
  readonly seed: number;
  readonly count: number;
  readonly consoleGuard: ConsoleGuard;
}

export async function fuzzModels(
  browser: Browser,
  page: Page,
  mount: Mount,
  { seed, count, consoleGuard }: FuzzOptions,
): Promise<void> {
  const random = new Random(seed);
  const files = [...REAL.map((name) => readFileSync(new URL(name, root))), barGlb()];
  let bytes = triangleGlb();
  const requests: string[] = [];
  await page.route('**/fuzz/*', (route) => route.fulfill({ body: bytes }));
  const viewer = await mount('<phong-viewer src="/fuzz/base.glb"></phong-viewer>', {
    width: 60,
    height: 40,
  });
  const before = await pictureOf(viewer);
  const memory = await MemoryWatch.of(browser);
  // Changed animations may be left out; this one is, so that the claim is met. Others need an
  // extension that is none.
  consoleGuard.allow(/^warning: (.* is shown without |The model needs the glTF extension )/);
  bytes = barClaimsGlb(9, 1e6, 5126, false);
  expect(await load(viewer, `/fuzz/${seed}-bar.glb`)).toBe('load');
  bytes = triangleGlb();
  expect(await load(viewer, '/fuzz/base.glb')).toBe('load');
  page.on('request', (request) => requests.push(new URL(request.url()).pathname));
  const outcomes: Record<string, number> = {};
  let most = 0;
  for (let i = 0; i < count; i++) {
    const file = hostileFile(random, files);
    const which = `seed ${seed}, file ${i}: ${file.what.slice(0, 300)}`;
    bytes = file.bytes;
    memory.start();
    const outcome = await load(viewer, `/fuzz/${seed}-${i}.glb`);
    const growth = memory.stop();
    most = Math.max(most, growth);
    outcomes[outcome] = (outcomes[outcome] ?? 0) + 1;
    expect(outcome, which).toMatch(/^(load|bad-model|too-large|load-failed)$/);
    expect(growth, `growth in MB of ${which}`).toBeLessThan(GROWTH_LIMIT_MB);
    if (outcome === 'load') {
      bytes = triangleGlb();
      expect(await load(viewer, `/fuzz/base-${i}.glb`), `after ${which}`).toBe('load');
    }
    expect(await pictureOf(viewer), `the picture after ${which}`).toBe(before);
  }
  expect(
    requests.filter((path) => !path.startsWith('/fuzz/') && !path.startsWith('/dist/')),
  ).toEqual([]);
  console.log(
    `seed ${seed}: ${count} files, ${JSON.stringify(outcomes)}, grew by at most ${most.toFixed()} MB`,
  );
}

/** The type of the event that ends the load, or the code of the error. */
export function load(viewer: ViewerLocator, src: string): Promise<string> {
  return viewer.evaluate(
    (element, [address, patience]) =>
      new Promise<string>((resolve) => {
        const end = (outcome: string) => {
          clearTimeout(late);
          element.removeEventListener('load', loaded);
          element.removeEventListener('error', failed);
          void element.ready.then(() => resolve(outcome));
        };
        const loaded = () => end('load');
        const failed = (event: Event) => end((event as CustomEvent<{ code: string }>).detail.code);
        const late = setTimeout(() => resolve('hangs'), patience);
        element.addEventListener('load', loaded);
        element.addEventListener('error', failed);
        element.src = address;
      }),
    [src, HANG_MS] as const,
  );
}

/** A small picture as text. */
function pictureOf(viewer: ViewerLocator) {
  return viewer.evaluate(async (element) => {
    const blob = await element.toBlob({ width: 30, height: 20 });
    return String.fromCharCode(...new Uint8Array(await blob.arrayBuffer()));
  });
}

/**
 * Resident memory of the browser's renderer and GPU processes, in MB, sampled 40 times a second.
 */
export class MemoryWatch {
  readonly #processes: readonly number[];
  #timer: NodeJS.Timeout | undefined;
  #base = 0;
  #most = 0;

  constructor(processes: readonly number[]) {
    this.#processes = processes;
  }

  static async of(browser: Browser): Promise<MemoryWatch> {
    const session = await browser.newBrowserCDPSession();
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    await session.detach();
    return new MemoryWatch(
      processInfo.filter(({ type }) => /renderer|gpu/i.test(type)).map(({ id }) => id),
    );
  }

  start(): void {
    this.#base = this.#most = this.#read();
    this.#timer = setInterval(() => (this.#most = Math.max(this.#most, this.#read())), 25);
  }

  /** Largest growth since the start. */
  stop(): number {
    clearInterval(this.#timer);
    return Math.max(this.#most, this.#read()) - this.#base;
  }

  #read() {
    let kilobytes = 0;
    for (const id of this.#processes) {
      try {
        kilobytes += Number(
          /VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1] ?? 0,
        );
      } catch {
        // Ended, or another system.
      }
    }
    return kilobytes / 1024;
  }
}
