// The pages of the site as HTML without what all pages share: those in demo/, and those that are
// written from demo/guide/*.md. Also what is at addresses that pages have left.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { fileURLToPath } from 'node:url';
import { markdownPage, type MarkdownPage } from './markdown.js';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const demo = join(repository, 'demo');

/** Paths such as `''` and `guide/light/`, of every index.html and guide/NAME.md under demo/. */
export const pagePaths = (): string[] =>
  readdirSync(demo, { recursive: true, encoding: 'utf8' })
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => path.endsWith('index.html') || isGuide(path))
    .map((path) => path.replace(/index\.html$/, '').replace(/\.md$/, '/'))
    .sort();

const isGuide = (path: string): boolean => /^guide\/[\w-]+\.md$/.test(path);

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
