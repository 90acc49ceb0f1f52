// Makes the live viewer follow the scene. What has not changed is left alone, so that the camera,
// the panel and loaded models stay while someone types. Builds only the elements of a checked
// scene.
import { MOST_MEMORY, MOST_TRIANGLES, type Scene, type SceneElement } from './scene.js';

type Viewer = HTMLElementTagNameMap['phong-viewer'];

/** @param before the scene that the viewer shows now; null if unknown. */
export function showScene(viewer: Viewer, before: Scene | null, scene: Scene): void {
  const [root, ...children] = scene.elements;
  if (root === undefined) return;
  const live = [...viewer.querySelectorAll<HTMLElement>('phong-light, phong-mesh')];
  const known = before?.elements ?? [];
  update(viewer, known[0], root);
  compareWith(viewer, before, scene);
  limit(viewer, scene);
  // The panel's markup may list the children in another order than they stand in: then all are
  // built again.
  const inStep =
    live.length === known.length - 1 && live.every((e, i) => e.localName === known[i + 1]!.tag);
  if (!inStep) {
    viewer.replaceChildren(...children.map(built));
    return;
  }
  children.forEach((child, i) => {
    const element = live[i];
    if (element === undefined) {
      viewer.append(built(child));
    } else if (element.localName === child.tag) {
      update(element, known[i + 1], child);
    } else {
      element.replaceWith(built(child));
    }
  });
  for (const element of live.slice(children.length)) {
    element.remove();
  }
}

/**
 * Puts the viewer into the scene's comparison, or out of one. The other viewers are built again
 * where they changed.
 */
function compareWith(viewer: Viewer, before: Scene | null, scene: Scene): void {
  const around = viewer.closest('phong-compare');
  if (scene.comparison === null) {
    around?.replaceWith(viewer);
    return;
  }
  const compare = around ?? document.createElement('phong-compare');
  if (around === null) {
    viewer.replaceWith(compare);
  }
  update(compare, before?.comparison ?? undefined, scene.comparison);
  if (around !== null && before !== null && textOf(before.others) === textOf(scene.others)) return;
  const others = scene.others.map(([root, ...children]) => {
    const other = built(root!) as Viewer;
    limit(other, scene);
    other.append(...children.map(built));
    return other;
  });
  compare.replaceChildren(viewer, ...others);
}

/** The viewers of the page have one budget: each gets an equal share, a whole number. */
function limit(viewer: Viewer, { others }: Scene): void {
  const count = 1 + others.length;
  const triangles = Math.floor(MOST_TRIANGLES / count);
  // Setting a limit asks again for all files that have failed.
  if (viewer.maxTriangles === triangles) return;
  viewer.maxTriangles = triangles;
  viewer.maxMemory = Math.floor(MOST_MEMORY / count);
}

const textOf = (viewers: Scene['others']): string =>
  JSON.stringify(viewers.map((one) => one.map(({ tag, attributes }) => [tag, ...attributes])));

function built(element: SceneElement): HTMLElement {
  const made = document.createElement(element.tag);
  for (const [name, value] of element.attributes) {
    made.setAttribute(name, value);
  }
  return made;
}

function update(live: HTMLElement, before: SceneElement | undefined, after: SceneElement): void {
  for (const [name, value] of after.attributes) {
    if (before?.attributes.get(name) !== value) {
      live.setAttribute(name, value);
    }
  }
  for (const name of before?.attributes.keys() ?? []) {
    if (after.attributes.has(name)) continue;
    // A value that came from the panel is a property without an attribute: both are reset.
    live.removeAttribute(name);
    Reflect.set(live, propertyOf(name), null);
  }
}

const propertyOf = (attribute: string): string =>
  attribute.replaceAll(/-(\w)/g, (_, letter: string) => letter.toUpperCase());
