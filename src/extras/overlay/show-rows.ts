// The rows that edit in the panel what lies over the picture.
import { VIEWS } from '../../phong/material/views.js';
import { HELPERS } from '../../phong/fields/viewer-words.js';
import { type ExtraRows, fieldsOf, lightName, type PhongViewer } from '../../viewer/extra.js';

export const rows: ExtraRows = ({ flag, flags, oneName, oneOf }) => ({
  view: oneOf('view', VIEWS),
  // Lights without a name have a number, in the page's words.
  viewLight: oneName('view light', lightNames, (name, viewer, say) => {
    if (name === '') return say('all, or the first');
    const index = namesOf(viewer).indexOf(name);
    const light = viewer.lights[index];
    return light === undefined || fieldsOf(light).store.values.name !== ''
      ? name
      : say('light {number}', { number: String(index + 1) });
  }),
  helpers: flags(HELPERS, (helper) => `show ${helper}`),
  probe: flag('probe'),
});

const namesOf = ({ lights }: PhongViewer): readonly string[] =>
  lights.map((light, i) => lightName(fieldsOf(light).store, i));

/** Values of `view-light`; a name that no light has is kept while it is selected. */
function lightNames(viewer: PhongViewer): readonly string[] {
  return [...new Set(['', ...namesOf(viewer), viewer.viewLight])];
}
