// The pages of the site as HTML without what all pages share: those in demo/, those that are written
// from demo/guide/*.md, and those of other languages. Also what is at addresses that pages have left.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { markdownPage, type MarkdownPage } from './markdown.js';
import { translated, type Words } from './translation.js';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const demo = join(repository, 'demo');

/**
 * Paths such as `''`, `guide/light/` and `lesson/de/`: of every index.html, guide/NAME.md and file of
 * words under demo/.
 */
export const pagePaths = (): string[] =>
  readdirSync(demo, { recursive: true, encoding: 'utf8' })
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => path.endsWith('index.html') || isGuide(path) || isWords(path))
    .map((path) => path.replace(/index\.html$/, '').replace(/\.(md|json)$/, '/'))
    .sort();

const isGuide = (path: string): boolean => /^guide\/[\w-]+\.md$/.test(path);

/** A page's words in another language, such as lesson/de.json. */
const isWords = (path: string): boolean => /\/[a-z]{2}(-[A-Z]{2})?\.json$/.test(path);

/** The page that another is in another language, and that language; null for others. */
export function originalOf(
  path: string,
): { readonly page: string; readonly language: string } | null {
  const [, page = '', language = ''] = /^(.+\/)([\w-]+)\/$/.exec(path) ?? [];
  return languagesOf(page).includes(language) && language !== 'en' ? { page, language } : null;
}

/** The languages that a page is in, English first. */
export const languagesOf = (page: string): string[] => {
  const folder = join(demo, page);
  const files = page !== '' && existsSync(folder) ? readdirSync(folder) : [];
  const words = files.filter((file) => isWords(`/${file}`));
  return ['en', ...words.map((file) => file.replace('.json', '')).sort()];
};

/** Does a file of another name stand for the page? */
export const isWritten = (path: string): boolean =>
  markdownOf(path) !== null || originalOf(path) !== null;

/** The Markdown file of a page, relative to the repository; null for others. */
export function markdownOf(path: string): string | null {
  const file = `demo/${path.slice(0, -1)}.md`;
  return isGuide(file.slice('demo/'.length)) && existsSync(join(repository, file)) ? file : null;
}

/**
 * Where a link of a guide page leads on the site.
 * @param repositoryAddress empty if it has none yet
 */
export function siteAddress(href: string, file: string, repositoryAddress: string): string | null {
  if (/^(https?:|#)/.test(href)) return href;
  const [to = '', id] = posix.join(posix.dirname(file), href).split('#');
  const anchor = id === undefined ? '' : `#${id}`;
  const page = /^demo\/(guide\/[\w-]+)\.md$/.exec(to)?.[1];
  if (page !== undefined) return `../../${page}/${anchor}`;
  return repositoryAddress === '' ? null : `${repositoryAddress}/blob/main/${to}${anchor}`;
}

export const guidePage = (file: string, repositoryAddress: string): MarkdownPage =>
  markdownPage(readFileSync(join(repository, file), 'utf8'), (href) =>
    siteAddress(href, file, repositoryAddress),
  );

/** A page's HTML as it is written in demo/, or as if it were. */
export function sourceOf(path: string, repositoryAddress: string): string {
  const original = originalOf(path);
  if (original !== null) {
    const { page, language } = original;
    const words = JSON.parse(readFileSync(join(demo, page, `${language}.json`), 'utf8')) as Words;
    return translated(sourceOf(page, repositoryAddress), language, words);
  }
  const file = markdownOf(path);
  if (file === null) return readFileSync(join(demo, path, 'index.html'), 'utf8');
  const { title, description, html } = guidePage(file, repositoryAddress);
  return `<!doctype html>
<html lang="en">
  <head>
    <title>${title}</title>
    <meta name="description" content="${description.replaceAll('"', '&quot;')}" />
    <script type="module" src="../../page.ts"></script>
  </head>
  <body>
    <div class="sheet guide">
      <main id="main">${html}</main>
    </div>
  </body>
</html>`;
}

/** What stands at the address of a page that has moved. @param to from the site's root */
export function movedHtml(path: string, to: string): string {
  const href = `${'../'.repeat(path.split('/').length - 1)}${to}`;
  return `<!doctype html>
<html lang="en">
  <meta charset="utf-8" />
  <meta name="robots" content="noindex" />
  <meta http-equiv="refresh" content="0; url=${href}" />
  <title>Moved – phong-viewer</title>
  <p>This page has moved: <a href="${href}">go there</a>.</p>
</html>
`;
}
