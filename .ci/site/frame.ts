// What do all pages of the site share? The head for browsers, search engines and link previews, the
// header with the navigation, the footer with the way to the package. Text only; knows no page's
// content.

import { guide, others, sections, type Entry } from './contents.js';
import { escapeHtml, type Section } from './markdown.js';
import { alternatesHtml, rootFrom, type Languages } from './translation.js';

/**
 * Scripts, styles, models and pictures come from the site itself; nothing inline, nothing
 * evaluated.
 */
const POLICY = {
  'default-src': "'none'",
  'script-src': "'self'",
  'style-src': "'self'",
  'img-src': "'self' blob: data:",
  'connect-src': "'self'",
  'base-uri': "'none'",
  'form-action': "'none'",
};

/** The playground loads models from other hosts after a click (demo/playground/sources.ts). */
const PLAYGROUND_POLICY = {
  ...POLICY,
  'img-src': `${POLICY['img-src']} https:`,
  'connect-src': `${POLICY['connect-src']} https:`,
};

export interface Page {
  /** Relative to the site's root: `''`, `guide/lights/`. */
  readonly path: string;
  readonly title: string;
  readonly description: string;
  readonly languages: Languages;
}

export interface Facts {
  readonly version: string;
  /** The repository's address in a browser; empty if it has none yet. */
  readonly repository: string;
  /**
   * Where the site is published: absolute, with a slash at the end; empty if that is not known.
   * Link previews need absolute addresses.
   */
  readonly site: string;
}

/**
 * @param policy whether to add the Content-Security-Policy. The development server's own scripts
 * would break it.
 */
export function headHtml(
  { path, title, description, languages }: Page,
  { site }: Facts,
  policy: boolean,
): string {
  const root = rootFrom(path);
  const full = escapeHtml(path === '' ? title : `${title} – phong-viewer`);
  const rules = Object.entries(path === 'playground/' ? PLAYGROUND_POLICY : POLICY);
  const csp = rules.map(([name, value]) => `${name} ${value}`).join('; ');
  return `
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    ${policy ? `<meta http-equiv="Content-Security-Policy" content="${csp}" />` : ''}
    <title>${full}</title>
    <meta name="description" content="${description}" />
    <meta name="color-scheme" content="light dark" />
    ${site === '' ? '' : `<link rel="canonical" href="${site}${path}" />\n    <meta property="og:url" content="${site}${path}" />`}
    <meta property="og:type" content="website" />
    <meta property="og:site_name" content="phong-viewer" />
    <meta property="og:title" content="${full}" />
    <meta property="og:description" content="${description}" />
    <meta property="og:image" content="${site || root}assets/images/preview.png" />
    <meta property="og:image:width" content="1200" />
    <meta property="og:image:height" content="630" />
    <meta property="og:image:alt" content="A green teapot and a red ball on a round floor under a sun and a lamp" />
    <meta name="twitter:card" content="summary_large_image" />
    ${alternatesHtml(languages, site || root)}<link rel="icon" href="${root}assets/images/icon.svg" type="image/svg+xml" />
    <link rel="stylesheet" href="${root}page.css" />`;
}

const isInGuide = (path: string): boolean => guide.some((page) => page.path === path);

/** @param inside the page's own sections, if it has a list of them */
export function headerHtml(path: string, inside: readonly Section[]): string {
  const root = rootFrom(path);
  const named = sections.some((section) => section.path === path);
  const items = sections.map((section) => {
    const isAround = isInGuide(path) && !named && section === sections[1];
    const part = path.startsWith(section.path) || isAround;
    return link(section, root, section.path === path ? 'page' : part ? 'true' : '');
  });
  return `
      <a class="skip" href="#main" lang="en">Skip to the text</a>
      <header class="head" lang="en">
        <a class="mark" href="${root}">&lt;phong-viewer&gt;</a>
        <nav aria-label="Pages"><ul>${items.join('')}</ul></nav>
        <div class="search" role="search">
          <input id="search" type="search" placeholder="Search" aria-label="Search all pages" aria-controls="found" autocomplete="off" spellcheck="false" />
          <ol id="found" aria-label="Found" hidden></ol>
        </div>
      </header>${inside.length > 0 || isInGuide(path) ? contentsHtml(path, root, inside) : ''}`;
}

/**
 * The contents list: the sections of this page, among the guide's pages if it is one of them, and
 * what is not of the guide.
 */
function contentsHtml(path: string, root: string, inside: readonly Section[]): string {
  const own = inside
    .filter(({ level }) => level === 2)
    .map(({ id, title }) => `<li><a href="#${id}">${title}</a></li>`);
  const pages = guide.map((page) =>
    page.path === path
      ? link(page, root, 'page').replace('</li>', `<ol>${own.join('')}</ol></li>`)
      : link(page, root, ''),
  );
  const isGuide = isInGuide(path);
  const rest = isGuide ? `<ul>${others.map((page) => link(page, root, '')).join('')}</ul>` : '';
  return `
      <nav class="topics" aria-label="${isGuide ? 'Guide' : 'Contents'}">
        <button type="button" lang="en" aria-expanded="false" aria-controls="topics">Contents</button>
        <div id="topics"><ol>${(isGuide ? pages : own).join('')}</ol>${rest}</div>
      </nav>`;
}

export function footerHtml(path: string, { version, repository }: Facts): string {
  const root = rootFrom(path);
  return `${neighboursHtml(path, root)}
      <footer class="foot" lang="en">
        <p class="get">
          Get it: <a href="${root}guide/install/">one file for a page of your own</a>, or, once published,
          <code>npm install phong-viewer three</code>.
        </p>
        <p>
          phong-viewer ${escapeHtml(version)}, MIT licence${
            repository === '' ? '' : `, <a href="${escapeHtml(repository)}">source</a>`
          }. ${others
            .slice(-2)
            .map(({ path: to, label }) => `<a href="${root}${to}">${label}</a>`)
            .join(', ')}. Every picture by
          phong-viewer on these pages is drawn as you look at it.
        </p>
      </footer>`;
}

/** Links to the page before and after, in the guide's order. */
function neighboursHtml(path: string, root: string): string {
  const at = guide.findIndex((page) => page.path === path);
  if (at < 0) return '';
  const [before, after] = [guide[at - 1], guide[at + 1]];
  const parts = [
    before ? `<a rel="prev" href="${root}${before.path}">← ${before.label}</a>` : '<span></span>',
    after ? `<a rel="next" href="${root}${after.path}">${after.label} →</a>` : '',
  ];
  return `
      <nav class="neighbours" aria-label="Next and previous">${parts.join('')}</nav>`;
}

function link({ path, label }: Entry, root: string, current: string): string {
  return `<li><a href="${root}${path}"${current === '' ? '' : ` aria-current="${current}"`}>${label}</a></li>`;
}
