// Dials: a range that writes one attribute of one element, as a reader would by hand.
// `<input type="range" data-for="id" data-set="attribute">`, with `data-values="1 2 4"` for steps that are no even
// scale, and `data-format="1 0 {}"` where the attribute holds more than the number. An `<output>` shows the number.

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
