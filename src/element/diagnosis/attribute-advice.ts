// What to write instead of an attribute that does not exist: a table of usual guesses, names that belong to another
// element, and misspelled names. Knows the elements by their tags and attribute names only.
import { nearest } from '../../fields/nearest.js';

type Advice = Readonly<Record<string, string>>;

const MATERIAL = 'color colour fill material albedo basecolor';
const SHAPE: Advice = {
  'Write geometry="box", or the name of another shape.': 'shape primitive mesh',
  'Write src="…".': 'model href url file path source',
  'Write shininess="…": larger values make smaller highlights.': 'roughness gloss glossiness exponent smoothness',
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
    'Write cutoff="…": the exponent of the decay away from the axis.': 'penumbra exponent falloff softness',
    'Write attenuation="kc kl kq".': 'distance range decay radius constant linear quadratic kc kl kq',
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
    'Write at="…": where the divider is, in percent.': 'position pos value start offset percent split divider',
    'Write direction="vertical" for viewers from top to bottom.': 'vertical orientation axis',
    'Write labels="…", separated by commas.': 'label names captions titles',
  },
};

/**
 * HTML's global attributes without a `-`, and those of RDFa. They give no warning, even if they resemble a name of this
 * package.
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
 * What to write instead of `attribute` on `tag`; undefined if it is probably no mistake. `known`: attributes by tag.
 */
export function attributeAdvice(
  tag: string,
  attribute: string,
  known: ReadonlyMap<string, readonly string[]>,
): string | undefined {
  if (GLOBAL.has(attribute)) return undefined;
  for (const [advice, guesses] of Object.entries(GUESSES[tag] ?? {}))
    if (guesses.split(' ').includes(attribute)) return advice;
  const owners = [...known.keys()].filter((other) => known.get(other)?.includes(attribute) === true);
  // A viewer's `name` may be the page's own.
  if (owners.length > 0 && attribute !== 'name') return `It belongs to <${owners.join('> and <')}>.`;
  const meant = nearest(attribute, known.get(tag) ?? []);
  return meant === undefined ? undefined : `Did you mean ${meant}?`;
}
