/**
 * `phong-viewer/lazy`: viewers stand still with their posters until somebody wants more of one. Then
 * it fetches the elements. It is all the script that a page has before, so it is short and imports
 * nothing.
 */
import type * as exported from '../../viewer/index.js';

type Elements = typeof exported;
type Viewer = InstanceType<Elements['PhongViewer']>;

const VIEWER = 'phong-viewer';

const UNDEFINED = ':not(:defined)';

const POSTER = '[slot=poster]';

/** What the elements have to be fetched for: viewers, and what shows nothing without them. */
const STILL = `:is(${VIEWER},phong-compare,phong-control,phong-probe,phong-exercise)${UNDEFINED}`;

/**
 * Attributes of viewers that move, or show something that a poster does not, as the browser writes
 * them. Models in them may move too.
 */
const LIVELY = / (auto-rotate|autoplay|camera-group|gui|helpers|probe)="(?!false|0")/;

const HOST = `:where(${VIEWER}${UNDEFINED})`;

/** The box that the element will have itself. Any rule of the page is stronger. */
const BOX =
  `${HOST}{display:inline-block;width:300px;aspect-ratio:2;contain:strict;touch-action:pan-y;-webkit-user-select:none}` +
  `${HOST}>${POSTER}{position:absolute;inset:0;width:100%;max-width:none;height:100%;object-fit:contain;pointer-events:none}` +
  // From 640 pixels on a panel of 306 lies beside the picture; see phong-viewer.css.
  `${HOST}[gui]:not([gui=false])>${POSTER}{width:clamp(100% - 306px,64e6px - 1e7%,100%)}`;

/** The end, the moves and the release of a drag that has begun, then what asks for the elements. */
const EVENTS = 'pointercancel,pointermove,pointerup,pointerdown,pointerover,focusin,keydown'.split(
  ',',
);

/** A drag that began before the elements were there: its press, newest move and end. */
let held: PointerEvent[] = [];
let heldOn: Viewer | undefined;

/** Viewers that the keyboard reaches by an attribute that is not the page's. */
const lent: Element[] = [];

let elements: Promise<Elements> | null = null;

/**
 * Fetches the elements, once. Rejects if they cannot be fetched: then the posters stay, and the next
 * call tries again.
 */
export function load(): Promise<Elements> {
  elements ??= import('../../viewer/index.js').then(leave);
  elements.catch(() => (elements = null));
  return elements;
}

/** Short names of what is used often. Servers have neither. */
const { document: page, IntersectionObserver: Near } = globalThis as {
  readonly document: Document;
  readonly IntersectionObserver?: typeof IntersectionObserver;
};

const near =
  Near &&
  new Near(
    (entries) => {
      if (entries.some((entry) => entry.isIntersecting)) {
        void load();
      }
    },
    { rootMargin: '100%' },
  );

/** Shows each poster, and finds what needs more than that. */
function prepare(): void {
  for (const element of page.querySelectorAll<HTMLElement>(STILL)) {
    if (element.localName === VIEWER) {
      const src = element.getAttribute('poster');
      let poster = element.querySelector<HTMLImageElement>(POSTER);
      if (src && !poster) {
        poster = Object.assign(new Image(), { slot: 'poster', src });
        element.prepend(poster);
      }
      if (poster) {
        // What it shows is said until the element says it.
        poster.alt ||= element.getAttribute('alt') ?? '';
        if (!LIVELY.test(element.outerHTML)) continue;
      }
    } else {
      for (const id of `${element.getAttribute('for')}`.split(' ')) {
        near!.observe(page.getElementById(id) ?? element);
      }
    }
    near!.observe(element);
  }
}

function hear(event: PointerEvent): void {
  const at = EVENTS.indexOf(event.type);
  const viewer = (event.composedPath() as Element[]).find((node) => node.localName === VIEWER);
  const asks = at > 2 && viewer?.matches(UNDEFINED);
  if (asks) {
    void load();
  }
  // A key, which comes after the focus.
  if (at > 5 && !elements) {
    // Before the key moves the focus: it can reach the viewers then.
    for (const unreached of page.querySelectorAll<HTMLElement>(`${VIEWER}:not([tabindex])`)) {
      unreached.tabIndex = 0;
      lent.push(unreached);
    }
  }
  // A press begins a drag.
  if (asks && at === 3) {
    held = [event];
    heldOn = viewer as Viewer;
  } else if (event.pointerId === held[0]?.pointerId) {
    if (at === 0) {
      held = [];
    } else if (at < 3 && !held[2]) {
      // A mouse goes on moving after its end.
      held[at] = event;
    }
  }
}

/** The elements are defined. */
function leave(module: Elements): Elements {
  const focused = page.activeElement as HTMLElement | null;
  for (const viewer of lent) {
    viewer.removeAttribute('tabindex');
  }
  if (focused?.localName === VIEWER) {
    focused.blur(); // a host that has the focus does not pass it on
    focused.focus();
  }
  heldOn?.addEventListener('render', turn);
  return module;
}

/** By what the pointer has moved meanwhile, once the camera fits the scene. */
function turn(this: Viewer): void {
  if (this.loaded) {
    const surface = this.shadowRoot!.querySelector('.surface')!;
    // It skips events that have not come.
    held.forEach((event) => surface.dispatchEvent(new PointerEvent(event.type, event)));
    held = [];
  }
}

if (near) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(BOX);
  page.adoptedStyleSheets.push(sheet);
  new MutationObserver(prepare).observe(page, { childList: true, subtree: true });
  prepare();
  for (const type of EVENTS) {
    page.addEventListener(type, hear as EventListener, true);
  }
}
