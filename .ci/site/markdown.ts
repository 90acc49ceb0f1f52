// Markdown to HTML, by markdown-it: the pages of demo/guide/, and the manifest's descriptions.
// Knows no page's content.

import MarkdownIt, { type Env, type Token } from 'markdown-it';

/** Escapes text for HTML, attribute values included. */
export const escapeHtml = (text: string): string =>
  text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]!);

/** Descriptions: what looks like HTML in them is text. */
const words = new MarkdownIt();

export const inlineHtml = (text: string): string => words.renderInline(text);

export const blocksHtml = (text: string): string => words.render(text).trim();

export interface Section {
  readonly id: string;
  readonly level: number;
  /** As HTML. */
  readonly title: string;
}

export interface MarkdownPage {
  readonly title: string;
  /** The first paragraph, as text. */
  readonly description: string;
  readonly html: string;
  readonly sections: readonly Section[];
}

/** A heading's anchor, as GitHub makes it. @param text with its marks, such as `` `code` `` */
export const anchorOf = (text: string): string =>
  text
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N} _-]/gu, '')
    .replaceAll(' ', '-');

/**
 * @param text a page for users
 * @param resolved where a link of the page leads on the site; null for no link
 */
export function markdownPage(
  text: string,
  resolved: (href: string) => string | null,
): MarkdownPage {
  figures = 0;
  const env: Env = {};
  const tokens = pages.parse(text, env);
  const sections: Section[] = [];
  let element = '';
  let column = '';
  for (const [i, token] of tokens.entries()) {
    const next = tokens[i + 1]!;
    if (token.type === 'heading_open') {
      const id = anchorOf(next.content);
      token.attrSet('id', id);
      const level = Number(token.tag.slice(1));
      sections.push({ id, level, title: inner(next, env) });
      element = level === 2 ? (/^`<(phong-[a-z]+)>`$/.exec(next.content)?.[1] ?? '') : element;
    } else if (token.type === 'table_open') {
      column = '';
    } else if (token.type === 'th_open' || token.type === 'td_open') {
      const first = tokens[i - 1]!.type === 'tr_open';
      if (first && column === '') {
        column = next.content;
      } else if (first && element !== '') {
        anchorNames(next, element, column);
      }
    } else if (token.type === 'inline') {
      resolveLinks(token, resolved);
    }
  }
  const paragraph = tokens.findIndex(({ type }) => type === 'paragraph_open');
  tokens[paragraph]?.attrSet('class', 'lede');
  return {
    title: sections[0]?.title ?? '',
    description: textOf(tokens[paragraph + 1]),
    html: pages.renderer.render(tokens, pages.options, env),
    sections: sections.slice(1),
  };
}

// Written by us, and served under a strict policy: HTML in it is meant. Apostrophes become curved.
const pages = new MarkdownIt({ html: true, typographer: true }).disable('replacements');

const inner = (token: Token, env: Env): string =>
  pages.renderer.renderInline(token.children ?? [], pages.options, env);

const textOf = (token: Token | undefined): string =>
  (token?.children ?? [])
    .map(({ type, content }) => (type === 'softbreak' ? ' ' : content))
    .join('');

/** Each name in the cell can be linked to: `#phong-light-position`, `#phong-viewer-load-event`. */
function anchorNames(cell: Token, element: string, column: string): void {
  for (const code of (cell.children ?? []).filter(({ type }) => type === 'code_inline')) {
    const name = /^[\w-]*/.exec(code.content)![0];
    if (name === '' || /^(slot|part|state)$/.test(column)) continue;
    code.attrSet('id', `${element}-${name}${column === 'event' ? '-event' : ''}`);
  }
}

function resolveLinks(token: Token, resolved: (href: string) => string | null): void {
  for (const child of token.children ?? []) {
    if (child.type !== 'link_open') continue;
    const to = resolved(String(child.attrGet('href')));
    if (to !== null) {
      child.attrSet('href', to);
    } else {
      // Its text stays; a span cannot be followed.
      child.tag = 'span';
      child.attrs = [];
      token.children!.find((t, i) => t.type === 'link_close' && i > token.children!.indexOf(child))!.tag = 'span'; // oxfmt-ignore
    }
  }
}

const plainCode = pages.renderer.rules.code_inline!;

/** A long name breaks after an underscore. */
pages.renderer.rules.code_inline = (...token) =>
  plainCode(...token).replaceAll(/_(?=\w)/g, '_<wbr />');

const plainFence = pages.renderer.rules.fence!;
/** Live pictures of the page so far. */
let figures = 0;

/**
 * A block marked `html live` is a picture above its markup. Sizes are the page's: the policy
 * refuses `style`.
 */
pages.renderer.rules.fence = (tokens, i, options, env, self) => {
  const { info, content } = tokens[i]!;
  const [language = '', mark] = info.trim().split(' ');
  const title = escapeHtml(LANGUAGES[language] ?? language);
  if (mark !== 'live') {
    const text = `<pre translate="no">${escapeHtml(content)}</pre>`;
    return `<div class="listing"${title === '' ? '' : ` data-title="${title}"`}>${text}</div>\n`;
  }
  const scene = content.replaceAll(/ style="[^"]*"/g, '');
  const id = `live-${String((figures += 1))}`;
  const alone = /^<(phong-(?:viewer|compare))\b[^]*<\/\1>\s*$/.test(scene);
  const listing = alone
    ? `<div class="listing" data-of="#${id} > *"></div>`
    : plainFence([Object.assign(tokens[i]!, { info: 'html' })], 0, options, env, self).replace(
        /^<pre><code[^>]*>([^]*)<\/code><\/pre>/,
        '<div class="listing" data-title="HTML"><pre translate="no">$1</pre></div>',
      );
  return `<figure class="wide live" id="${id}">${scene}</figure>\n${listing}\n`;
};

pages.renderer.rules.table_open = () => '<div class="scroll"><table class="text">\n';
pages.renderer.rules.table_close = () => '</table></div>\n';

/** The names of the languages of code, for its caption. */
const LANGUAGES: Readonly<Record<string, string>> = {
  html: 'HTML',
  js: 'JavaScript',
  ts: 'TypeScript',
  jsx: 'JSX',
  css: 'CSS',
  sh: 'Command line',
  md: 'Markdown',
  python: 'Python',
};
