// The markup beside the picture, as it is now: its numbers are fields. What moves in the picture
// runs here, and what is typed, stepped or dragged here moves there.
import { markupOf, type Piece } from '../parts/markup.js';

type Viewer = HTMLElementTagNameMap['phong-viewer'];

interface Numbers {
  readonly element: HTMLElement;
  readonly attribute: string;
  readonly values: readonly number[];
}

const COLORS = /^(ambient|diffuse|specular|ka|kd|ks)$/;
/** Attributes in which one number may stand for three. */
const SINGLE = /^(ambient|diffuse|specular|ka|kd|ks|scale)$/;
/** What an arrow key adds; with Shift ten times as much. A pixel of a drag adds a fifth. */
const stepOf = (attribute: string): number =>
  COLORS.test(attribute) ? 5 : /^(position|scale|target|axis|radius)$/.test(attribute) ? 0.05 : 1;

/** Shows the viewer's markup in `place`. The returned function brings it up to date. */
export function showCode(place: HTMLElement, viewer: Viewer): () => void {
  let shape = '';
  let fields: readonly Field[] = [];
  return () => {
    const { pieces, numbers } = markupNow(viewer, lineLength(place));
    const next = pieces.map(({ text }) => text).join('');
    if (next !== shape) {
      shape = next;
      fields = write(place, pieces, numbers);
    }
    let i = 0;
    for (const { values } of numbers) {
      for (const value of values) {
        fields[i++]!.show(value);
      }
    }
  };
}

/** Characters that fit into a line; a folded line needs room for a field that grows. */
const lineLength = ({ clientWidth }: Element): number => Math.floor(clientWidth / 7.9) - 1;

const CHILDREN = 'phong-light, phong-mesh';

const partsOf = (viewer: Element): readonly Element[] => [
  viewer,
  ...viewer.querySelectorAll(CHILDREN),
];

/**
 * The scene as elements that show nothing: attributes in the order in which the page has them, one
 * number for a grey and an even scale, and nothing that is left to the viewer.
 */
export function markupOfNow(viewer: Viewer): Element {
  const copy = new DOMParser()
    .parseFromString(viewer.toHTML(), 'text/html')
    .querySelector('phong-viewer')!;
  const live = partsOf(viewer);
  for (const [i, element] of partsOf(copy).entries()) {
    const now = new Map([...element.attributes].map(({ name, value }) => [name, value]));
    for (const name of now.keys()) {
      element.removeAttribute(name);
    }
    for (const name of new Set([...live[i]!.getAttributeNames(), ...now.keys()])) {
      const value = now.get(name);
      if (value === undefined || value === 'auto') continue;
      const [first = '', ...others] = value.split(' ');
      const same = SINGLE.test(name) && others.every((other) => other === first);
      element.setAttribute(name, same ? first : value);
    }
  }
  return copy;
}

/** The markup with a placeholder for each number, so that lines fold alike whatever the numbers. */
function markupNow(
  viewer: Viewer,
  length: number,
): { readonly pieces: readonly Piece[]; readonly numbers: readonly Numbers[] } {
  const copy = markupOfNow(viewer);
  const live = partsOf(viewer) as readonly HTMLElement[];
  const numbers: Numbers[] = [];
  for (const [i, element] of partsOf(copy).entries()) {
    for (const { name, value } of [...element.attributes]) {
      const values = value.split(' ').map(Number);
      if (value !== '' && !values.some(Number.isNaN)) {
        numbers.push({ element: live[i]!, attribute: name, values });
        const digits = COLORS.test(name) ? '###' : '#####';
        element.setAttribute(name, values.map(() => digits).join(' '));
      }
    }
  }
  return { pieces: markupOf(copy, length), numbers };
}

function write(
  place: HTMLElement,
  pieces: readonly Piece[],
  numbers: readonly Numbers[],
): readonly Field[] {
  const fields: Field[] = [];
  let next = 0;
  const nodes = pieces.map(({ kind, text }): Node => {
    if (kind === 'plain') return document.createTextNode(text);
    const span = document.createElement('span');
    span.className = kind;
    if (kind === 'value' && text.startsWith('"#')) {
      const own = numbers[next++]!;
      const made = own.values.map((_, i) => new Field(own, i));
      fields.push(...made);
      span.append('"', ...made.flatMap(({ input }, i) => (i === 0 ? [input] : [' ', input])), '"');
    } else {
      span.textContent = text;
    }
    return span;
  });
  place.replaceChildren(...nodes);
  return fields;
}

/** One number of one attribute. */
class Field {
  readonly input = document.createElement('input');
  readonly #element: HTMLElement;
  readonly #property: string;
  readonly #index: number;
  readonly #step: number;
  /** It stands for the whole value. */
  readonly #alone: boolean;
  /** Where a drag began, and with which number. */
  #drag: { readonly x: number; readonly value: number } | null = null;
  #value = 0;

  constructor({ element, attribute, values }: Numbers, index: number) {
    this.#element = element;
    this.#property = attribute.replaceAll(/-(\w)/g, (_, letter: string) => letter.toUpperCase());
    this.#index = index;
    this.#step = stepOf(attribute);
    const { input } = this;
    input.type = 'text';
    input.inputMode = 'decimal';
    input.autocomplete = 'off';
    input.spellcheck = false;
    input.setAttribute('role', 'spinbutton');
    const owner = element.getAttribute('name') ?? 'viewer';
    this.#alone = values.length === 1;
    const part = this.#alone ? '' : ` ${(COLORS.test(attribute) ? ['red', 'green', 'blue'] : ['x', 'y', 'z', 'w'])[index]!}`; // oxfmt-ignore
    input.setAttribute('aria-label', `${owner} ${attribute}${part}`);
    input.addEventListener('input', () => this.#typed());
    input.addEventListener('keydown', this.#key);
    input.addEventListener('blur', () => this.#write());
    input.addEventListener('pointerdown', (event) => {
      if (event.button === 0 && document.activeElement !== input) {
        this.#drag = { x: event.clientX, value: this.#value };
        input.setPointerCapture(event.pointerId);
      }
    });
    input.addEventListener('pointermove', this.#move);
    for (const type of ['pointerup', 'pointercancel'] as const) {
      input.addEventListener(type, () => (this.#drag = null));
    }
  }

  /** Shows the number, unless it is being typed. */
  show(value: number): void {
    this.#value = value;
    if (
      document.activeElement !== this.input ||
      Number(this.input.value) !== Number(textOf(value))
    ) {
      this.#write();
    }
  }

  #write(): void {
    const text = textOf(this.#value);
    const { input } = this;
    input.removeAttribute('aria-invalid');
    if (input.value !== text) {
      input.value = text;
    }
    this.#fit();
    input.setAttribute('aria-valuenow', text);
  }

  #fit(): void {
    this.input.style.width = `${String(Math.max(this.input.value.length, 1))}ch`;
  }

  #typed(): void {
    this.#fit();
    const text = this.input.value.trim().replace(',', '.');
    this.input.toggleAttribute('aria-invalid', false);
    if (text === '' || !this.#set(Number(text))) {
      this.input.setAttribute('aria-invalid', 'true');
    }
  }

  /** False if the element refuses it. */
  #set(value: number): boolean {
    const before: unknown = Reflect.get(this.#element, this.#property);
    const after =
      Array.isArray(before) && !this.#alone
        ? before.map((old: number, i) => (i === this.#index ? value : old))
        : value;
    try {
      Reflect.set(this.#element, this.#property, after);
    } catch {
      return false;
    }
    this.#value = value;
    return true;
  }

  readonly #key = (event: KeyboardEvent): void => {
    const { key, shiftKey } = event;
    const direction = key === 'ArrowUp' ? 1 : key === 'ArrowDown' ? -1 : 0;
    if (direction !== 0) {
      event.preventDefault();
      this.#add(this.#value, direction * this.#step * (shiftKey ? 10 : 1));
      this.#write();
    } else if (key === 'Enter') {
      this.#write();
      this.input.select();
    }
  };

  readonly #move = ({ clientX }: PointerEvent): void => {
    if (this.#drag === null) return;
    const pixels = Math.round(clientX - this.#drag.x);
    if (pixels !== 0) {
      this.#add(this.#drag.value, (pixels * this.#step) / 5);
      this.#write();
    }
  };

  #add(value: number, change: number): void {
    this.#set(Number((value + change).toFixed(4)));
  }
}

/** As written by hand, or with two decimals where it was dragged. */
const textOf = (value: number): string =>
  Number(value.toFixed(3)) === value ? String(value) : value.toFixed(2);
