// The page of the bench: starts and stops it, draws its fronts as they grow, and hands the result on.
// ?only=loops,scale&seconds=20 measures some fronts, and longer or shorter.
import '../page.js';
import { frontChart, PAGE } from '../../tests/bench/chart.mjs';
import type { BenchResult } from '../../tests/bench/result-file.mjs';
import { dominated, type Front } from '../../tests/bench/front.mjs';
import { measure, rendererHere, type Wanted } from './measure.js';

const part = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const start = part<HTMLButtonElement>('start');
const copy = part<HTMLButtonElement>('copy');
const bar = part<HTMLProgressElement>('bar');
const state = part('state');
const easel = part('easel');
const fronts = part('fronts');

/** Charts are this high where there is room, and higher than wide where there is little. */
const CHART = { height: 440, narrowHeight: 380, narrow: 520 } as const;

let running: AbortController | null = null;
let result: BenchResult | null = null;
const shown = new Map<string, Front>();

try {
  part('renderer').textContent = rendererHere();
} catch (error) {
  state.textContent = `Nothing can be measured here: ${error instanceof Error ? error.message : String(error)}.`;
  start.disabled = true;
}

start.addEventListener('click', () => {
  if (running === null) void run();
  else running.abort();
});

copy.addEventListener('click', () => {
  void copyResult();
});

async function run(): Promise<void> {
  running = new AbortController();
  start.textContent = 'Stop';
  copy.disabled = true;
  bar.hidden = false;
  easel.hidden = false;
  shown.clear();
  fronts.replaceChildren();
  const begun = performance.now();
  try {
    const canvas = easel.querySelector<HTMLElement>('.canvas')!;
    result = await measure(canvas, { progress, front: show }, running.signal, wanted());
    say(`Done in ${((performance.now() - begun) / 1000).toFixed(0)} seconds.`);
    copy.disabled = false;
  } catch (error) {
    if (running.signal.aborted) say('Stopped.');
    else {
      say(`It ended early: ${error instanceof Error ? error.message : String(error)}.`);
      console.error(error);
    }
  } finally {
    running = null;
    bar.hidden = true;
    easel.hidden = true;
    start.textContent = 'Measure again';
  }
}

/** What the address asks for. */
function wanted(): Wanted {
  const query = new URLSearchParams(location.search);
  const seconds = Number(query.get('seconds'));
  return { only: query.get('only')?.split(',') ?? [], ...(seconds > 0 ? { seconds } : {}) };
}

function progress(share: number, what: string): void {
  bar.value = share;
  if (state.textContent !== what) say(what);
}

function say(what: string): void {
  state.textContent = what;
}

/** Draws a front, anew or for the first time. */
function show(front: Front): void {
  shown.set(front.axis, front);
  let section = document.getElementById(`front-${front.axis}`);
  if (section === null) {
    section = document.createElement('section');
    section.className = 'front';
    section.id = `front-${front.axis}`;
    section.append(element('h2', front.title), element('div', '', 'chart'), tableOf());
    fronts.append(section);
  }
  draw(section, front);
}

function draw(section: HTMLElement, front: Front): void {
  const chart = section.querySelector<HTMLElement>('.chart')!;
  const width = Math.max(Math.round(chart.clientWidth), 280);
  const height = width < CHART.narrow ? CHART.narrowHeight : CHART.height;
  const text = frontChart(front, { width, height, colors: PAGE, title: '' });
  const svg = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  chart.replaceChildren(document.importNode(svg, true));
  section.querySelector('tbody')!.replaceChildren(...rowsOf(front));
}

new ResizeObserver(() => {
  for (const [axis, front] of shown) {
    const section = document.getElementById(`front-${axis}`);
    if (section !== null) draw(section, front);
  }
}).observe(fronts);

function tableOf(): HTMLDetailsElement {
  const details = document.createElement('details');
  details.className = 'source';
  details.append(element('summary', 'The numbers'));
  const scroll = element('div', '', 'scroll');
  const table = element('table', '', 'numbers');
  const head = document.createElement('thead');
  const row = document.createElement('tr');
  for (const title of ['variant', 'time', 'ms', 'RMSE', '99.9 %', 'largest', 'codes', 'ΔE', 'FLIP'])
    row.append(element('th', title));
  head.append(row);
  table.append(head, document.createElement('tbody'));
  scroll.append(table);
  details.append(scroll);
  return details;
}

const digits = (x: number): string => (x === 0 ? '0' : x.toPrecision(2));

function rowsOf(front: Front): HTMLTableRowElement[] {
  const pointless = dominated(front.points);
  return front.points.map(({ id, label, time, ratio, error }) => {
    const row = document.createElement('tr');
    if (pointless.has(id)) row.className = 'pointless';
    const cells = [
      ratio.median.toFixed(2),
      time.median.toPrecision(3),
      ...[error.rmse, error.p999, error.max].map(digits),
      `${(100 * error.share).toPrecision(2)} %`,
      ...[error.deltaE, error.flip].map(digits),
    ];
    row.append(element('th', label), ...cells.map((text) => element('td', text)));
    return row;
  });
}

function element(tag: string, text: string, className = ''): HTMLElement {
  const made = document.createElement(tag);
  made.textContent = text;
  if (className !== '') made.className = className;
  return made;
}

async function copyResult(): Promise<void> {
  const text = JSON.stringify(result, null, 1);
  try {
    await navigator.clipboard.writeText(text);
    say('Copied.');
  } catch {
    // Not allowed here: shown, to be copied by hand.
    const box = part<HTMLTextAreaElement>('json');
    box.hidden = false;
    box.value = text;
    box.select();
    say('The browser does not let pages copy here: the result stands below, selected.');
  }
}
