// What is a dial? A slider that writes one attribute: `<input type="range" data-for="id" data-set="attribute">`.
// `data-for` may list several elements, such as a lamp on both sides of a divider. `data-values="1 2 4"` lists uneven
// steps; `data-format="1 0 {}"` is for attributes that hold more than the number. An `<output>` next to it shows the
// number.

export function connectDials(root: ParentNode): void {
  for (const input of root.querySelectorAll<HTMLInputElement>('input[data-for]')) {
    const { for: id, set, values, format = '{}' } = input.dataset;
    const targets = (id ?? '').split(' ').map((one) => document.getElementById(one));
    if (targets.includes(null) || set === undefined) throw new Error(`a dial needs data-for and data-set`);
    const steps = values?.split(' ');
    const output = input.parentElement?.querySelector('output');
    const show = (): string => {
      const number = steps?.[input.valueAsNumber] ?? input.value;
      if (output) output.textContent = number;
      input.setAttribute('aria-valuetext', number);
      return number;
    };
    input.addEventListener('input', () => {
      const value = format.replace('{}', show());
      for (const target of targets) target?.setAttribute(set, value);
    });
    show();
  }
}
