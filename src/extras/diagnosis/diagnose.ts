// Explains markup that looks like a mistake, and its cure: once per mistake and page. Fetched when
// needed.
import { clip } from '../../phong/fields/clip.js';
import { nearest } from '../../phong/fields/nearest.js';
import { radians } from '../../phong/math/angle.js';
import {
  fieldsOf,
  type MistakeTests,
  type PhongLight,
  type PhongViewer,
} from '../../viewer/extra.js';

const TAGS = ['phong-light', 'phong-mesh', 'phong-viewer'] as const;
/** Not for the inside of a viewer. */
const ALL_TAGS = [...TAGS, 'phong-compare'] as const;

/** The page's warnings. A page with more mistakes than this has one cause for most of them. */
const MOST = 100;
const given = new Set<string>();

export function diagnose(elements: readonly Element[], tests: MistakeTests): void {
  const attributesByTag = new Map<string, readonly string[]>();
  for (const tag of ALL_TAGS) {
    const definition = customElements.get(tag) as
      | { readonly observedAttributes?: readonly string[] }
      | undefined;
    attributesByTag.set(tag, definition?.observedAttributes ?? []);
  }
  for (const element of elements) {
    const tag = element.localName;
    const strays = tests.strayAttributes(element);
    const quoted = quoteAdvice(element, strays);
    if (quoted !== undefined) {
      warn(quoted); // the other strays are words of the value
    } else {
      for (const name of strays) {
        const advice = attributeAdvice(tag, name, attributesByTag);
        if (advice !== undefined) {
          warn(`<${tag}> has no attribute ${clip(name)}. ${advice}`);
        }
      }
    }
    diagnoseUnits(element, tests);
    if (!element.isConnected) continue;
    if (tests.isFlat(element)) {
      setTimeout(() => diagnoseSize(element, tests), SIZE_MS);
    }
    if (tag === 'phong-compare') {
      const wrapper = tests.wrappedViewer(element)?.parentElement?.localName;
      if (wrapper !== undefined) {
        warn(
          `A <phong-viewer> in a <${clip(wrapper)}> inside a <phong-compare> is not shown. Make it a child of the <phong-compare>.`,
        );
      }
    } else if (tag === 'phong-viewer') {
      diagnoseContent(element);
      if (!tests.isNamed(element as HTMLElementTagNameMap['phong-viewer'])) {
        warn(UNNAMED);
      }
    } else if (tests.registryAround(element) === null) {
      warn(lonely(element));
    }
  }
}

/** Values as OpenGL, three.js and MTL files write them, which are nearly black here. */
function diagnoseUnits(element: Element, tests: MistakeTests): void {
  const values = fieldsOf(element as PhongLight).store.values as unknown as Values;
  const text = (name: string): string => element.getAttribute(name) ?? [values[name]].join(' ');
  const dim = tests.dimValues(element);
  const colors = dim.filter((name) => name !== 'aperture');
  const written = colors.map((name) => `${name}="${clip(text(name))}"`).join(' ');
  // CSS colours are of the right range whatever they say.
  if (colors.length > 0 && !colors.some((name) => /#|[a-df-z]/i.test(text(name)))) {
    const full = colors.map((name) => {
      const color = (values[name] as readonly number[]).map((value) => Math.round(value * 255));
      return `${name}="${(new Set(color).size === 1 ? color.slice(0, 1) : color).join(' ')}"`;
    });
    warn(
      `<${element.localName} ${written}> is nearly black, as 255 is full. For colours from 0 to 1 write ${full.join(' ')}.`,
    );
  }
  if (dim.length > colors.length) {
    const degrees = Number(((values['aperture'] as number) / radians(1)).toPrecision(4));
    warn(
      `<${element.localName} aperture="${clip(text('aperture'))}"> is a cone narrower than a degree. ` +
        `Angles are in degrees: for radians write aperture="${degrees}".`,
    );
  }
}

type Values = Readonly<Record<string, number | readonly number[]>>;

const QUOTE = /[\p{Pi}\p{Pf}\u201a\u201e]/u;

/**
 * The advice where a value is written in curly quotes, which are letters to HTML. An `alt` may
 * quote a title.
 */
function quoteAdvice(element: Element, strays: readonly string[]): string | undefined {
  const quoted = strays.filter((name) => {
    const text = element.getAttribute(name)!;
    return QUOTE.test(text) && !(name === 'alt' && QUOTE.test(text.slice(1)));
  });
  const [first] = quoted;
  if (first === undefined) return undefined;
  return (
    `<${element.localName} ${clip(first)}=${clip(element.getAttribute(first)!)}> has curly quotes, which HTML takes for letters. ` +
    `Write straight ones: ${quoted.map((name) => `${clip(name)}="…"`).join(' ')}.`
  );
}

/** Pages that size elements by script do so within this time after they appear. */
const SIZE_MS = 500;

/** Why a viewer or a comparison has no size, unless something around it is closed. */
function diagnoseSize(element: Element, tests: MistakeTests): void {
  const { localName: tag, parentElement: around } = element;
  if (!tests.isFlat(element)) return;
  if (around !== null && (tests.isCollapsed(around) || around.localName === 'phong-compare'))
    return;
  const { display } = getComputedStyle(element);
  if (display === 'inline' || display === 'contents') {
    warn(`<${tag}> has display: ${display}, which has no size. Write display: block.`);
    return;
  }
  // What had a size, such as a part of a page that closes, is no mistake.
  const { stats } = element as Partial<PhongViewer>;
  if (Number(stats?.frames) > 0) return;
  const side = element.clientHeight === 0 ? 'height' : 'width';
  // What is declared, not its pixels; Firefox does not say it.
  const { computedStyleMap } = element as Partial<Element>;
  const declared = computedStyleMap?.call(element).get(side)?.toString() ?? '';
  let cause = '';
  if (declared === 'auto') {
    cause = `${side}: auto is 0, as it has no content. `;
  } else if (declared.includes('%')) {
    cause = `${side}: ${declared} is 0, as the element around it has no ${side}. `;
  } else if (around !== null && getComputedStyle(around).display.includes('flex')) {
    cause = `The flex container around it leaves it none. `;
  }
  warn(
    `<${tag}> has the ${side} 0, so nothing is seen. ${cause}Set a ${side} in CSS, such as ${side}: 300px.`,
  );
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
    const around = parentElement!.localName;
    warn(
      `<${clip(localName)} slot="${clip(slot)}"> is inside a <${around}>, so it is not shown. Write </${around}> before it.`,
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

const MATERIAL =
  'color colour fill material albedo basecolor diffusecolor specularcolor emissivecolor';
const SHAPE: Advice = {
  'Write geometry="box", or the name of another shape.': 'shape primitive mesh',
  'Write src="…".': 'model href url file path source',
  'Write shininess="…": larger values make smaller highlights.':
    'roughness gloss glossiness exponent smoothness',
  'Textures come with a model: write src="…".': 'texture map image normalmap variantname',
  'Shapes are opaque; a model brings its own opacity: write src="…".': 'opacity alpha transparent',
  'Write shading="phong", "gouraud" or "flat".': 'flatshading smooth smoothing',
  'There are no shadows.': 'shadow castshadow receiveshadow shadowintensity shadowsoftness',
  'A surface reflects the <phong-light> elements only; ks="…" and shininess="…" set how.':
    'metalness metallic reflectivity envmap environmentimage environment skyboximage',
};

/**
 * For each tag, the advice and the attributes that it is given for: also those of <model-viewer>,
 * OpenGL, X3D and three.js. Without hyphens, which do not count.
 */
const GUESSES: Readonly<Record<string, Advice>> = {
  'phong-light': {
    'Write diffuse="…", and specular and ambient for the other terms.':
      'color colour rgb hue tint lightcolor diffusecolor',
    'Write larger or smaller values of diffuse, specular and ambient: 255 is full, more is brighter.':
      'intensity brightness power strength energy exposure diffuseintensity ambientintensity',
    'Write position="x y z w": w = 1 for a place, w = 0 for a direction to the light.':
      'pos x y z w place location translation type kind direction lightposition lightdirection',
    'Write axis="x y z": where the spot points.':
      'target lookat rotation rotate orientation spotdirection',
    'Write aperture="…": half the angle of the cone in degrees.':
      'angle cone fov spread spotcutoff cutoffangle coneangle beamwidth',
    'Write cutoff="…": the exponent of the decay away from the axis.':
      'penumbra exponent falloff softness spotexponent',
    'Write attenuation="kc kl kq".':
      'distance range decay radius constant linear quadratic kc kl kq constantattenuation linearattenuation quadraticattenuation',
    'Write active="false" to turn the light off.': 'enabled disabled off visible on',
    'There are no shadows.': 'shadow castshadow shadowintensity',
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
    'CSS sets the background: write style="background: …".':
      'background bgcolor backgroundcolor clearcolor skybox skyboxcolor',
    'Write ka="…", kd="…" and ks="…", the colours of the material; lights are <phong-light> elements inside.': `${MATERIAL} ambient diffuse specular`,
    'Write <phong-light> elements inside the viewer; larger values of their colours are brighter.':
      'intensity brightness light lights exposure lightintensity environmentintensity environmentlighting',
    'Colours are written as the equation gives them: nothing maps tones.': 'tonemapping',
    'Write theta="…" and phi="…" in degrees, and radius="…", which place the eye.':
      'cameraorbit orbitcontrols mincameraorbit maxcameraorbit',
    'Write theta, phi, radius and target, which place the camera.':
      'camera eye pos position cameraposition',
    'Write fov="…", the vertical angle in degrees.':
      'fieldofview minfieldofview maxfieldofview angle viewangle',
    'Write orbit="false" or zoom="false" to turn off dragging or the wheel.':
      'disablezoom disablepan disabletap enablezoom enablepan enableorbit enablerotate controlsdisabled',
    'Write loading="eager", "lazy" or "auto".': 'reveal preload',
    'Write crossorigin="use-credentials".': 'withcredentials',
    'There is no augmented reality.': 'ar armodes arscale arplacement iossrc xr vr xrenvironment',
    'Write theta="…" in degrees.': 'azimuth yaw',
    'Write phi="…" in degrees from +y.': 'polar elevation pitch',
    'Write radius="…".': 'distance',
    'Write target="x y z".': 'lookat center centre cameratarget',
    'Write auto-rotate="…" in degrees per second.':
      'rotate rotation spin rotationspeed rotationpersecond autorotatespeed autorotatedelay',
    'Dragging and the wheel work without it. Write gui for the panel.':
      'controls panel cameracontrols interactionprompt',
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
 * HTML's global attributes, and those of RDFa. They give no warning, even if they
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
  attributesByTag: ReadonlyMap<string, readonly string[]>,
): string | undefined {
  if (GLOBAL.has(attribute)) return undefined;
  const word = attribute.replaceAll('-', '');
  for (const [advice, guesses] of Object.entries(GUESSES[tag] ?? {})) {
    if (guesses.split(' ').includes(word)) return advice;
  }
  const owners = [...attributesByTag.keys()].filter(
    (other) => attributesByTag.get(other)?.includes(attribute) === true,
  );
  // A viewer's `name` may be the page's own.
  if (owners.length > 0 && attribute !== 'name') {
    return `It belongs to <${owners.join('> and <')}>.`;
  }
  const meant = nearest(attribute, attributesByTag.get(tag) ?? []);
  return meant === undefined ? undefined : `Did you mean ${meant}?`;
}
