// Writes an element's markup as its author would: one child per line, long tags folded. Attributes
// that belong to the page and not to the scene (id, class, loading, data-…) are left out. Returns
// pieces of text; builds no elements.

export interface Piece {
  readonly kind: 'plain' | 'tag' | 'value';
  readonly text: string;
}

/** Characters of a line, where there is room. */
export const COLUMNS = 76;

/** @param lineLength characters per line; longer tags are folded. */
export function markupOf(element: Element, lineLength: number): readonly Piece[] {
  return indented(element, '', lineLength);
}

function indented(element: Element, indent: string, lineLength: number): Piece[] {
  const start = startTag(element, indent, lineLength);
  if (element.children.length === 0) return [...start, ...endTag(element)];
  const children = [...element.children].flatMap((child) => [
    plain('\n'),
    ...indented(child, `${indent}  `, lineLength),
  ]);
  return [...start, ...children, plain(`\n${indent}`), ...endTag(element)];
}

function startTag(element: Element, indent: string, lineLength: number): Piece[] {
  const name = element.localName;
  const pieces: Piece[] = [plain(`${indent}<`), { kind: 'tag', text: name }];
  let column = indent.length + 1 + name.length;
  const written = [...element.attributes].filter(
    (a) => !/^(id|class|loading|data-.*)$/.test(a.name),
  );
  // What follows the last attribute must stay on its line.
  const ending = element.children.length === 0 ? name.length + 4 : 1;
  for (const [i, { name: attribute, value }] of written.entries()) {
    const quoted =
      value === '' ? '' : `"${value.replaceAll('&', '&amp;').replaceAll('"', '&quot;')}"`;
    const length = attribute.length + (quoted === '' ? 0 : quoted.length + 1);
    const after = i === written.length - 1 ? ending : 0;
    const folds = column + 1 + length + after > lineLength;
    const before = folds ? `\n${indent}    ` : ' ';
    column = (folds ? indent.length + 4 : column + 1) + length;
    pieces.push(plain(before + attribute + (quoted === '' ? '' : '=')));
    if (quoted !== '') {
      pieces.push({ kind: 'value', text: quoted });
    }
  }
  return [...pieces, plain('>')];
}

const endTag = (element: Element): Piece[] => [
  plain('</'),
  { kind: 'tag', text: element.localName },
  plain('>'),
];

const plain = (text: string): Piece => ({ kind: 'plain', text });
