// What is a dial? A slider that writes one attribute of one element: `<input type="range" data-for="id" data-set="attribute">`.
// `data-values="1 2 4"` lists uneven steps; `data-format="1 0 {}"` is for attributes that hold more than the number. An `<output>`
// next to it shows the number.

export function connectDials(root: ParentNode): void {
  for (const input of root.querySelectorAll<HTMLInputElement>('input[data-for]')) {
    const { for: id, set, values, format = '{}' } = input.dataset;
    const target = document.getElementById(id ?? '');
    if (target === null || set === undefined) throw new Error(`a dial needs data-for and data-set`);
    const steps = values?.split(' ');
    const output = input.parentElement?.querySelector('output');
    const show = (): string => {
      const number = steps?.[input.valueAsNumber] ?? input.value;
      if (output) output.textContent = number;
      input.setAttribute('aria-valuetext', number);
      return number;
    };
    input.addEventListener('input', () => {
      target.setAttribute(set, format.replace('{}', show()));
    });
    show();
  }
}
