// Opens the scene that a PNG file holds in a viewer, as one step of undo. The file may come from a
// stranger, so the playground's rules apply: its markup is parsed into a document that runs and
// fetches nothing, only lights, meshes and their own attributes are built, and they load files of
// the page's site only.
import { fieldsOf, historyOf, type PhongViewer, type ValuesByTag } from '../../viewer/extra.js';
import { SIGNATURE } from './chunks.js';
import { markupIn, PngTextError } from './read-text.js';
import { MOST_TAGS, tagCount } from './tags.js';

/** Which values say what a page lets its users do, and how it loads: they stay. */
const OF_THE_PAGE: Readonly<Record<keyof ValuesByTag['phong-viewer'], boolean>> = {
  src: false,
  type: false,
  geometry: false,
  segments: false,
  autoplay: false,
  animationName: false,
  ka: false,
  kd: false,
  ks: false,
  shininess: false,
  alt: false,
  poster: true,
  loading: true,
  droppable: true,
  crossOrigin: true,
  theta: false,
  phi: false,
  radius: false,
  target: false,
  fov: false,
  orbit: true,
  zoom: true,
  autoRotate: false,
  shading: false,
  reflection: false,
  terms: false,
  colorInterpolation: false,
  antialias: false,
  samples: false,
  pixelRatio: true,
  helpers: false,
  view: false,
  viewLight: false,
  probe: false,
  probeAt: false,
  cameraGroup: true,
  gui: true,
};

/**
 * What opens the scene of this file in a viewer; null where it is no PNG.
 * @throws PngTextError for a PNG without a scene that can be opened.
 */
export async function sceneOpener(file: Blob): Promise<((viewer: HTMLElement) => void) | null> {
  const start = new Uint8Array(await file.slice(0, SIGNATURE.length).arrayBuffer());
  if (!SIGNATURE.every((byte, i) => start[i] === byte)) return null;
  const markup = await markupIn(file);
  if (tagCount(markup) > MOST_TAGS) throw new PngTextError('too-large');
  const declared = parsed(markup).querySelector('phong-viewer');
  if (declared === null) throw new PngTextError('none');
  const children = [...declared.querySelectorAll('phong-light, phong-mesh')].filter(
    (child) => child.closest('phong-viewer') === declared,
  );
  return (viewer) => open(viewer as PhongViewer, declared, children);
}

function open(viewer: PhongViewer, declared: Element, children: readonly Element[]): void {
  const history = historyOf(viewer);
  history.edit([history.children, viewer, history.camera], () => {
    for (const child of [...viewer.lights, ...viewer.meshes]) {
      child.remove();
    }
    const { store } = fieldsOf(built(declared) as PhongViewer);
    const own = fieldsOf(viewer);
    for (const key of Object.keys(store.fields) as (keyof typeof store.fields)[]) {
      if (!OF_THE_PAGE[key]) {
        own.set(key, store.given(key) ? store.values[key] : null);
      }
    }
    viewer.append(...children.map(built));
    viewer.resetCamera();
  });
}

/** An element of the page with the attributes that it knows. */
function built({ localName, attributes }: Element): HTMLElement {
  const made = document.createElement(localName);
  const { observedAttributes } = made.constructor as unknown as {
    readonly observedAttributes: readonly string[];
  };
  for (const { name, value } of attributes) {
    // Names as ARIA has them belong to the page's own text.
    if (!observedAttributes.includes(name) || name.startsWith('aria') || name === 'poster')
      continue;
    if (name === 'src' && !isOwn(value)) {
      console.warn(
        `<${localName} src=${JSON.stringify(value.slice(0, 100))}> of the picture is left out: its scene loads files of this site only.`,
      );
      continue;
    }
    made.setAttribute(name, value);
  }
  return made;
}

function isOwn(address: string): boolean {
  if (!URL.canParse(address, document.baseURI)) return false;
  const { protocol, origin } = new URL(address, document.baseURI);
  // Checked too: the origin of a `blob:` address is this site's.
  return /^https?:$/.test(protocol) && origin === location.origin;
}

interface Policy {
  readonly createHTML: (text: string) => string;
}

let policy: Policy | undefined;

/** Where a page demands Trusted Types, it has to allow the policy `phong-viewer`. */
function parsed(markup: string): Document {
  try {
    const { trustedTypes } = globalThis as {
      readonly trustedTypes?: { createPolicy(name: string, rules: Policy): Policy };
    };
    policy ??= trustedTypes?.createPolicy('phong-viewer', { createHTML: (text) => text });
  } catch {
    // The page has a list of policies. It need not demand one here.
  }
  try {
    return new DOMParser().parseFromString(policy?.createHTML(markup) ?? markup, 'text/html');
  } catch {
    throw new PngTextError('refused');
  }
}
