// What a <phong-control> does: it finds its elements and shows the row that the panel has for their
// value, in a line of text or alone. Loaded with the first one on a page.
import { GUI } from 'lil-gui';
import {
  addStyles,
  afterPictures,
  ExtraElement,
  historyOf,
  localNumber,
  type PhongViewer,
  phrase,
  type ViewerTexts,
} from '../../viewer/extra.js';
import { CONTROL_FIELDS, type ControlValues } from './control-fields.js';
import { clip } from '../../phong/fields/clip.js';
import { sameValue } from '../../phong/fields/field-store.js';
import { didYouMean } from '../../phong/fields/nearest.js';
import { bound, type Bound } from './bound.js';
import { rowOf, stepper } from './control-rows.js';
import styles from './control.css?inline';
import { LIGHT_ROWS } from './light-rows.js';
import { MESH_ROWS } from './mesh-rows.js';
import { declared, type Editable, type Rows, type Source, storeOf } from './rows.js';
import { SceneRange, type SliderScale } from './travel.js';
import { listenForUndo } from './undo.js';
import { VIEWER_ROWS } from './viewer-rows.js';
import { attributeOf } from '../../phong/fields/attribute-text.js';

export { takeRows } from './viewer-rows.js';

const ROWS = {
  'phong-viewer': VIEWER_ROWS,
  'phong-light': LIGHT_ROWS,
  'phong-mesh': MESH_ROWS,
} as unknown as Readonly<Record<string, Rows<Editable>>>;

/** Styles a control on a line of its own; one in a line of text flows as the text does. */
const LINE = `:host { display: block; writing-mode: horizontal-tb } ${ExtraElement.block}`;

class Control extends ExtraElement<ControlValues> {
  /** What is edited; empty while it is waited for. */
  #targets: readonly Editable[] | null = null;
  #texts: ViewerTexts | null = null;
  /** The texts of the viewer when the row was built. */
  #viewerTexts: Pick<PhongViewer, 'texts'> | null = null;
  #gui: GUI | null = null;
  #stops: (() => void)[] = [];
  /** Takes away the styles of a control on a line of its own. */
  #removeLine = (): void => undefined;
  /** Ids that an element has had. */
  readonly #met = new Set<string>();

  constructor(element: HTMLElement) {
    super(element, CONTROL_FIELDS, [styles]);
    Object.defineProperty(element, 'texts', { get: () => this.#texts }); // for the labels
  }

  protected override declared(): void {
    this.#targets = null;
    this.found();
  }

  protected override left(): void {
    this.#clear();
    this.#targets = null;
  }

  get #ids(): readonly string[] {
    return this.values.for.split(/\s+/).filter((id) => id !== '');
  }

  protected override found(): void {
    const found = this.#ids.map((id) => this.byId(id));
    for (const one of found) {
      if (one !== null) {
        this.#met.add(one.id);
      }
    }
    const targets = found.filter(
      (one) => one !== null && one.localName in ROWS && viewerOf(one) !== null,
    );
    const { en } = this.textsOf(this.#viewerTexts) ?? {};
    if (!sameValue(targets, this.#targets) || en !== this.#texts?.en) {
      this.#build(targets as Editable[]);
    }
  }

  protected override complain(): void {
    const { for: ids, attribute } = this.values;
    const tag = `<phong-control for="${clip(ids)}" attribute="${clip(attribute)}">`;
    if (ids.trim() === '') {
      this.warn(`${tag}: write for="…", the id of a viewer, a light or a mesh.`);
    }
    const present = Array.from(
      document.querySelectorAll(Object.keys(ROWS).join()),
      (one) => one.id,
    );
    for (const id of this.#ids) {
      const found = this.byId(id);
      const hint = didYouMean(id, present);
      if (found === null) {
        if (!this.#met.has(id)) {
          this.warn(`${tag}: no element has the id "${clip(id)}".${hint}`);
        }
      } else if (!(found.localName in ROWS)) {
        this.warn(
          `${tag}: <${found.localName} id="${clip(id)}"> is no viewer, light or mesh.${hint}`,
        );
      } else if (viewerOf(found) !== null && keyOf(found as Editable, attribute) === undefined) {
        const cure =
          didYouMean(attribute, attributesOf(found as Editable)) ||
          ' Write attribute="…", one of its attributes.';
        this.warn(`${tag}: <${found.localName}> has no attribute "${clip(attribute)}".${cure}`);
      }
    }
  }

  #clear(): void {
    for (const stop of this.#stops) {
      stop();
    }
    this.#stops = [];
    this.#gui?.destroy();
    this.#gui = null;
    this.root.replaceChildren(document.createElement('slot'));
  }

  #build(targets: readonly Editable[]): void {
    this.#clear();
    this.#targets = targets;
    const { attribute, component, values, min, max, step, type } = this.values;
    const having = targets.filter((target) => keyOf(target, attribute) !== undefined);
    const [element] = having;
    if (element === undefined) return;
    const key = keyOf(element, attribute)!;
    const viewer = viewerOf(element)!;
    this.#viewerTexts = { texts: viewer.texts };
    this.#texts = this.textsOf(this.#viewerTexts);
    const field = storeOf(element).fields[key]!;
    const own = ROWS[element.localName]![key] ?? null;
    const row = values !== '' ? stepper(key, field, values, own) : rowOf(key, field, own);
    const range = new SceneRange(viewer);
    const axis = component === null ? null : axisOf(component);
    const scale = (travel: SliderScale) => travel.within(min, max, step);
    const inText = type === null ? isInText(this.element) : type === 'number';
    const box = document.createElement('span');
    box.className = inText ? 'text' : 'line';
    this.#removeLine();
    if (!inText) {
      this.#removeLine = addStyles(this.root, LINE);
    }
    this.root.replaceChildren(box);
    const gui = (this.#gui = new GUI({ container: box, injectStyles: false }));
    const sources = having.map((target) => row.source?.(target) ?? declared(target, key));
    row.add(
      gui,
      { element, viewer, range, title: () => '', scale, axis },
      joined(having, sources) as never,
    );
    adaptRows(gui, key, this.element);
    this.#listen(gui, having, range);
  }

  #listen(gui: GUI, targets: readonly Editable[], range: SceneRange): void {
    const refresh = (): void => afterPictures(this.element, update);
    const update = (): void => {
      if (this.#gui !== gui) return;
      if (viewerOf(targets[0]!)?.texts !== this.#viewerTexts?.texts) {
        this.declared();
        return;
      }
      for (const control of gui.controllers) {
        control.updateDisplay();
      }
      updateWidthsAndPrint(gui, this.#texts);
    };
    const box = gui.domElement;
    for (const viewer of new Set(targets.map((target) => viewerOf(target)!))) {
      const events = new AbortController();
      const listen = (type: string, act: () => void): void =>
        viewer.addEventListener(type, act, { signal: events.signal });
      for (const type of ['camera-change', 'light-change', 'render']) {
        listen(type, refresh);
      }
      listen('load', () => range.expire());
      const updates = { hostUpdated: refresh };
      viewer.addController(updates);
      const history = historyOf(viewer);
      this.#stops.push(history.listen(refresh), listenForUndo(viewer, box, history), () => {
        events.abort('rebound');
        viewer.removeController(updates);
      });
    }
    box.addEventListener('input', () => updateWidthsAndPrint(gui, this.#texts));
    updateWidthsAndPrint(gui, this.#texts);
  }
}

const own = ExtraElement.codeOf('phong-control', CONTROL_FIELDS, Control);

export const follow = (element: HTMLElement): void => own(element).start();

const axisOf = (component: NonNullable<ControlValues['component']>): 0 | 1 | 2 =>
  ({ x: 0, y: 1, z: 2, kc: 0, kl: 1, kq: 2 } as const)[component];

/**
 * The viewer that shows `element`, through shadow trees; null if it is not defined yet or stands
 * outside of any.
 */
function viewerOf(element: Element): PhongViewer | null {
  if (!element.matches(':defined')) return null;
  const around = element.closest('phong-viewer:defined');
  const { host } = element.getRootNode() as Partial<ShadowRoot>;
  return around === null && host !== undefined ? viewerOf(host) : (around as PhongViewer | null);
}

const keysOf = (element: Editable): readonly string[] => Object.keys(storeOf(element).fields);

const attributesOf = (element: Editable): readonly string[] => keysOf(element).map(attributeOf);

const keyOf = (element: Editable, attribute: string): string | undefined =>
  keysOf(element).find((key) => attributeOf(key) === attribute.trim().toLowerCase());

/** Writes to all sources: one step for each viewer. Shows the first. */
function joined(elements: readonly Editable[], sources: readonly Source[]): Bound<unknown> {
  const viewers = elements.map((element) => viewerOf(element)!);
  const value: Bound<unknown> = bound(
    () => sources[0]!.get(),
    (next) => {
      for (const viewer of new Set(viewers)) {
        const own = sources.filter((_, i) => viewers[i] === viewer);
        const subjects = own.map(({ subject }) => subject);
        historyOf(viewer).edit(subjects, () => own.forEach((source) => source.set(next)), value);
      }
    },
  );
  return value;
}

/** The unit in a row's name, as it is written behind a number. */
const UNIT = /\s*°$/;

/**
 * What the panel's rows lack outside of it: parts, the author's label, units, and what is printed.
 */
function adaptRows(gui: GUI, key: string, element: HTMLElement): void {
  const rows = gui.controllers;
  const box = gui.domElement;
  const hasLabel = element.textContent.trim() !== '' || element.firstElementChild !== null;
  for (const { $name, $widget, domElement } of rows) {
    $name.part.add('label');
    for (const input of $widget.querySelectorAll<HTMLElement>('input, select, button, output')) {
      input.part.add('input');
    }
    if (domElement.classList.contains('lil-number')) {
      const behind = document.createElement('span');
      behind.part.add('unit');
      behind.textContent = key === 'autoRotate' ? '°/s' : UNIT.test($name.textContent) ? '°' : '';
      $name.textContent = $name.textContent.replace(UNIT, '');
      $widget.append(behind);
      const slider = $widget.querySelector<HTMLInputElement>('[type="range"]')!;
      slider.tabIndex = 0; // alone, without the panel's other rows to pass by
      const field = $widget.querySelector<HTMLInputElement>('.number')!;
      if (field.type === 'text') {
        field.role = 'spinbutton';
      }
    }
    const printed = document.createElement('span');
    printed.className = 'printed';
    domElement.append(printed);
  }
  if (!hasLabel) {
    box.classList.add('nameless');
    return;
  }
  let name = rows[0]!.$name;
  if (rows.length > 1) {
    name = document.createElement('span');
    name.id = 'label';
    name.part.add('label');
    box.role = 'group';
    box.setAttribute('aria-labelledby', name.id);
    box.prepend(name);
  }
  name.replaceChildren(document.createElement('slot'));
}

/**
 * After each change: the width of numbers, and the text for paper. There a number can only be read,
 * so it is written as the language writes it.
 */
function updateWidthsAndPrint(gui: GUI, texts: ViewerTexts | null): void {
  for (const { $widget, domElement } of gui.controllers) {
    const inputs = $widget.querySelectorAll<HTMLInputElement>(
      'output, select, input:not([type="range"], [type="color"])',
    );
    const said = Array.from(inputs, (input) => {
      if (input.classList.contains('number')) {
        input.style.setProperty('--digits', String(input.value.length));
        if (input.role === 'spinbutton') {
          input.ariaValueNow = input.value;
        }
        return localNumber(input.value, texts);
      }
      if (input.type === 'checkbox') return phrase(texts, input.checked ? 'on' : 'off');
      if (input.localName === 'select') {
        return (input as unknown as HTMLSelectElement).selectedOptions[0]?.text ?? '';
      }
      return input.value;
    });
    const unit = $widget.querySelector('[part="unit"]')?.textContent ?? '';
    domElement.querySelector('.printed')!.textContent = said.join(' ') + unit;
  }
}

/**
 * Whether text stands beside `element` in its line: in a neighbour, or around an inline parent, up
 * to a line break or a block.
 */
function isInText(element: Element): boolean {
  for (const side of ['previousSibling', 'nextSibling'] as const) {
    for (let node = element[side]; node !== null; node = node[side]) {
      if (node.nodeType === Node.TEXT_NODE && node.nodeValue?.trim() !== '') return true;
      if (node.nodeType !== Node.ELEMENT_NODE) continue;
      const { localName, textContent } = node as Element;
      if (localName === 'br' || !isInline(node as Element)) break;
      if (localName !== 'phong-control' && textContent.trim() !== '') return true;
    }
  }
  const parent = element.parentElement;
  return parent !== null && isInline(parent) && isInText(parent);
}

const isInline = (element: Element): boolean =>
  /^(inline|contents)/.test(getComputedStyle(element).display);
