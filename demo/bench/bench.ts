// The page of the bench: measures in the visitor's browser what accuracy costs, and shows it as a
// sentence, a plot and a table; below, the same of named machines. ?seconds=20 measures each
// exponent for longer or shorter, ?exponent=32 that one only.
import '../page.js';
import {
  type Accuracy,
  ACCURACY_HEAD,
  accuracyRows,
  accuracySentence,
  EXPONENTS,
  placeOf,
} from '../../tests/bench/accuracy-words.mjs';
import { accuracyPlot } from '../../tests/bench/accuracy-chart.mjs';
import { measureAccuracy, rendererHere } from './measure.js';

/** What was measured on named machines, by the names of the files. */
const recorded = Object.entries(
  import.meta.glob<Accuracy>('../../tests/bench/accuracy/*.json', {
    eager: true,
    import: 'default',
  }),
).map(([file, accuracy]) => ({ place: placeOf(/([\w-]+)\.json$/.exec(file)![1]!), accuracy }));

const part = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const start = part<HTMLButtonElement>('start');
const copy = part<HTMLButtonElement>('copy');
const bar = part<HTMLProgressElement>('bar');
const state = part('state');
const easel = part('easel');
const here = part('here');
const machines = part('machines');
const box = part<HTMLTextAreaElement>('json');

/** For each exponent. A slow machine takes longer. */
const asked = new URLSearchParams(location.search);
const SECONDS = Number(asked.get('seconds') ?? 8);
const exponents = EXPONENTS.filter((exponent) => {
  return String(exponent) === (asked.get('exponent') ?? String(exponent));
});

/** Plots are drawn anew for the width that there is: their letters keep their size. */
const plots = new Map<Element, Accuracy>();
const sizes = new ResizeObserver((entries) => {
  for (const { target } of entries) {
    draw(target);
  }
});

/** Until then the place of this machine's plot has that of another one. */
let hasMeasured = false;
let running: AbortController | null = null;
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

const [example, ...others] = recorded;
if (example !== undefined) {
  show(here, example.accuracy, example.place);
}
others.forEach(showBelow);

/** Adds the plot of another machine. */
function showBelow({ accuracy, place }: (typeof recorded)[number]): void {
  const section = element('section', '', 'front');
  machines.append(section);
  show(section, accuracy, place);
}

async function run(): Promise<void> {
  running = new AbortController();
  const { signal } = running;
  start.textContent = 'Stop';
  copy.disabled = true;
  bar.hidden = easel.hidden = false;
  bar.value = 0;
  const begun = performance.now();
  const holder = easel.querySelector<HTMLElement>('.canvas')!;
  try {
    const accuracy = await measureAccuracy(holder, 1000 * SECONDS, exponents, signal, (_, done) => {
      bar.value = done;
      say(`Measuring: ${(100 * done).toFixed(0)} %`);
    });
    show(here, accuracy);
    if (example !== undefined && !hasMeasured) {
      showBelow(example);
    }
    hasMeasured = true;
    box.value = JSON.stringify(accuracy, null, 1);
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

/** Fills a place with what was measured on one machine. */
function show(place: HTMLElement, accuracy: Accuracy, where?: string): void {
  const plot = element('div', '', 'plot');
  place.replaceChildren(element('p', accuracySentence(accuracy, where)), plot, tableOf(accuracy));
  plots.set(plot, accuracy);
  draw(plot);
  sizes.observe(plot);
}

function draw(plot: Element): void {
  const accuracy = plots.get(plot);
  if (accuracy === undefined) return;
  if (!plot.isConnected) {
    plots.delete(plot);
    sizes.unobserve(plot);
    return;
  }
  const width = Math.min(760, Math.floor(plot.clientWidth));
  // None before the page is laid out, and where the plot is hidden.
  if (width === 0) return;
  plot.replaceChildren(accuracyPlot(accuracy, width, document));
}

function tableOf(accuracy: Accuracy): HTMLElement {
  const scroll = element('div', '', 'scroll');
  const table = element('table', '', 'numbers');
  const head = document.createElement('thead');
  head.append(rowOf(['way to write it', ...ACCURACY_HEAD], 'th'));
  const body = document.createElement('tbody');
  for (const { label, about, cells } of accuracyRows(accuracy)) {
    const row = rowOf([label, ...cells], 'td');
    row.firstElementChild!.append(element('small', about));
    body.append(row);
  }
  table.append(head, body);
  scroll.append(table);
  scroll.tabIndex = 0;
  scroll.setAttribute('role', 'region');
  scroll.setAttribute('aria-label', `Time and error: ${accuracy.renderer}`);
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
  try {
    await navigator.clipboard.writeText(box.value);
    say('Copied.');
  } catch {
    box.hidden = false;
    box.select();
    say('This browser does not let pages copy: the result is below, selected.');
  }
}
