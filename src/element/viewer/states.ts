// Custom states, by which CSS learns what a viewer is doing: `phong-viewer:state(loading)`. Browsers without them go
// without.

export class ViewerStates {
  #states: Set<string> | undefined;

  constructor(element: HTMLElement) {
    // Missing in older browsers, whatever the types say.
    const { attachInternals } = element as Partial<HTMLElement>;
    try {
      this.#states = (attachInternals?.call(element) as Partial<ElementInternals> | undefined)?.states;
    } catch {
      // refused where the tag has an attribute `is`
    }
  }

  set(state: 'loading' | 'error' | 'empty', on: boolean): void {
    try {
      if (on) this.#states?.add(state);
      else this.#states?.delete(state);
    } catch {
      this.#states = undefined; // Chrome before 125 accepts only names that begin with two dashes
    }
  }
}
