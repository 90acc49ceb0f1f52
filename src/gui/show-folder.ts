// Which rows choose what is shown beside the shaded picture: a view of one quantity, helpers, the probe? Knows no light or mesh.
import type { GUI } from 'lil-gui';
import { HELPERS } from '../element/fields/viewer-fields.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { VIEWS } from '../material/views.js';
import { Folder } from './folder.js';
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
      if (names !== shown) light.options(choices);
      shown = names;
    };
  });
}

/** From names to values of `view-light`; a name that no light has is kept while it is chosen. */
function lightChoices({ lights, viewLight }: PhongViewer): Record<string, string> {
  const names = lights.map(({ name }) => name);
  if (viewLight !== '') names.push(viewLight);
  return { 'all, or the first': '', ...Object.fromEntries(names.map((name) => [name, name])) };
}
