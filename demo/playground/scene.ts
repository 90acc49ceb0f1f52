// Reads the scene that a text describes. The text may come from a stranger's link, so it is parsed
// into a document that runs and fetches nothing; only the package's elements and their documented
// attributes are kept. Knows no viewer.
import attributes from 'virtual:attributes';
import { didYouMean } from '../../src/phong/fields/nearest.js';
import { MOST_TAGS, tagCount } from '../../src/extras/png/tags.js';
import { LONGEST_TEXT } from './address.js';
import { sourceKind } from './sources.js';

export interface SceneElement {
  readonly tag: string;
  readonly attributes: ReadonlyMap<string, string>;
}

export interface Scene {
  /** The viewer first, then its lights and meshes in document order. */
  readonly elements: readonly SceneElement[];
  /** The comparison around the viewer; null if it stands alone. */
  readonly comparison: SceneElement | null;
  /** The other viewers of the comparison, each with its lights and meshes. */
  readonly others: readonly (readonly SceneElement[])[];
  /** What the text contains besides, as sentences for the user. At most {@link MOST_MESSAGES}. */
  readonly leftOut: readonly string[];
  /** Origins of other hosts that the scene wants to load files from. */
  readonly hosts: readonly string[];
}

/** Triangles of a scene, far more than a person writes: 0.23 GB. */
export const MOST_TRIANGLES = 2 ** 22;
/** The same in estimated bytes, images included: as much as one viewer may take. */
export const MOST_MEMORY = 950_000_000;
/** Viewers of a comparison. */
const MOST_VIEWERS = 4;
const MOST_MESSAGES = 5;
/** Characters of a name in a message. */
const LONGEST_NAME = 40;

const HTML = 'http://www.w3.org/1999/xhtml';
const VIEWER = 'phong-viewer';
const COMPARISON = 'phong-compare';
const documented: ReadonlyMap<string, ReadonlySet<string>> = new Map(
  Object.entries(attributes).map(([tag, names]) => [tag, new Set(names)]),
);
/** Attributes that make the browser fetch something. */
const LOADING = new Set(['src', 'poster']);

/** The scene, or a sentence that says why there is none. */
export function readScene(text: string, base: string): Scene | string {
  if (text.length > LONGEST_TEXT) {
    return `The markup is too long to show: at most ${LONGEST_TEXT.toLocaleString('en')} characters.`;
  }
  if (tagCount(text) > MOST_TAGS) {
    return `The markup has too many elements to show: at most ${MOST_TAGS.toLocaleString('en')}.`;
  }
  const parsed = new DOMParser().parseFromString(text, 'text/html');
  const viewer = [...parsed.getElementsByTagName(VIEWER)].find(isHtml);
  if (viewer === undefined) return 'Write a <phong-viewer> to see a picture.';
  const reader = new SceneReader(base);
  reader.readAround(parsed, viewer);
  const elements = reader.readViewer(viewer);
  const { comparison, others } = reader.readComparison(viewer);
  const found = { leftOut: reader.sentences(), hosts: [...reader.hosts] };
  return { elements, comparison, others, ...found };
}

const isHtml = (element: Element): boolean => element.namespaceURI === HTML;

class SceneReader {
  readonly hosts = new Set<string>();
  readonly #base: string;
  /** What, and its name with those that may be meant. */
  readonly #leftOut = new Map<string, readonly [name: string, known: Iterable<string>]>();

  constructor(base: string) {
    this.#base = base;
  }

  /** Names what stands outside the viewer. */
  readAround(parsed: Document, viewer: Element): void {
    for (const element of parsed.querySelectorAll('head > *, body > *')) {
      if (!element.contains(viewer)) {
        this.#leave(`<${clipped(element.localName)}>`);
      }
    }
  }

  /** What is around the first viewer, if it is a comparison. */
  readComparison(viewer: Element): Pick<Scene, 'comparison' | 'others'> {
    const compare = viewer.closest(COMPARISON);
    if (compare === null) return { comparison: null, others: [] };
    const others = [...compare.children].filter((child) => {
      if (child.localName !== VIEWER) {
        this.#leave(`<${clipped(child.localName)}>`);
      }
      return child.localName === VIEWER && child !== viewer;
    });
    if (others.length >= MOST_VIEWERS) {
      this.#leave(`viewers after ${String(MOST_VIEWERS)}`);
    }
    return {
      comparison: this.#kept(compare),
      others: others.slice(0, MOST_VIEWERS - 1).map((other) => this.readViewer(other)),
    };
  }

  readViewer(viewer: Element): readonly SceneElement[] {
    const elements = [this.#kept(viewer)];
    const filter = (node: Node): number => this.#filter(node as Element);
    const walker = viewer.ownerDocument.createTreeWalker(viewer, NodeFilter.SHOW_ELEMENT, filter);
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      elements.push(this.#kept(node as Element));
    }
    return elements;
  }

  sentences(): readonly string[] {
    const all = [...this.#leftOut];
    const shown = all
      .slice(0, MOST_MESSAGES)
      .map(([what, [name, known]]) => `Left out: ${what}.${didYouMean(clipped(name), [...known])}`);
    const more = all.length - shown.length;
    return more > 0 ? [...shown, `And ${String(more)} more.`] : shown;
  }

  #filter(element: Element): number {
    const { localName } = element;
    const known = isHtml(element) && documented.has(localName);
    if (known && localName !== VIEWER && localName !== COMPARISON) return NodeFilter.FILTER_ACCEPT;
    this.#leave(`<${clipped(localName)}>`, localName, documented.keys());
    // Lights may stand in wrappers. Those of another viewer belong to it.
    return localName === VIEWER ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_SKIP;
  }

  #kept(element: Element): SceneElement {
    const tag = element.localName;
    const names = documented.get(tag);
    const kept = new Map<string, string>();
    for (const { name, value } of element.attributes) {
      if (names?.has(name) !== true) {
        this.#leave(`${clipped(name)} of <${tag}>`, name, names);
      } else if (!LOADING.has(name) || this.#mayLoad(name, value, tag)) {
        kept.set(name, value);
      }
    }
    return { tag, attributes: kept };
  }

  #mayLoad(name: string, value: string, tag: string): boolean {
    const kind = sourceKind(value, this.#base);
    if (kind === 'refused') {
      this.#leave(`${name} of <${tag}>: files are loaded by http: and https: only`);
      return false;
    }
    if (kind !== 'own') {
      this.hosts.add(kind.host);
    }
    return true;
  }

  #leave(what: string, name = '', known: Iterable<string> = []): void {
    this.#leftOut.set(what, [name, known]);
  }
}

const clipped = (name: string): string =>
  name.length > LONGEST_NAME ? `${name.slice(0, LONGEST_NAME)}…` : name;

/** The scene as one element of a document that runs nothing, to be written as markup. */
export function sceneElement(scene: Scene): Element | null {
  const inert = document.implementation.createHTMLDocument('');
  const build = ({ tag, attributes: all }: SceneElement): HTMLElement => {
    const element = inert.createElement(tag);
    for (const [name, value] of all) {
      element.setAttribute(name, value);
    }
    return element;
  };
  const viewers = [scene.elements, ...scene.others].map((elements) => {
    const [viewer, ...children] = elements.map(build);
    viewer?.append(...children);
    return viewer!;
  });
  if (scene.comparison === null) return viewers[0] ?? null;
  const compare = build(scene.comparison);
  compare.append(...viewers);
  return compare;
}

/** The files that the scene loads. */
export const sourcesOf = ({ elements, others }: Scene): readonly string[] =>
  [elements, ...others]
    .flat()
    .flatMap(({ attributes: all }) => [...all].filter(([name]) => LOADING.has(name)))
    .map(([, source]) => source);

/** The scene without the files of other hosts, unless the user has allowed these. */
export function withoutHosts(scene: Scene, allowed: ReadonlySet<string>, base: string): Scene {
  const permitted = ({ tag, attributes: all }: SceneElement): SceneElement => ({
    tag,
    attributes: new Map(
      [...all].filter(([name, value]) => {
        if (!LOADING.has(name)) return true;
        const kind = sourceKind(value, base);
        return kind === 'own' || (kind !== 'refused' && allowed.has(kind.host));
      }),
    ),
  });
  return {
    ...scene,
    elements: scene.elements.map(permitted),
    others: scene.others.map((other) => other.map(permitted)),
  };
}
