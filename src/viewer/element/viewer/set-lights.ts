// `viewer.setLights`: a viewer's lights by name, all or nothing.
import { show } from '../../../phong/fields/field.js';
import type { LightsByName, PhongViewer } from '../elements.js';
import { fieldsOf } from '../internals.js';

export function setLights(viewer: PhongViewer, lights: LightsByName): void {
  // New elements check every value first: an error leaves the viewer's lights as they are.
  const wanted = entriesOf(lights).map(([name, values]) => {
    const light = document.createElement('phong-light');
    for (const [key, value] of [...entriesOf(values), ['name', name] as const]) {
      fieldsOf(light).set(key as 'name', value);
    }
    return light;
  });
  const left = new Set(viewer.lights);
  for (const light of wanted) {
    const { store } = fieldsOf(light);
    const { values } = store;
    const namesake = [...left].find((other) => fieldsOf(other).store.values.name === values.name);
    if (namesake === undefined) {
      viewer.append(light);
      continue;
    }
    left.delete(namesake);
    for (const key of Object.keys(values) as (keyof typeof values)[]) {
      fieldsOf(namesake).set(key, store.given(key) ? values[key] : null);
    }
  }
  for (const light of left) {
    light.remove();
  }
}

function entriesOf(given: unknown): readonly (readonly [string, unknown])[] {
  if (typeof given !== 'object' || given === null || Array.isArray(given)) {
    throw new TypeError(`setLights: expected an object, got ${show(given)}`);
  }
  return Object.entries(given);
}
