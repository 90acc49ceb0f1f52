// @ts-check
// What `npm run bench` measures, by name. A subject has sides (the element, plain three.js, …) that
// are measured in turns; the last side is the one that the others are divided by.

import { FIRST_MODELS, MODELS } from './models.mjs';

/**
 * @typedef {import('./pages/frame.js').SideName} SideName
 *
 * @typedef {object} FrameSubject frame times of one scene: first frames, take-over, settled
 * @property {'frames'} kind
 * @property {string} scene of pages/scenes.ts
 * @property {readonly SideName[]} sides
 *
 * @typedef {object} ScriptSubject the page's own CPU time per frame, on a canvas so small that
 * drawing costs nothing
 * @property {'script'} kind
 * @property {string} scene
 * @property {readonly SideName[]} sides
 *
 * @typedef {object} StartSubject from navigation to the first picture, and the heap then
 * @property {'start'} kind
 * @property {Readonly<Record<string, string>>} pages by side
 * @property {boolean} [pageSays] the page itself says when its pictures are there
 *
 * @typedef {object} ModelSubject from navigation to the first picture of a model file, next to
 * other viewers
 * @property {'model'} kind
 * @property {string} file in the folder that models.mjs fills
 * @property {boolean} slow over 10 Mbit/s; otherwise from this machine
 * @property {Readonly<Record<string, string>>} pages by side
 *
 * @typedef {object} PictureSubject error of a whole picture over the time it takes
 * @property {'picture'} kind
 * @property {import('./pages/picture-scenes.js').PictureName} scene
 * @property {boolean} round it is compared with its round shape too
 *
 * @typedef {object} StillSubject from a change to the picture of 64 samples, on a page that draws
 * in its own animation frames
 * @property {'still'} kind
 * @property {string} geometry
 * @property {readonly [number, number]} [size] pixels; without, those of the stack
 *
 * @typedef {object} MovingSubject CPU time of a picture that moves, with all pixels and as the
 * element chooses, where a processor draws
 * @property {'moving'} kind
 * @property {'lights' | 'shapes'} scene much to do for a pixel, or many triangles: README's scene
 * @property {number} ratio device pixels per CSS pixel
 *
 * @typedef {{ kind: 'viewers' } | { kind: 'bytes' }} SingleSubject
 * @typedef {FrameSubject | ScriptSubject | StartSubject | ModelSubject | PictureSubject |
 * StillSubject | MovingSubject | SingleSubject} Subject
 */

/** @type {readonly SideName[]} */
const PAIR = ['element', 'three'];

/** @param {string} scene @param {readonly SideName[]} [sides] @returns {FrameSubject} */
const frames = (scene, sides = PAIR) => ({ kind: 'frames', scene, sides });
/** @param {string} scene @param {readonly SideName[]} [sides] @returns {ScriptSubject} */
const script = (scene, sides = PAIR) => ({ kind: 'script', scene, sides });

/** @param {string} scene @returns {StartSubject} */
const startBoxes = (scene) => ({
  kind: 'start',
  pages: {
    element: `start-boxes-element.html?scene=${scene}`,
    three: `start-boxes-three.html?scene=${scene}`,
  },
});

/**
 * Whole pictures by the end of their subject's name: the scene, and whether it has a round shape to
 * compare with.
 */
export const PICTURES = /** @type {const} */ ({
  sphere: ['sphere', true],
  torus: ['torus', true],
  'torus, shininess 2,000': ['shiny-torus', false],
  'teapot on a floor': ['teapot', false],
  'textured GLB': ['glb', false],
  'nine viewers': ['nine', false],
});
/** @param {keyof typeof PICTURES} picture */
export const pictureSubject = (picture) => `whole picture, ${picture}`;

/** @param {number} count */
const lights = (count) => (count === 1 ? '1 light' : `${count} lights`);

/** Lights of the sphere that fills the view, as in the table of aims. */
export const SPHERE_LIGHTS = [1, 4, 8, 16, 32, 128, 256];
export const FRAMED_LIGHTS = [8, 32];
export const FRAMED_SHAPES = /** @type {const} */ (['sphere', 'torus', 'teapot']);
/**
 * Pictures whose 64 samples are timed. @type {Readonly<Record<string, Omit<StillSubject, 'kind'>>>}
 */
export const STILL = {
  sphere: { geometry: 'sphere' },
  'sphere, 760 × 420': { geometry: 'sphere', size: [760, 420] },
  teapot: { geometry: 'teapot' },
  'teapot, 760 × 420': { geometry: 'teapot', size: [760, 420] },
};
export const stillSubject = (/** @type {string} */ picture) => `still ${picture}`;
/** @param {(typeof FRAMED_SHAPES)[number]} shape @param {number} count */
export const framedSubject = (shape, count) => `${shape} framed by default, ${lights(count)}`;

/** How a model reaches the page, as a part of a subject's name. */
export const NETWORKS = /** @type {const} */ (['local', '10 Mbit/s']);
/** @param {string} model @param {(typeof NETWORKS)[number]} network */
export const modelSubject = (model, network) => `model, ${model}, ${network}`;
/** All models over one network. @param {(typeof NETWORKS)[number]} network */
export const modelSubjects = (network) =>
  Object.keys(MODELS).map((model) => modelSubject(model, network));
/** @param {string} model */
export const firstModelSubject = (model) =>
  `first picture of models against three's page, ${model}`;
const MODEL_PAGES = {
  element: 'start-model-element.html',
  'model-viewer': 'start-model-google.html',
  'babylon-viewer': 'start-model-babylon.html',
};

/** @type {Readonly<Record<string, Subject>>} */
export const SUBJECTS = {
  ...Object.fromEntries(
    SPHERE_LIGHTS.map((count) => [`sphere, ${lights(count)}`, frames(`sphere:${count}`)]),
  ),
  // Beyond what MeshPhongMaterial can draw.
  'sphere, 1,024 lights': frames('sphere:1024', ['element']),
  'box room, 8 lights': frames('room:8'),
  'bunny, 3 lights': frames('bunny:3'),
  '64 spheres, 8 lights': frames('spheres:8'),
  '2,000 boxes, 3 lights': frames('boxes:3'),
  'lights that come and go': frames('changing:8'),
  '300 moving lights': frames('moving:300'),
  // Segments as many as the outline needs, and a fixed number.
  ...Object.fromEntries(
    FRAMED_SHAPES.flatMap((shape) =>
      FRAMED_LIGHTS.map((count) => [
        framedSubject(shape, count),
        frames(`framed:${count}:${shape}`, ['element', 'fixed']),
      ]),
    ),
  ),
  'sphere, 8 lights, shininess 128': frames('shiny:8:128'),
  'sphere, 32 lights, shininess 128': frames('shiny:32:128'),
  'script, 128 moving lights': script('box-moving:128', ['element', 'three', 'unlit']),
  'script, turning camera': script('box-turning:3', ['element', 'three', 'unlit']),
  'script, 2,000 boxes': script('boxes:3'),
  'script, moving one of 10,000 boxes': script('ten-thousand:3:mesh'),
  'script, turning before 10,000 boxes': script('ten-thousand:3:camera'),
  'script, toggling one of 5,000 lights': script('toggle:5000', ['element']),
  '20 turning viewers': { kind: 'viewers' },
  '25 lights, turning': { kind: 'moving', scene: 'lights', ratio: 1 },
  '25 lights, turning, 3 pixels per CSS pixel': { kind: 'moving', scene: 'lights', ratio: 3 },
  'teapot and ball, turning': { kind: 'moving', scene: 'shapes', ratio: 1 },
  'teapot and ball, turning, 3 pixels per CSS pixel': { kind: 'moving', scene: 'shapes', ratio: 3 },
  start: {
    kind: 'start',
    pages: {
      standalone: 'start-standalone.html',
      bundled: 'start-element.html',
      three: 'start-three.html',
    },
  },
  'start, 2,000 boxes': startBoxes('boxes:3'),
  'start, 10,000 boxes': startBoxes('ten-thousand:3'),
  'start, 64 viewers': {
    kind: 'start',
    pages: { element: 'start-viewers-element.html', three: 'start-viewers-three.html' },
    pageSays: true,
  },
  ...Object.fromEntries(
    Object.entries(FIRST_MODELS).map(([model, file]) => [
      firstModelSubject(model),
      /** @type {StartSubject} */ ({
        kind: 'start',
        pages: {
          element: `start-model-element.html?model=models/${file}`,
          three: `start-model-three.html?model=models/${file}`,
        },
      }),
    ]),
  ),
  ...Object.fromEntries(
    NETWORKS.flatMap((network) =>
      Object.entries(MODELS).map(([model, file]) => [
        modelSubject(model, network),
        /** @type {ModelSubject} */ ({
          kind: 'model',
          file,
          pages: MODEL_PAGES,
          slow: network !== 'local',
        }),
      ]),
    ),
  ),
  ...Object.fromEntries(
    Object.entries(PICTURES).map(([picture, [scene, round]]) => [
      pictureSubject(/** @type {keyof typeof PICTURES} */ (picture)),
      /** @type {PictureSubject} */ ({ kind: 'picture', scene, round }),
    ]),
  ),
  ...Object.fromEntries(
    Object.entries(STILL).map(([picture, still]) => [
      stillSubject(picture),
      { kind: 'still', ...still },
    ]),
  ),
  bytes: { kind: 'bytes' },
};

/**
 * Names of the subjects that contain any of the texts, in order; all of them without texts. @param
 * {readonly string[]} texts
 */
export function chosenSubjects(texts) {
  const names = Object.keys(SUBJECTS);
  if (texts.length === 0) return names;
  return names.filter((name) => texts.some((text) => name === text || name.includes(text)));
}
