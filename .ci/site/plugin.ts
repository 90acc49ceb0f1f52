// Makes pages of the files in demo/: adds what all pages share, replaces comments such as `<!--
// sizes -->` by generated parts, adds the search index and what is at earlier addresses, and gives
// the playground the documented attributes. The same in the development server and in the build.

import { spawn, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Package as Manifest } from 'custom-elements-manifest';
import type { Plugin } from 'vite';
import { outputFolder } from '../output-folder.mjs';
import { moved } from './contents.js';
import { footerHtml, headerHtml, headHtml, type Facts } from './frame.js';
import { examplesHtml, type Example, sizeOf, sizesHtml, withListings } from './generated.js';
import { readmePage, readmeSnippet } from '../readme-picture.mjs';
import { textsIn } from '../texts.mjs';
import { escapeHtml, type Section } from './markdown.js';
import { pairsHtml, type ModelEntries } from './models.js';
import {
  guidePage,
  isWritten,
  languagesOf,
  markdownOf,
  movedHtml,
  originalOf,
  pagePaths,
  sourceOf,
} from './pages.js';
import { picturesHtml } from './pictures.js';
import { searchIndex } from './search.js';
import { languagesHtml } from './translation.js';
import { readResults } from '../../tests/bench/results.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const demo = join(repository, 'demo');
const dist = outputFolder('dist');
/** Files of dist/ that pages offer or show, and the part of the build that makes each. */
const BUILT: readonly (readonly [file: RegExp, parts: readonly string[]])[] = [
  [/^\/phong-viewer\.classic\.js$/, ['classic']],
  [/^\/phong-viewer\.standalone\.js$|^\/chunks\/[\w.-]+$/, ['standalone']],
  [/^\/embed\.(html|js)$/, ['manifest', 'embed']],
];

/** The pages as Vite's entries: some have no file of that name. */
export const pageFiles = (): string[] => pagePaths().map((path) => join(demo, path, 'index.html'));

/** A page's path, from its file or its address with a slash in front. */
const pathOf = (name: string): string => name.replace(/^\//, '').replace(/index\.html$/, '');

/**
 * The data of tags and attributes that editors read; the playground completes and filters by it.
 */
const HTML_DATA = 'virtual:html-data';
/** The names of the documented attributes by tag. */
const ATTRIBUTES = 'virtual:attributes';

/** Tags and attributes as modules: `virtual:html-data`, `virtual:attributes`. */
export function elementData(): Plugin {
  return {
    name: 'element-data',
    resolveId: (id) => (id === HTML_DATA || id === ATTRIBUTES ? `\0${id}` : null),
    load(id) {
      if (id === `\0${HTML_DATA}`) {
        return `export default ${readBuilt('vscode.html-custom-data.json')}.tags;`;
      }
      if (id === `\0${ATTRIBUTES}`) {
        return `export default ${JSON.stringify(documentedAttributes())};`;
      }
      return null;
    },
  };
}

export function sitePages(): Plugin {
  let building = false;
  return {
    name: 'site-pages',
    configResolved(config) {
      building = config.command === 'build';
    },
    resolveId: (id) => (writtenPage(id) === null ? null : id),
    load(id) {
      const page = writtenPage(id);
      return page === null ? null : sourceOf(page, packageFacts().repository);
    },
    configureServer(server) {
      const { middlewares } = server;
      middlewares.use((request, response, next) => {
        const path = (request.url ?? '').replace(/[?#].*$/, '');
        const page = pathOf(path);
        if (path === '/search.json') {
          response.setHeader('content-type', 'application/json').end(searchJson());
          return;
        }
        const to = Object.hasOwn(moved, page) ? moved[page] : undefined;
        if (to !== undefined) {
          response.setHeader('content-type', 'text/html').end(movedHtml(page, to));
          return;
        }
        if (isWritten(page)) {
          const source = sourceOf(page, packageFacts().repository);
          void server
            .transformIndexHtml(`/${page}index.html`, source)
            .then((html) => response.setHeader('content-type', 'text/html').end(html), next);
          return;
        }
        const parts = BUILT.find(([file]) => file.test(path))?.[1];
        if (parts === undefined) {
          next();
          return;
        }
        void built(join(dist, path), parts).then((file) => {
          if (file === null) {
            response.writeHead(404).end(`${path} is not there.`);
          } else {
            response.setHeader('content-type', contentType(path)).end(readFileSync(file));
          }
        });
      });
    },
    transformIndexHtml: {
      order: 'pre',
      handler: (html, { path }) => withListings(pageHtml(html, pathOf(path), building)),
    },
    writeBundle() {
      if (!building) return;
      const output = outputFolder('site');
      // Files in demo/assets keep their names: Vite does not follow the `src` of a custom element.
      cpSync(join(demo, 'assets'), join(output, 'assets'), { recursive: true });
      for (const name of [
        'phong-viewer.classic.js',
        'phong-viewer.standalone.js',
        'chunks',
        'embed.html',
        'embed.js',
      ]) {
        if (existsSync(join(dist, name))) {
          cpSync(join(dist, name), join(output, name), { recursive: true });
        }
      }
      writeFileSync(join(output, 'search.json'), searchJson());
      for (const [path, to] of Object.entries(moved)) {
        mkdirSync(join(output, path), { recursive: true });
        writeFileSync(join(output, path, 'index.html'), movedHtml(path, to));
      }
      const { site } = packageFacts();
      if (site !== '') {
        writeFileSync(join(output, 'sitemap.xml'), sitemap(site));
      }
    },
  };
}

/** The page that Vite asks for, if no file of that name is there; null for other modules. */
function writtenPage(id: string): string | null {
  if (!id.startsWith(demo) || !id.endsWith('/index.html')) return null;
  const page = pathOf(relative(demo, id));
  return isWritten(page) ? page : null;
}

/** The index of all pages, as they are now. */
function searchJson(): string {
  const { repository: address } = packageFacts();
  return searchIndex(
    pagePaths().map((path) => ({ path, html: pageHtml(sourceOf(path, address), path, false) })),
  );
}

/** Builds in progress, by their parts: each runs once. */
const builds = new Map<string, Promise<void>>();

/** The file, made first if it is missing; null if it cannot be made. */
async function built(file: string, parts: readonly string[]): Promise<string | null> {
  const key = parts.join(' ');
  if (!existsSync(file) && !builds.has(key)) {
    console.log(
      `Building ${relative(repository, file)}: a page asks for it. This takes ten seconds, once.`,
    );
    builds.set(key, run(join(repository, '.ci/build.mjs'), ...parts));
  }
  await builds.get(key);
  return existsSync(file) ? file : null;
}

const run = (...args: readonly string[]): Promise<void> =>
  new Promise((resolve) => {
    // The development server's own mode would put Lit's development build inside.
    const env = { ...process.env, NODE_ENV: 'production' };
    spawn(process.execPath, args, { stdio: 'inherit', env }).on('close', () => resolve());
  });

const contentType = (path: string): string =>
  path.endsWith('.html')
    ? 'text/html'
    : path.endsWith('.wasm')
      ? 'application/wasm'
      : 'text/javascript';

/** A formula and the stop after it: no line begins with the stop. */
const STOPPED = /<math\b(?:(?!<math)[^])*?<\/math\s*>[.,:;)]/g;

function pageHtml(source: string, path: string, building: boolean): string {
  const title = /<title>([^<]*)<\/title>\s*/.exec(source);
  const description = /<meta\s+name="description"\s+content="([^"]*)"\s*\/>\s*/.exec(source);
  if (title === null || description === null) {
    throw new Error(`demo/${path}: needs a title and a description`);
  }
  const facts = packageFacts();
  const markdown = markdownOf(path);
  const inside =
    markdown === null ? sectionsOf(source) : guidePage(markdown, facts.repository).sections;
  const { page: original, language } = originalOf(path) ?? { page: path, language: 'en' };
  const languages = { original, all: languagesOf(original), own: language };
  const head = headHtml(
    { path, title: title[1]!, description: description[1]!, languages },
    facts,
    building,
  );
  return source
    .replace(title[0], '')
    .replace(description[0], '')
    .replace('<head>', () => `<head>${head}`)
    .replaceAll(STOPPED, '<span class="whole">$&</span>')
    .replace(/<div class="sheet[^"]*">/, (sheet) => sheet + headerHtml(path, inside))
    .replace('<!-- languages -->', () => languagesHtml(languages, path))
    .replace('</main>', () => `</main>${footerHtml(path, facts)}`)
    .replace(/<a href="repository:([^"]+)"\s*>([^]*?)<\/a\s*>/g, (_, file: string, words: string) =>
      repositoryLink(file, words, facts.repository),
    )
    .replace(
      /<!-- ([a-z]+)(?: ([a-z-]+))? -->/g,
      (comment: string, name: string, argument?: string) =>
        generated.get(name)?.(argument ?? '') ?? comment,
    );
}

/** The sections of a page that is HTML, if it has the guide's layout. */
const sectionsOf = (source: string): readonly Section[] =>
  !source.includes('<div class="sheet guide">')
    ? []
    : Array.from(source.matchAll(/<h2 id="([^"]+)">([^<]*)<\/h2>/g), ([, id, title]) => ({
        id: id!,
        level: 2,
        title: title!,
      }));

/** A link to a file of the repository; its name, where the repository has no address yet. */
const repositoryLink = (file: string, words: string, repository: string): string =>
  repository === ''
    ? `${words} (<code>${file}</code> in the repository)`
    : `<a href="${repository}/blob/main/${file}">${words}</a>`;

/** What replaces the comments `<!-- name -->` and `<!-- name argument -->`. */
const generated: ReadonlyMap<string, (argument: string) => string> = new Map<
  string,
  (argument: string) => string
>([
  ['sizes', () => sizesHtml(dist)],
  ['texts', textsHtml],
  ['size', (name) => sizeOf(dist, `phong-viewer.${name}.js`)],
  [
    'pairs',
    () =>
      pairsHtml(JSON.parse(readFileSync(join(demo, 'models/models.json'), 'utf8')) as ModelEntries),
  ],
  ['pictures', () => picturesHtml(readResults(join(repository, 'tests/bench/results')))],
  ['scene', sceneHtml],
  ['page', () => escapeHtml(readmePage()).trim()],
  [
    'download',
    () =>
      `<p><a href="../../phong-viewer.classic.js" download>Download phong-viewer.classic.js</a> (${sizeOf(dist, 'phong-viewer.classic.js')} kB, compressed).</p>`,
  ],
  [
    'examples',
    () =>
      examplesHtml(
        JSON.parse(readFileSync(join(demo, 'examples/examples.json'), 'utf8')) as Example[],
        sceneHtml,
      ),
  ],
  ['front', (part) => (part === 'scene' ? frontScene() : escapeHtml(frontScene()))],
]);

/**
 * The README's scene, as the first screen shows it: in the page's size, its panel closed, and drawn
 * once for each change.
 */
const frontScene = (): string =>
  readmeSnippet()
    .replace(/ style="[^"]*"/, '')
    .replace(' antialias="full" gui', '')
    .replaceAll('\n  ', '\n');

/** The ready texts of a language, for a page in it. */
function textsHtml(language: string): string {
  const texts = JSON.stringify(textsIn(language), null, 2);
  return `<script type="application/json" data-phong-viewer-texts>${texts}</script>`;
}

/** A scene of the guide, or of the examples. */
function sceneHtml(name: string): string {
  const own = join(demo, 'guide/scenes', `${name}.html`);
  return readFileSync(existsSync(own) ? own : join(demo, 'scenes', `${name}.html`), 'utf8');
}

/**
 * A file of dist/ that `npm run manifest` writes; written now if the package has not been built.
 */
function readBuilt(name: string): string {
  const file = join(dist, name);
  if (!existsSync(file)) {
    mkdirSync(dist, { recursive: true });
    const { status } = spawnSync(process.execPath, [join(repository, '.ci/manifest.mjs')], {
      stdio: 'inherit',
    });
    if (status !== 0) throw new Error('npm run manifest failed');
  }
  return readFileSync(file, 'utf8');
}

function documentedAttributes(): Record<string, string[]> {
  const manifest = JSON.parse(readBuilt('custom-elements.json')) as Manifest;
  const entries = manifest.modules
    .flatMap((module) => module.declarations ?? [])
    .flatMap((declaration) =>
      'customElement' in declaration
        ? [
            [
              declaration.tagName ?? '',
              (declaration.attributes ?? []).map(({ name }) => name),
            ] as const,
          ]
        : [],
    );
  return Object.fromEntries(entries);
}

function packageFacts(): Facts {
  const { version, repository: source } = JSON.parse(
    readFileSync(join(repository, 'package.json'), 'utf8'),
  ) as {
    version: string;
    repository: { url: string };
  };
  const address = source.url.replace(/^git\+/, '').replace(/\.git$/, '');
  const [, owner = '', name = ''] = /\/([^/]+)\/([^/]+)$/.exec(address) ?? [];
  // A placeholder is an address for nobody.
  const published = owner !== 'OWNER';
  // GitHub Pages' address, unless the build is told another one.
  const site = process.env['SITE_URL'] || (published ? `https://${owner}.github.io/${name}` : '');
  return {
    version,
    repository: published ? address : '',
    site: site.replace(/\/*$/, site === '' ? '' : '/'),
  };
}

function sitemap(site: string): string {
  const urls = pagePaths().map((path) => `  <url><loc>${site}${path}</loc></url>`);
  return `<?xml version="1.0" encoding="UTF-8"?>
<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">
${urls.join('\n')}
</urlset>
`;
}
