// The triangles of a text STL file: `solid name`, then `facet` … `vertex x y z` … `endfacet`, then `endsolid`. Stated
// normals are skipped. Words may be upper case, and anywhere on a line.
import { CORNER_LIMIT, PART_LIMIT } from '../limits.js';
import { ModelError } from '../model.js';
import { PAUSE_MASK, type Slices } from '../slices.js';
import { TextScanner } from '../text/text-scanner.js';
import { Positions } from '../triangles/corner-lists.js';
import type { StlSolid } from './read-stl.js';

/** @throws Error that names the line, for broken text; ModelError `too-large`. */
export async function readStlText(bytes: Uint8Array, slices: Slices): Promise<readonly StlSolid[]> {
  const scanner = new TextScanner(bytes);
  const solids: StlSolid[] = [];
  let name = '';
  let places = new Positions();
  let corners = 0;
  let total = 0;
  const endSolid = (): void => {
    if (places.count === 0) return;
    solids.push({ name, places, colors: null, color: [1, 1, 1], opacity: 1 });
    if (solids.length > PART_LIMIT) {
      throw new ModelError('too-large', `The model has more than ${PART_LIMIT.toLocaleString('en')} solids.`);
    }
    places = new Positions();
  };
  for (let words = 0; scanner.nextWord(); words += 1) {
    if ((words & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    const at = scanner.at;
    switch (scanner.word(16).toLowerCase()) {
      case 'solid':
        endSolid();
        name = solidName(scanner);
        break;
      case 'vertex':
        if (corners === 3) throw broken(scanner, at, 'a facet has more than three vertices');
        if (total === CORNER_LIMIT) {
          const most = CORNER_LIMIT.toLocaleString('en');
          throw new ModelError('too-large', `The model has more than ${most} triangle corners.`);
        }
        pushVertex(places, scanner, at);
        corners += 1;
        total += 1;
        break;
      case 'endfacet':
        if (corners !== 3) throw broken(scanner, at, 'a facet has fewer than three vertices');
        corners = 0;
        break;
    }
  }
  if (corners > 0) throw new Error('it is truncated: it ends inside a facet');
  endSolid();
  return solids;
}

/** Longest name of a solid in bytes. */
const NAME_LENGTH = 256;

/** The rest of the line, or what comes before the first facet where the file has no lines. */
function solidName(scanner: TextScanner): string {
  const start = scanner.at;
  let end = start;
  for (; !scanner.atLineEnd(); end = scanner.at) {
    const word = scanner.word(16).toLowerCase();
    const after = scanner.at;
    if (word === 'endsolid' || (word === 'facet' && scanner.word(16).toLowerCase() === 'normal')) break;
    scanner.at = after;
  }
  scanner.at = end;
  return scanner.textFrom(start, NAME_LENGTH);
}

function pushVertex(places: Positions, scanner: TextScanner, at: number): void {
  try {
    places.push(scanner.requiredNumber(), scanner.requiredNumber(), scanner.requiredNumber());
  } catch (cause) {
    if (!(cause instanceof Error) || cause instanceof ModelError) throw cause;
    throw broken(scanner, at, cause.message);
  }
}

const broken = (scanner: TextScanner, at: number, what: string): Error =>
  new Error(`line ${String(scanner.lineAt(at))}: ${what}`);
