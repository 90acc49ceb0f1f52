// The switchboard of the lights page: buttons, a slider, and one switch per light, updated when
// lights are added or removed in the viewer.
import { add, remove, toggle } from './spiral.js';

/** The slider's maximum. */
const MOST = 64;

export function connectBoard(viewer: HTMLElementTagNameMap['phong-viewer']): void {
  const count = document.querySelector<HTMLInputElement>('#count');
  const tally = document.querySelector('#tally');
  const switches = document.querySelector('#switches');
  if (count === null || tally === null || switches === null) {
    throw new Error('the board is not on this page');
  }
  const lights = viewer.getElementsByTagName('phong-light');

  const setCount = (n: number): void => {
    while (lights.length > n) {
      remove();
    }
    while (lights.length < n) {
      add();
    }
  };
  const show = (): void => {
    count.value = String(lights.length);
    tally.textContent = count.value;
    switches.replaceChildren(...Array.from(lights, switchFor));
  };
  const onPress = (id: string, act: () => void): void => {
    document.getElementById(id)?.addEventListener('click', act);
  };

  onPress('add', () => setCount(Math.min(lights.length + 1, MOST)));
  onPress('remove', remove);
  onPress('toggle', () => {
    toggle();
    show();
  });
  onPress('show', () => {
    const shown = viewer.toggleAttribute('helpers');
    document.getElementById('show')?.setAttribute('aria-pressed', String(shown));
  });
  count.addEventListener('input', () => setCount(count.valueAsNumber));
  new MutationObserver(show).observe(viewer, { childList: true });
  setCount(count.valueAsNumber);
}

function switchFor(light: HTMLElementTagNameMap['phong-light']): HTMLElement {
  const label = document.createElement('label');
  const box = document.createElement('input');
  box.type = 'checkbox';
  box.checked = light.active;
  box.setAttribute('aria-label', light.name);
  // Set from script: a strict CSP refuses style attributes.
  box.style.accentColor =
    light.getAttribute('axis') === null ? '' : (light.getAttribute('diffuse') ?? '');
  box.addEventListener('change', () => {
    light.setAttribute('active', String(box.checked));
  });
  label.append(box);
  return label;
}
