// A scene for elsewhere: as the markup of a frame, or as one HTML file with the script and all
// files inside. Text in, text out; files are fetched from this site, and from hosts that the user
// has allowed.
import { fragmentOf } from './address.js';
import { markupOf } from '../parts/markup.js';
import { sceneElement, type Scene } from './scene.js';

const LINE_LENGTH = 76;

/** The scene as markup, its files named by `rename`. */
function markup(scene: Scene, rename: (source: string) => string): string {
  const element = sceneElement(scene);
  if (element === null) return '';
  for (const one of [element, ...element.querySelectorAll('*')]) {
    for (const name of ['src', 'poster']) {
      const source = one.getAttribute(name);
      if (source !== null) {
        one.setAttribute(name, rename(source));
      }
    }
  }
  return markupOf(element, LINE_LENGTH)
    .map(({ text }) => text)
    .join('');
}

const titleOf = (scene: Scene): string => scene.elements[0]?.attributes.get('alt') ?? 'A scene';

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/**
 * An `<iframe>` that shows the scene. @param page the address of the playground, next to whose
 * folder embed.html is.
 */
export async function frameOf(scene: Scene, page: string): Promise<string> {
  const embed = new URL('../embed.html', page);
  const folder = new URL('.', embed).href;
  const text = markup(scene, (source) => new URL(source, page).href.replace(folder, ''));
  const address = `${embed.href}${await fragmentOf(text)}`;
  return `<iframe src="${address}" title="${escaped(titleOf(scene))}" width="640" height="400" style="border: 0" loading="lazy" allowfullscreen></iframe>`;
}

/**
 * Media types by the end of a file's name: a page opened from disk has no server that tells them.
 */
const MEDIA: Readonly<Record<string, string>> = {
  glb: 'model/gltf-binary',
  gltf: 'model/gltf+json',
  obj: 'model/obj',
  stl: 'model/stl',
  ply: 'model/ply',
};

/** One page that needs nothing else. Throws a sentence if a file cannot be put inside. */
export async function fileOf(scene: Scene, page: string): Promise<string> {
  const script = await textOf(new URL('../phong-viewer.classic.js', page));
  const sources = new Set(
    [scene.elements, ...scene.others]
      .flat()
      .flatMap(({ attributes }) => [attributes.get('src'), attributes.get('poster')]),
  );
  const inside = new Map<string, string>();
  for (const source of sources) {
    if (source) {
      inside.set(source, await dataUrl(new URL(source, page)));
    }
  }
  const text = markup(scene, (source) => inside.get(source) ?? source);
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(titleOf(scene))}</title>
<style>
  html, body { height: 100%; margin: 0 }
  phong-viewer, phong-compare { display: block; width: 100%; height: 100% }
</style>
<script>${script.replaceAll(/<(?=\/script|!--|script)/gi, '\\x3c')}</script>

${text}
</html>
`;
}

async function answer(address: URL): Promise<Response> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address.pathname} cannot be fetched.`);
  return response;
}

const textOf = async (address: URL): Promise<string> => (await answer(address)).text();

async function dataUrl(address: URL): Promise<string> {
  const bytes = await (await answer(address)).arrayBuffer();
  const ending = /\.(\w+)$/.exec(address.pathname)?.[1]?.toLowerCase() ?? '';
  if (namesFiles(ending, bytes)) {
    throw new Error(`${address.pathname} names other files: use a .glb file.`);
  }
  const type = MEDIA[ending] ?? '';
  return new Promise((resolve) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => resolve(reader.result as string));
    reader.readAsDataURL(new Blob([bytes], { type }));
  });
}

/** Files that a model names are fetched beside it, and a data: URL has nothing beside it. */
function namesFiles(ending: string, bytes: ArrayBuffer): boolean {
  if (ending !== 'gltf' && ending !== 'obj') return false;
  const text = new TextDecoder().decode(bytes);
  return ending === 'obj' ? /^mtllib /m.test(text) : /"uri"\s*:\s*"(?!data:)/.test(text);
}
