// An element's markup as its author would write it: one child a line, long tags folded. Attributes that belong to
// the page and not to the scene (id, class, data-…) are left out. Text and pieces of text; builds no elements.

export interface Piece {
  readonly kind: 'plain' | 'tag' | 'value';
  readonly text: string;
}

/** Characters in a line before a tag is folded. */
const LINE = 76;

export function markupOf(element: Element): readonly Piece[] {
  const children = [...element.children].flatMap((child) => [
    plain('\n'),
    ...startTag(child, '  '),
    ...endTag(child),
  ]);
  const end = children.length === 0 ? endTag(element) : [plain('\n'), ...endTag(element)];
  return [...startTag(element, ''), ...children, ...end];
}

function startTag(element: Element, indent: string): Piece[] {
  const name = element.localName;
  const pieces: Piece[] = [plain(`${indent}<`), { kind: 'tag', text: name }];
  let column = indent.length + 1 + name.length;
  for (const { name: attribute, value } of element.attributes) {
    if (/^(id|class|data-.*)$/.test(attribute)) continue;
    const quoted = value === '' ? '' : `"${value.replaceAll('&', '&amp;').replaceAll('"', '&quot;')}"`;
    const length = attribute.length + (quoted === '' ? 0 : quoted.length + 1);
    const folds = column + 1 + length > LINE;
    const before = folds ? `\n${indent}    ` : ' ';
    column = (folds ? indent.length + 4 : column + 1) + length;
    pieces.push(plain(before + attribute + (quoted === '' ? '' : '=')));
    if (quoted !== '') pieces.push({ kind: 'value', text: quoted });
  }
  return [...pieces, plain('>')];
}

const endTag = (element: Element): Piece[] => [
  plain('</'),
  { kind: 'tag', text: element.localName },
  plain('>'),
];

const plain = (text: string): Piece => ({ kind: 'plain', text });
