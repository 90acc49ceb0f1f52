// Which rows set what applies to the whole picture? Shading, reflection, terms, colour space, antialiasing. Knows no light or mesh.
import type { GUI } from 'lil-gui';
import type { PhongViewer } from '../element/phong-viewer.js';
import { ANTIALIASES, REFLECTIONS, SHADINGS, TERMS } from '../material/shading-style.js';
import { Folder } from './folder.js';
import { addChoice, addFlag, type Edit, named } from './rows.js';

export function shadingFolder(root: GUI, viewer: PhongViewer, edit: Edit): Folder {
  return new Folder(root, 'Shading', edit, (rows) => {
    addChoice(
      rows,
      'shading',
      named(SHADINGS),
      () => viewer.shading,
      (shading) => (viewer.shading = shading),
    );
    addChoice(
      rows,
      'reflection',
      named(REFLECTIONS),
      () => viewer.reflection,
      (reflection) => (viewer.reflection = reflection),
    );
    for (const term of TERMS) {
      addFlag(
        rows,
        `${term} term`,
        () => viewer.terms.includes(term),
        (wanted) => {
          viewer.terms = TERMS.filter((other) => (other === term ? wanted : viewer.terms.includes(other)));
        },
      );
    }
    addChoice(
      rows,
      'colour space',
      named(['srgb', 'linear'] as const),
      () => viewer.colorInterpolation,
      (space) => (viewer.colorInterpolation = space),
    );
    addChoice(
      rows,
      'antialias',
      named(ANTIALIASES),
      () => viewer.antialias,
      (antialias) => (viewer.antialias = antialias),
    );
    return undefined;
  });
}
