// The page of the bench: measures the fronts of time against error in the visitor's browser, and
// shows them as tables. ?seconds=20 measures each front for longer or shorter.
import '../page.js';
import { FRONTS } from '../../tests/bench/front/front.js';
import { type FrontTable, measureFront, rendererHere, type TableRow } from './measure.js';

const part = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const start = part<HTMLButtonElement>('start');
const copy = part<HTMLButtonElement>('copy');
const bar = part<HTMLProgressElement>('bar');
const state = part('state');
const easel = part('easel');
const fronts = part('fronts');

/** For each front. A slow machine takes longer. */
const SECONDS = Number(new URLSearchParams(location.search).get('seconds') ?? 8);

let running: AbortController | null = null;
let tables: FrontTable[] = [];

try {
  part('renderer').textContent = rendererHere();
} catch (error) {
  say(`Nothing can be measured here: ${messageOf(error)}.`);
  start.disabled = true;
}

start.addEventListener('click', () => {
  if (running === null) {
    void run();
  } else {
    running.abort();
  }
});
copy.addEventListener('click', () => void copyResult());

async function run(): Promise<void> {
  running = new AbortController();
  const { signal } = running;
  start.textContent = 'Stop';
  copy.disabled = true;
  bar.hidden = easel.hidden = false;
  bar.value = 0;
  fronts.replaceChildren();
  tables = [];
  const begun = performance.now();
  try {
    for (const [i, name] of FRONTS.entries()) {
      const section = document.createElement('section');
      section.className = 'front';
      const holder = easel.querySelector<HTMLElement>('.canvas')!;
      tables[i] = await measureFront(holder, name, 1000 * SECONDS, signal, (table, done) => {
        bar.value = (i + done) / FRONTS.length;
        say(`Measuring ${table.title}`);
        section.replaceChildren(element('h2', table.title), tableOf(table.rows));
        if (!section.isConnected) {
          fronts.append(section);
        }
      });
    }
    say(`Done in ${((performance.now() - begun) / 1000).toFixed(0)} seconds.`);
    copy.disabled = false;
  } catch (error) {
    if (signal.aborted) {
      say('Stopped.');
    } else {
      say(`It ended early: ${messageOf(error)}.`);
      console.error(error);
    }
  } finally {
    running = null;
    bar.hidden = easel.hidden = true;
    start.textContent = 'Measure again';
  }
}

function tableOf(rows: readonly TableRow[]): HTMLElement {
  const scroll = element('div', '', 'scroll');
  const table = element('table', '', 'numbers');
  const head = document.createElement('thead');
  head.append(rowOf(['variant', 'time', 'ms', 'RMSE', '99.9 %', 'largest error'], 'th'));
  const body = document.createElement('tbody');
  for (const { label, ratio, ms, error } of rows) {
    const figures = [error.rmse, error.p999, error.max].map((x) =>
      x === 0 ? '0' : x.toPrecision(2),
    );
    body.append(rowOf([label, ratio.toFixed(2), ms.toPrecision(3), ...figures], 'td'));
  }
  table.append(head, body);
  scroll.append(table);
  return scroll;
}

function rowOf([first = '', ...others]: readonly string[], tag: 'th' | 'td'): HTMLTableRowElement {
  const row = document.createElement('tr');
  row.append(element('th', first), ...others.map((text) => element(tag, text)));
  return row;
}

function element(tag: string, text: string, className = ''): HTMLElement {
  const made = document.createElement(tag);
  made.textContent = text;
  if (className !== '') {
    made.className = className;
  }
  return made;
}

function say(what: string): void {
  if (state.textContent !== what) {
    state.textContent = what;
  }
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

async function copyResult(): Promise<void> {
  const text = JSON.stringify(
    { renderer: part('renderer').textContent, browser: navigator.userAgent, tables },
    null,
    1,
  );
  try {
    await navigator.clipboard.writeText(text);
    say('Copied.');
  } catch {
    const box = part<HTMLTextAreaElement>('json');
    box.hidden = false;
    box.value = text;
    box.select();
    say('This browser does not let pages copy: the result is below, selected.');
  }
}
