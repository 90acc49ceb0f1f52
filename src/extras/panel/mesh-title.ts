// What the panel calls a mesh.
import { fileName } from '../../phong/fields/file-names.js';
import type { MeshValues } from '../../phong/model/mesh-fields.js';
import { phrase, type ViewerTexts } from '../../viewer/extra.js';

type MeshNames = Pick<MeshValues, 'name' | 'src' | 'geometry'>;

/**
 * A mesh's name, else its file or shape, else its number among the viewer's meshes; `index` counts
 * from 0.
 */
export function meshTitle(
  texts: ViewerTexts | null,
  { name, src, geometry }: MeshNames,
  index: number,
): string {
  const file = typeof src === 'string' ? fileOf(src) : fileName(src);
  const shape = src === '' && geometry !== null ? phrase(texts, geometry) : '';
  return name || file || shape || phrase(texts, 'mesh {number}', { number: String(index + 1) });
}

/** `teapot.glb` from `models/teapot.glb?v=2`. */
const fileOf = (src: string): string => /([^/?#]*)(?:[?#].*)?$/.exec(src)?.[1] ?? '';
