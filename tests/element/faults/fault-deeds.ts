// Performs the steps of a history of faults in the page, and ends all faults.

import type { Step } from '../histories/history-deeds.js';
import type { Opening } from './faults.js';
import type { PhongViewer } from '../support/viewer.js';

interface FaultDeeds {
  take(step: Step): void;
  /** Ends every fault and waits until each viewer is ready. Returns what did not settle, or ''. */
  heal(): Promise<string>;
  /** What the page holds although it should not, or ''. */
  leaks(): Promise<string>;
}

declare global {
  interface Window {
    faultDeeds: FaultDeeds;
  }
}

/** Runs in the page, after `installFaults`. */
export function installFaultDeeds(): void {
  const MOST_VIEWERS = 3;
  /** Milliseconds after which a promise counts as never settled. */
  const LATE = 20_000;
  const { faults } = window;
  const away: PhongViewer[] = [];
  const promises = new Map<Promise<unknown>, string>();
  let visibility: DocumentVisibilityState = 'visible';
  Object.defineProperty(document, 'visibilityState', { configurable: true, get: () => visibility });

  const viewers = () => [...document.querySelectorAll<PhongViewer>('phong-viewer')];
  const wait = (ms: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, ms));
  /** Promises may reject here, but they must settle. */
  const keep = (promise: Promise<unknown>, what: string) => {
    const settled = promise
      .catch(() => undefined)
      .then(() => {
        promises.delete(settled);
      });
    promises.set(settled, what);
  };
  const setVisibility = (state: DocumentVisibilityState) => {
    visibility = state;
    document.dispatchEvent(new Event('visibilitychange'));
  };
  const resize = (viewer: PhongViewer, size: string) => {
    const [width, height] = size.split(' ');
    viewer.style.width = size === '' ? '' : `${width}px`;
    viewer.style.height = size === '' ? '' : `${height}px`;
  };
  const numbers = (value: string) => value.split(' ').map(Number) as [number, number];

  const anywhere: Readonly<Record<string, (value: string) => void>> = {
    lose: () => faults.lose(),
    restore: () => faults.restore(),
    'lose after calls': (value) => (faults.callsLeft = Number(value)),
    opening: (value) => (faults.opening = value as Opening),
    hide: () => setVisibility('hidden'),
    show: () => setVisibility('visible'),
    print: () => {
      dispatchEvent(new Event('beforeprint'));
      dispatchEvent(new Event('afterprint'));
    },
    'bring back': () => {
      const viewer = away.shift();
      if (viewer !== undefined) {
        document.body.prepend(viewer);
      }
    },
    'another viewer': (value) => {
      if (viewers().length + away.length < MOST_VIEWERS) {
        document.body.insertAdjacentHTML('beforeend', value);
      }
    },
  };
  const toOne: Readonly<Record<string, (viewer: PhongViewer, step: Step) => void>> = {
    'take away': (viewer) => {
      away.push(viewer);
      viewer.remove();
    },
    size: (viewer, { value }) => resize(viewer, value),
    picture: (viewer, { value }) => {
      const [width, height] = numbers(value);
      keep(viewer.toBlob({ width, height }), `toBlob ${value}`);
    },
    explain: (viewer, { value }) => keep(viewer.shadeAt(...numbers(value)), `shadeAt ${value}`),
    ready: (viewer) => keep(viewer.ready, 'ready'),
    draw: (viewer) => viewer.requestRender(),
    set: (viewer, { key, value }) => {
      Reflect.set(viewer, key, key === 'geometry' && value === '' ? null : value);
    },
  };

  function take(step: Step) {
    anywhere[step.what]?.(step.value);
    const all = viewers();
    const viewer = all[step.viewer % Math.max(all.length, 1)];
    if (viewer !== undefined) {
      toOne[step.what]?.(viewer, step);
    }
  }

  async function heal() {
    faults.callsLeft = Infinity;
    faults.opening = 'works';
    for (const viewer of away.splice(0)) {
      document.body.append(viewer);
    }
    for (const viewer of viewers()) {
      resize(viewer, '');
      viewer.gui = false;
      viewer.autoRotate = 0;
      if (viewer.src === '/nowhere.glb') {
        viewer.src = '';
      }
    }
    setVisibility('visible');
    // The event of a context that was lost just now has to arrive first.
    for (let time = 0; time < 3; time++) {
      await wait(60);
      faults.restore();
    }
    await wait(60);
    // The next use fetches again what could not be fetched.
    for (const viewer of viewers()) {
      const { src, geometry } = viewer;
      for (const element of [viewer, ...viewer.meshes]) {
        const { geometry } = element;
        element.geometry = null;
        element.geometry = geometry;
      }
      if (src !== '') {
        viewer.src = src;
      }
      if (src === '' && geometry === null && viewer.meshes.length === 0) {
        viewer.geometry = 'box';
      }
    }
    for (const viewer of viewers()) {
      keep(viewer.ready, 'ready at the end');
    }
    const settled = Promise.all(promises.keys()).then(() => '');
    const late = wait(LATE).then(() => `never settled: ${[...promises.values()].join()}`);
    const outcome = await Promise.race([settled, late]);
    const notices = viewers().map(
      ({ shadowRoot }) => shadowRoot?.querySelector('[part=notice]')?.textContent ?? '',
    );
    return [outcome, ...notices].filter((text) => text !== '').join('; ');
  }

  async function leaks() {
    const found: string[] = [];
    const expect = (what: string, actual: number, wanted: number) => {
      if (actual !== wanted) {
        found.push(`${actual} ${what}, not ${wanted}`);
      }
    };
    const all = viewers();
    const canvases = all.flatMap(({ shadowRoot }) => [...shadowRoot!.querySelectorAll('canvas')]);
    expect('contexts are open', faults.open, 1);
    expect('canvases', canvases.length, all.length);
    expect('programs on the GPU', faults.programs, all[0]?.stats.programs ?? 0);
    for (const viewer of all) {
      viewer.remove();
    }
    await wait(20);
    expect('contexts are open without viewers', faults.open, 0);
    expect(
      'viewers hold a canvas outside the page',
      all.filter(({ shadowRoot }) => shadowRoot?.querySelector('canvas')).length,
      0,
    );
    return found.join('; ');
  }

  window.faultDeeds = { take, heal, leaks };
}
