// The playground: what is written is shown, what is changed in the picture is written, and both are
// in the address.
import '../page.js';
import { markupIn } from 'phong-viewer/still/markup';
import { markupOf } from '../parts/markup.js';
import { fragmentOf, readFragment } from './address.js';
import type { Editor } from './editor.js';
import { EXAMPLES } from './examples.js';
import { forgetCurrent, hearFailures, hearRemarks, remarksOn } from './remarks.js';
import { readScene, sceneElement, sourcesOf, withoutHosts, type Scene } from './scene.js';
import { showScene } from './show.js';

/**
 * Milliseconds without a keystroke before the scene is in the address, and before a new file is
 * fetched: the address of one is typed letter by letter.
 */
const ADDRESS_MS = 400;
/** Milliseconds without a change in the picture before it is written into the markup. */
const SETTLE_MS = 300;
const part = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const viewer = part<HTMLElementTagNameMap['phong-viewer']>('scene');
const picture = viewer.parentElement!;
const gate = part('gate');
const choice = part<HTMLSelectElement>('example');
const area = part<HTMLTextAreaElement>('text');

let text = '';
/** The scene that the viewer shows; null before the first. */
let shown: Scene | null = null;
/**
 * The viewer's own markup of that scene. Other markup means that the user has changed something in
 * the picture.
 */
let shownMarkup = '';
/** Origins that the user has allowed on this page. */
const allowed = new Set<string>();
let editor: Editor | null = null;

// -- From the text to the picture
// -------------------------------------------------------------------------------------------------

/** The timer of a text whose new files are not fetched yet; 0 for none. */
let typing = 0;

/** @param typed whether someone is writing: then new files wait for a pause. */
function write(next: string, typed = false): void {
  clearTimeout(typing);
  typing = 0;
  text = next;
  forgetCurrent();
  const scene = readScene(text, document.baseURI);
  if (typeof scene === 'string') {
    say([scene]);
    return;
  }
  say(scene.leftOut);
  const waiting = scene.hosts.filter((host) => !allowed.has(host));
  askFor(waiting);
  const permitted = withoutHosts(scene, allowed, document.baseURI);
  const present = new Set(shown === null ? [] : sourcesOf(shown));
  if (typed && sourcesOf(permitted).some((source) => !present.has(source))) {
    typing = window.setTimeout(() => write(text), ADDRESS_MS);
    return;
  }
  touched = false;
  showScene(viewer, shown, permitted);
  shown = permitted;
  shownMarkup = liveMarkup();
}

/** Of the viewer, or of the comparison that it is in. */
const liveMarkup = (): string => (viewer.closest('phong-compare') ?? viewer).toHTML();

/** What the page itself says of the text. */
let said: readonly string[] = [];

function say(messages: readonly string[]): void {
  said = messages;
  report();
}

/** Shows what the page and the package say, and marks the values in the text. */
function report(): void {
  const remarks = remarksOn(text);
  const all = remarks.map(({ sentence, place }) =>
    place === null
      ? sentence
      : `Line ${String(text.slice(0, place.from).split('\n').length)}: ${sentence}`,
  );
  editor?.mark(remarks.flatMap(({ place }) => place ?? []));
  const items = [...said, ...all].map((message) => {
    const item = document.createElement('li');
    item.textContent = message;
    return item;
  });
  const list = part('messages');
  // Screen readers would read the same sentences again.
  if (items.map((item) => item.outerHTML).join('') !== list.innerHTML) {
    list.replaceChildren(...items);
  }
}

hearRemarks(report);
hearFailures(picture, report);

/** Shows a question with one button, or nothing if no host waits. */
function askFor(hosts: readonly string[]): void {
  gate.hidden = hosts.length === 0;
  const question = document.createElement('p');
  question.textContent = `This scene wants to load files from ${hosts.slice(0, 3).join(', ')}${hosts.length > 3 ? ` and ${String(hosts.length - 3)} more` : ''}.`;
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'Load them';
  button.addEventListener('click', () => {
    for (const host of hosts) {
      allowed.add(host);
    }
    write(text);
  });
  gate.replaceChildren(...(hosts.length === 0 ? [] : [question, button]));
}

// -- From the picture to the text
// -------------------------------------------------------------------------------------------------

/** Whether the user has touched the picture since the text was shown. */
let touched = false;
/** Whether a press that began in the picture lasts: a whole drag is one change of the markup. */
let pressed = false;
let settling = 0;

function settle(): void {
  clearTimeout(settling);
  if (touched && !pressed) {
    settling = window.setTimeout(writeBack, SETTLE_MS);
  }
}

function writeBack(): void {
  // Files that wait for a click or a pause are not in the viewer, and so not in its markup.
  if (!gate.hidden || typing !== 0) return;
  const markup = liveMarkup();
  if (markup === shownMarkup) return;
  const scene = readScene(markup, document.baseURI);
  if (typeof scene === 'string') return;
  shown = scene;
  shownMarkup = markup;
  text = written(scene);
  area.value = text;
  editor?.setText(text);
  report();
  remember();
}

for (const type of ['pointerdown', 'keydown', 'wheel', 'input', 'drop'] as const) {
  const noteTouch = (): void => {
    touched = true;
    if (type === 'pointerdown') {
      pressed = true;
    }
    settle();
  };
  // Before the viewer, which keeps the keys that it uses.
  picture.addEventListener(type, noteTouch, { passive: true, capture: true });
}
for (const type of ['pointerup', 'pointercancel', 'blur'] as const) {
  addEventListener(type, () => {
    pressed = false;
    settle();
  });
}
viewer.addEventListener('light-change', settle);
viewer.addEventListener('camera-change', ({ detail: { source } }) => {
  if (source !== 'auto') {
    settle();
  }
});
// Meshes and shading have no event of their own; while the camera turns by itself, frames say
// nothing.
viewer.addEventListener('render', () => {
  if (viewer.autoRotate === 0) {
    settle();
  }
});

// -- The address
// -------------------------------------------------------------------------------------------------

let remembering = 0;

function remember(): void {
  clearTimeout(remembering);
  remembering = window.setTimeout(() => void putInAddress(), ADDRESS_MS);
}

async function putInAddress(): Promise<void> {
  clearTimeout(remembering);
  const now = text;
  const example = EXAMPLES.find((e) => textOf(e.text) === now);
  choice.value = example?.name ?? '';
  const fragment = example === undefined ? await fragmentOf(now) : `#example=${example.name}`;
  if (now === text) {
    history.replaceState(null, '', fragment);
  }
}

async function open(): Promise<void> {
  const addressed = await readFragment(location.hash);
  if (addressed !== null && 'text' in addressed) {
    start(addressed.text);
    return;
  }
  const name = addressed !== null && 'example' in addressed ? addressed.example : 'room';
  const example = EXAMPLES.find((e) => e.name === name);
  start(textOf((example ?? EXAMPLES[0]!).text));
  if (addressed !== null && 'fault' in addressed) {
    say([addressed.fault]);
  } else if (example === undefined) {
    say(['There is no example of this name.']);
  }
}

/** Shows a text that did not come from the editor. */
function start(given: string): void {
  // The editor's lines end so: places in the text are the same in both.
  const next = given.replaceAll(/\r\n?/g, '\n');
  choice.value = EXAMPLES.find((e) => textOf(e.text) === next)?.name ?? '';
  area.value = next;
  editor?.setText(next);
  // The camera and values that the user has moved belong to the scene before.
  viewer.resetCamera();
  write(next);
}

/** An example as the playground writes markup: several attributes on a line, and with the panel. */
function textOf(source: string): string {
  const scene = readScene(source.replace(/^<phong-viewer/, '<phong-viewer gui'), document.baseURI);
  return typeof scene === 'string' ? source : written(scene);
}

/** Characters per line of markup that the page writes: as many as the field shows, 76 at most. */
const lineLength = (): number => Math.min(76, Math.floor((part('editor').clientWidth - 40) / 7.9));

/** The scene as markup. */
function written(scene: Scene): string {
  const element = sceneElement(scene);
  const pieces = element === null ? [] : markupOf(element, lineLength());
  return `${pieces.map((piece) => piece.text).join('')}\n`;
}

// -- Pictures that hold a scene
// -------------------------------------------------------------------------------------------------

/** The scene of a dropped picture is text like any other; other files are the viewer's. */
for (const type of ['dragover', 'drop'] as const) {
  picture.addEventListener(
    type,
    (event) => {
      const { dataTransfer } = event;
      const item = [...(dataTransfer?.items ?? [])].find((one) => one.type === 'image/png');
      if (item === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      const file = item.getAsFile();
      if (type === 'drop' && file !== null) {
        void openPicture(file);
      }
    },
    { capture: true },
  );
}

async function openPicture(file: File): Promise<void> {
  try {
    start(await markupIn(file));
    remember();
  } catch (error) {
    say([(error as Error).message]);
  }
}

// -- The page
// -------------------------------------------------------------------------------------------------

const typed = (next: string): void => {
  write(next, true);
  remember();
};

choice.append(
  new Option('your own', ''),
  ...EXAMPLES.map(({ name, title }) => new Option(title, name)),
);
choice.addEventListener('change', () => {
  if (choice.value !== '') {
    location.hash = `#example=${choice.value}`;
  }
});
area.addEventListener('input', () => typed(area.value));
addEventListener('hashchange', () => void open());
/** A button that puts the scene somewhere else, and says where. A failure is a sentence too. */
function sharing(id: string, share: (scene: Scene) => Promise<string>): void {
  part(id).addEventListener('click', () => {
    const said = part<HTMLOutputElement>('shared');
    if (shown === null) return;
    share(shown).then(
      (words) => (said.textContent = words),
      (error: unknown) =>
        (said.textContent = error instanceof Error ? error.message : String(error)),
    );
  });
}

async function copied(words: string, otherwise: string): Promise<string> {
  try {
    await navigator.clipboard.writeText(words);
    return 'Copied.';
  } catch {
    return otherwise;
  }
}

sharing('link', async () => {
  await putInAddress();
  return copied(location.href, 'The link is in the address bar.');
});
sharing('frame', async (scene) => {
  const { frameOf } = await import('./share.js');
  const frame = await frameOf(scene, document.baseURI);
  return copied(frame, frame);
});
sharing('file', async (scene) => {
  const { fileOf } = await import('./share.js');
  const file = URL.createObjectURL(
    new Blob([await fileOf(scene, document.baseURI)], { type: 'text/html' }),
  );
  const anchor = document.createElement('a');
  anchor.href = file;
  anchor.download = 'scene.html';
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(file), 60_000);
  return 'Saved as scene.html.';
});

await open();
// The first picture comes first, not the converged one. The text can be changed in the plain field
// until then.
await Promise.race([
  viewer.ready,
  new Promise((resolve) => viewer.addEventListener('render', resolve, { once: true })),
]);
const { startEditor } = await import('./editor.js');
const focused = document.activeElement === area;
editor = startEditor(part('editor'), text, typed);
report();
if (focused) {
  part('editor').querySelector<HTMLElement>('.host')?.focus();
}
