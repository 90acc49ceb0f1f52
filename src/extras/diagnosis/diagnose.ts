// Explains markup that looks like a mistake, and its cure: once per mistake and page. Fetched when
// needed.
import { clip } from '../../phong/fields/clip.js';
import { nearest } from '../../phong/fields/nearest.js';
import { registryAround } from '../../viewer/element/child-registry.js';
import type { PhongViewer } from '../../viewer/element/elements.js';
import { isNamed } from '../../viewer/element/viewer/description.js';
import { strayAttributes, wrappedViewer } from '../../viewer/element/inspect.js';

const TAGS = ['phong-light', 'phong-mesh', 'phong-viewer'] as const;
/** Not for the inside of a viewer. */
const ALL_TAGS = [...TAGS, 'phong-compare'] as const;

/** The page's warnings. A page with more mistakes than this has one cause for most of them. */
const MOST = 100;
const given = new Set<string>();

export function diagnose(elements: readonly Element[]): void {
  const known = new Map<string, readonly string[]>();
  for (const tag of ALL_TAGS) {
    const definition = customElements.get(tag) as
      | { readonly observedAttributes?: readonly string[] }
      | undefined;
    known.set(tag, definition?.observedAttributes ?? []);
  }
  for (const element of elements) {
    const tag = element.localName;
    for (const name of strayAttributes(element)) {
      const advice = attributeAdvice(tag, name, known);
      if (advice !== undefined) {
        warn(`<${tag}> has no attribute ${clip(name)}. ${advice}`);
      }
    }
    if (!element.isConnected) continue;
    if (tag === 'phong-compare') {
      const wrapper = wrappedViewer(element)?.parentElement?.localName;
      if (wrapper !== undefined) {
        warn(
          `A <phong-viewer> in a <${clip(wrapper)}> inside a <phong-compare> is not shown. Make it a child of the <phong-compare>.`,
        );
      }
    } else if (tag === 'phong-viewer') {
      diagnoseContent(element);
      if (!isNamed(element as PhongViewer)) {
        warn(UNNAMED);
      }
    } else if (registryAround(element) === null) {
      warn(lonely(element));
    }
  }
}

const UNNAMED =
  'A <phong-viewer> has no alt. Write alt="…", the picture in words for people who do not see it, or alt="" if it is decoration.';

function diagnoseContent(viewer: Element): void {
  for (const { localName: tag } of viewer.querySelectorAll(':not(:defined)')) {
    if (!tag.startsWith('phong-')) continue;
    const meant = nearest(tag, TAGS) ?? 'phong-light> or <phong-mesh';
    warn(
      `<${clip(tag)}> inside a <phong-viewer>: there is no such element. Did you mean <${meant}>?`,
    );
  }
  const misplaced = viewer.querySelector(':is(phong-light, phong-mesh) > [slot]:not([slot=""])');
  if (misplaced !== null) {
    const { localName, slot, parentElement } = misplaced;
    warn(
      `<${clip(localName)} slot="${clip(slot)}"> is inside a <${parentElement?.localName ?? ''}>, so it is not shown. ` +
        `Write </${parentElement?.localName ?? ''}> before it.`,
    );
  }
  const cut = cutByMarkdown(viewer);
  const hidden = cut === 'code' ? 'its lights and meshes as code' : hiddenContent(viewer);
  if (hidden !== null) {
    warn(
      `<phong-viewer> contains ${hidden}, which is not shown. ${cut === null ? UNCLOSED : EMPTY_LINE}`,
    );
  }
}

const UNCLOSED =
  'HTML has no self-closed tags: write </phong-viewer> after the lights and meshes of each viewer.';

const EMPTY_LINE =
  'In Markdown an empty line ends the HTML: leave none between <phong-viewer> and </phong-viewer>.';

/**
 * What Markdown made of the content after an empty line: a paragraph, in which the parser ignores
 * the viewer's end tag, or code if the line was indented. Null if it was not Markdown.
 */
function cutByMarkdown(viewer: Element): 'paragraph' | 'code' | null {
  for (const code of viewer.querySelectorAll('pre > code')) {
    if (/<\/?phong-/.test(code.textContent)) return 'code';
  }
  return viewer.querySelector('p > :is(phong-light, phong-mesh)') === null ? null : 'paragraph';
}

function lonely(element: Element): string {
  const name = element.getAttribute('name') ?? '';
  const which = `<${element.localName}${name === '' ? '' : ` name="${clip(name)}"`}>`;
  // Pandoc's Markdown makes a paragraph of each part.
  const before = element.closest('p')?.previousElementSibling;
  if (before?.matches('p:has(phong-viewer)') === true) {
    return `${which} is not inside a <phong-viewer>, so it has no effect. ${EMPTY_LINE}`;
  }
  return element.closest('phong-viewer') === null
    ? `${which} is not inside a <phong-viewer>, so it has no effect. Move it into one.`
    : `${which} is inside an element with a slot, so it has no effect. Move it out of that element.`;
}

/** The first content of a viewer that a reader of the page should see, in words; null for none. */
function hiddenContent(viewer: Element): string | null {
  const walker = document.createTreeWalker(
    viewer,
    NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT,
    (node) => {
      const element = elementOf(node);
      if (element !== null && (element.matches(UNSEEN) || isSlotted(element, viewer))) {
        return NodeFilter.FILTER_REJECT;
      }
      const shown = element === null ? node.nodeValue?.trim() !== '' : element.matches(SHOWN);
      return shown ? NodeFilter.FILTER_ACCEPT : NodeFilter.FILTER_SKIP;
    },
  );
  // A viewer inside another is always a mistake. Other content before the end tag can be meant for
  // browsers without scripts. It was swallowed if nothing follows the viewer: an unclosed element
  // ends with its parent.
  let first: Node | null = null;
  for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
    if (node.nodeName === 'PHONG-VIEWER') return 'another <phong-viewer>';
    first ??= node;
  }
  if (first === null || !endsItsParent(viewer)) return null;
  return elementOf(first) !== null
    ? `<${first.nodeName.toLowerCase()}>`
    : `the text "${clip(first.nodeValue?.trim().replace(/\s+/g, ' ') ?? '')}"`;
}

/** Not by `instanceof`: another window has classes of its own. */
const elementOf = (node: Node | null): Element | null =>
  node?.nodeType === Node.ELEMENT_NODE ? (node as Element) : null;

const UNSEEN = 'script,style,template,noscript';

/** Elements that show something, whatever they contain. */
const SHOWN =
  'img,svg,canvas,video,audio,iframe,object,embed,button,input,select,textarea,hr,phong-viewer';

const isSlotted = (node: Element, viewer: Element): boolean =>
  node.slot !== '' && node.parentElement === viewer;

/**
 * Nothing follows but what scripts insert. Not even white space: the parser puts that inside an
 * unclosed element.
 */
function endsItsParent(viewer: Element): boolean {
  let next = viewer.nextSibling;
  while (elementOf(next)?.matches(`${UNSEEN},link`) === true) {
    next = next?.nextSibling ?? null;
  }
  return next === null;
}

function warn(message: string): void {
  if (given.has(message) || given.size >= MOST) return;
  given.add(message);
  console.warn(message);
}

type Advice = Readonly<Record<string, string>>;

const MATERIAL = 'color colour fill material albedo basecolor';
const SHAPE: Advice = {
  'Write geometry="box", or the name of another shape.': 'shape primitive mesh',
  'Write src="…".': 'model href url file path source',
  'Write shininess="…": larger values make smaller highlights.':
    'roughness gloss glossiness exponent smoothness',
  'Textures come with a model: write src="…".': 'texture map image',
};

/** For each tag, the advice and the attributes that it is given for. */
const GUESSES: Readonly<Record<string, Advice>> = {
  'phong-light': {
    'Write diffuse="…", and specular and ambient for the other terms.': 'color colour rgb hue tint',
    'Write larger or smaller values of diffuse, specular and ambient: 255 is full, more is brighter.':
      'intensity brightness power strength energy exposure',
    'Write position="x y z w": w = 1 for a place, w = 0 for a direction to the light.':
      'pos x y z w place location translation type kind direction',
    'Write axis="x y z": where the spot points.': 'target lookat rotation rotate orientation',
    'Write aperture="…": half the angle of the cone in degrees.': 'angle cone fov spread',
    'Write cutoff="…": the exponent of the decay away from the axis.':
      'penumbra exponent falloff softness',
    'Write attenuation="kc kl kq".':
      'distance range decay radius constant linear quadratic kc kl kq',
    'Write active="false" to turn the light off.': 'enabled disabled off visible',
  },
  'phong-mesh': {
    ...SHAPE,
    'Write ka="…", kd="…" and ks="…", the colours of the material.': MATERIAL,
    'Write ka="…".': 'ambient',
    'Write kd="…".': 'diffuse',
    'Write ks="…".': 'specular',
    'Write position="x y z".': 'pos x y z place location translation',
    'Write rotation="x y z" in degrees.': 'rotate rot orientation euler angle',
    'Write scale="…", one number or three.': 'size width height depth length radius',
  },
  'phong-viewer': {
    ...SHAPE,
    'CSS sets the size: write style="width: …; height: …".': 'width height size',
    'CSS sets the background: write style="background: …".': 'background bgcolor backgroundcolor',
    'Write ka="…", kd="…" and ks="…", the colours of the material; lights are <phong-light> elements inside.': `${MATERIAL} ambient diffuse specular`,
    'Write <phong-light> elements inside the viewer.': 'intensity brightness light lights',
    'Write theta, phi, radius and target, which place the camera.': 'camera eye pos position',
    'Write theta="…" in degrees.': 'azimuth yaw',
    'Write phi="…" in degrees from +y.': 'polar elevation pitch',
    'Write radius="…".': 'distance',
    'Write target="x y z".': 'lookat center centre',
    'Write auto-rotate="…" in degrees per second.': 'rotate rotation spin autoplay',
    'Write gui for the panel; dragging and the wheel work without it.': 'controls panel',
    'Write antialias="full".': 'antialiasing aa',
    'Write alt="…".': 'label description caption',
    'Write loading="lazy".': 'lazy',
  },
  'phong-compare': {
    'CSS sets the size: write style="width: …; height: …".': 'width height size',
    'Write layout="split" or layout="side".': 'mode type kind',
    'Write at="…": where the divider is, in percent.':
      'position pos value start offset percent split divider',
    'Write direction="vertical" for viewers from top to bottom.': 'vertical orientation axis',
    'Write labels="…", separated by commas.': 'label names captions titles',
  },
};

/**
 * HTML's global attributes without a `-`, and those of RDFa. They give no warning, even if they
 * resemble a name of this package.
 */
const GLOBAL = new Set(
  (
    'accesskey anchor autocapitalize autocorrect autofocus class contenteditable contextmenu dir draggable ' +
    'elementtiming enterkeyhint exportparts headingoffset headingreset hidden id inert inputmode is itemid itemprop ' +
    'itemref itemscope itemtype lang nonce part popover role slot spellcheck style tabindex title translate ' +
    'virtualkeyboardpolicy writingsuggestions xmlns about content datatype prefix property rel resource typeof vocab'
  ).split(' '),
);

/**
 * What to write instead of `attribute` on `tag`; undefined if it is probably no mistake. `known`:
 * by tag.
 */
export function attributeAdvice(
  tag: string,
  attribute: string,
  known: ReadonlyMap<string, readonly string[]>,
): string | undefined {
  if (GLOBAL.has(attribute)) return undefined;
  for (const [advice, guesses] of Object.entries(GUESSES[tag] ?? {})) {
    if (guesses.split(' ').includes(attribute)) return advice;
  }
  const owners = [...known.keys()].filter(
    (other) => known.get(other)?.includes(attribute) === true,
  );
  // A viewer's `name` may be the page's own.
  if (owners.length > 0 && attribute !== 'name') {
    return `It belongs to <${owners.join('> and <')}>.`;
  }
  const meant = nearest(attribute, known.get(tag) ?? []);
  return meant === undefined ? undefined : `Did you mean ${meant}?`;
}
