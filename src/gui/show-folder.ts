// Which rows choose what is shown beside the shaded picture: a view of one quantity, helpers, the probe? Knows no light or mesh.
import type { GUI } from 'lil-gui';
import { HELPERS } from '../element/fields/viewer-fields.js';
import { fieldsOf } from '../element/internals.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { VIEWS } from '../material/views.js';
import { Folder } from './folder.js';
import { label, type Say } from './label.js';
import { addChoice, addFlag, type Edit, named } from './rows.js';

export function showFolder(root: GUI, viewer: PhongViewer, edit: Edit): Folder {
  return new Folder(root, 'Show', edit, (rows) => {
    addChoice(
      rows,
      'view',
      named(VIEWS),
      () => viewer.view,
      (view) => (viewer.view = view),
    );
    const light = addChoice(
      rows,
      'view light',
      lightChoices(viewer),
      () => viewer.viewLight,
      (name) => (viewer.viewLight = name),
    );
    let shown = '';
    for (const helper of HELPERS) {
      addFlag(
        rows,
        `show ${helper}`,
        () => viewer.helpers.includes(helper),
        (wanted) => {
          viewer.helpers = HELPERS.filter((other) =>
            other === helper ? wanted : viewer.helpers.includes(other),
          );
        },
      );
    }
    addFlag(
      rows,
      'probe',
      () => viewer.probe,
      (wanted) => (viewer.probe = wanted),
    );
    return () => {
      const choices = lightChoices(viewer);
      const names = JSON.stringify(choices);
      if (names === shown) return;
      shown = names;
      light.options(choices);
      label(light.$select, (say) => {
        Object.values(choices).forEach((value, i) => {
          light.$select.options[i]!.textContent = textOf(value, viewer, say);
        });
      });
    };
  });
}

/** Values of `view-light` as lil-gui takes them; a name that no light has is kept while it is chosen. */
function lightChoices({ lights, viewLight }: PhongViewer): Record<string, string> {
  const names = lights.map(({ name }) => name);
  return Object.fromEntries(['', ...names, viewLight].map((name) => [name, name]));
}

/** Lights without a name have a number, in the page's words. */
function textOf(value: string, { lights }: PhongViewer, say: Say): string {
  if (value === '') return say('all, or the first');
  const index = lights.findIndex(({ name }) => name === value);
  const named = lights[index] === undefined || fieldsOf(lights[index]).store.values.name !== '';
  return named ? value : say('light {number}', { number: String(index + 1) });
}
