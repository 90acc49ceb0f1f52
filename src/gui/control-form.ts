// How the rows of the panel look as a <phong-control>: in a line of text or alone, with a unit and the author's label,
// and on paper.
import type { GUI } from 'lil-gui';
import { phrase, type ViewerTexts } from '../element/fields/texts.js';
import type { PhongControl } from '../element/phong-control.js';

/** The unit in a row's name, as it is written behind a number. */
const UNIT = /\s*°$/;

/** What the panel's rows lack outside of it: parts, the author's label, units, and what is printed. */
export function dress(gui: GUI, key: string, element: PhongControl): void {
  const rows = gui.controllers;
  const box = gui.domElement;
  const hasLabel = element.textContent.trim() !== '' || element.firstElementChild !== null;
  for (const { $name, $widget, domElement } of rows) {
    $name.part.add('label');
    for (const input of $widget.querySelectorAll<HTMLElement>('input, select, button, output')) input.part.add('input');
    if (domElement.classList.contains('lil-number')) {
      const unit = key === 'autoRotate' ? '°/s' : UNIT.test($name.textContent) ? '°' : '';
      $name.textContent = $name.textContent.replace(UNIT, '');
      const behind = document.createElement('span');
      behind.part.add('unit');
      behind.textContent = unit;
      $widget.append(behind);
      const slider = $widget.querySelector<HTMLInputElement>('[type="range"]')!;
      slider.tabIndex = 0; // alone, without the panel's other rows to pass by
      const field = $widget.querySelector<HTMLInputElement>('.number')!;
      if (field.type === 'text') field.role = 'spinbutton';
    }
    const printed = document.createElement('span');
    printed.className = 'printed';
    domElement.append(printed);
  }
  if (!hasLabel) return;
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

/** After each change: the width of numbers, and the text for paper. */
export function settle(gui: GUI, texts: ViewerTexts | null): void {
  for (const { $widget, domElement } of gui.controllers) {
    const inputs = $widget.querySelectorAll<HTMLInputElement>(
      'output, select, input:not([type="range"], [type="color"])',
    );
    const said = Array.from(inputs, (input) => {
      if (input.classList.contains('number')) {
        input.style.setProperty('--digits', String(Math.max(input.value.length, 1)));
        if (input.role === 'spinbutton') input.ariaValueNow = input.value;
      }
      if (input.type === 'checkbox') return phrase(texts, input.checked ? 'on' : 'off');
      if (input.localName === 'select') return (input as unknown as HTMLSelectElement).selectedOptions[0]?.text ?? '';
      return input.value;
    });
    const unit = $widget.querySelector('[part="unit"]')?.textContent ?? '';
    domElement.querySelector('.printed')!.textContent = said.join(' ') + unit;
  }
}

/**
 * Whether text stands beside `element` in its line: in a neighbour, or around an inline parent, up to a line break or a
 * block.
 */
export function isInText(element: Element): boolean {
  for (const side of ['previousSibling', 'nextSibling'] as const)
    for (let node = element[side]; node !== null; node = node[side]) {
      if (node.nodeType === Node.TEXT_NODE && node.nodeValue?.trim() !== '') return true;
      if (node.nodeType !== Node.ELEMENT_NODE) continue;
      const { localName, textContent } = node as Element;
      if (localName === 'br' || !isInline(node as Element)) break;
      if (localName !== 'phong-control' && textContent.trim() !== '') return true;
    }
  const parent = element.parentElement;
  return parent !== null && isInline(parent) && isInText(parent);
}

const isInline = (element: Element): boolean => /^(inline|contents)/.test(getComputedStyle(element).display);
