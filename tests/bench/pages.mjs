// @ts-check
// The bench's pages: the script, the body and the style of each. vite.config.ts builds them from
// here.

const HOLDER = '<div id="holder"></div>';
const SIZE = 'display: block; width: 400px; height: 300px;';
const START = `phong-viewer, #holder { ${SIZE} }`;
const MODEL = 'body { margin: 0; background: rgb(0 96 0); }';
const VIEWERS = 'phong-viewer, canvas { width: 140px; height: 90px; }';
const STANDALONE = './dist/phong-viewer.standalone.js';
const SPHERE = `<phong-viewer alt="A sphere" geometry="sphere">
  <phong-light position="1 2 3 0" ambient="20" diffuse="150"></phong-light>
  <phong-light position="-2 1 2 1" diffuse="200 120 60" attenuation="1 0.1 0.05"></phong-light>
  <phong-light position="0 3 2 1" diffuse="80 120 200" axis="0 -3 -2" aperture="30" cutoff="8"></phong-light>
</phong-viewer>`;

/** @typedef {readonly [script: string, body: string, style?: string]} BenchPage */

/**
 * @param {string} script @param {string} name @param {string} attributes @param {string} source the
 * attribute with the file's address @param {string} loaded the event @returns {BenchPage}
 */
const modelPage = (script, name, attributes, source, loaded) => [
  script,
  `<${name} ${attributes}></${name}>
<script>
  // Before the modules run, as if the author had written the attribute.
  self.ModelViewerElement = { dracoDecoderLocation: new URL('./draco/', location.href).href };
  const viewer = document.querySelector('${name}');
  viewer.addEventListener('${loaded}', () => (window.modelLoaded = true));
  viewer.setAttribute('${source}', new URLSearchParams(location.search).get('model'));
</script>`,
  `${MODEL} ${name} { ${SIZE} }`,
];

/** @type {Readonly<Record<string, BenchPage>>} */
const PAGES = {
  frame: [
    './frame.ts',
    HOLDER,
    'body { margin: 0; overflow: hidden; } #holder { width: 100vw; height: 100vh; } canvas { display: block; }',
  ],
  picture: [
    './picture.ts',
    HOLDER,
    `body { margin: 0; overflow: hidden; background: black; } canvas { display: block; }
     #holder { display: grid; width: max-content; }`,
  ],
  'start-boxes-element': ['./start-boxes-element.ts', HOLDER, START],
  'start-boxes-three': ['./start-boxes-three.ts', HOLDER, START],
  'start-element': ['./start-element.ts', SPHERE, START],
  'start-standalone': [STANDALONE, SPHERE, START],
  'start-three': ['./start-three.ts', HOLDER, START],
  // Where WebGPU is offered but cannot start, the viewer would lose time before it falls back to
  // WebGL.
  'start-model-babylon': modelPage(
    './peers/babylon/babylon-viewer.esm.min.js',
    ...['babylon-viewer', 'engine="WebGL"', 'source', 'modelchange'],
  ),
  'start-model-element': modelPage(STANDALONE, 'phong-viewer', 'alt="A model"', 'src', 'load'),
  'start-model-google': modelPage(
    './peers/model-viewer.min.js',
    ...['model-viewer', 'alt="A model"', 'src', 'load'],
  ),
  'start-model-three': ['./start-model-three.ts', HOLDER, `${MODEL} #holder { ${SIZE} }`],
  'start-viewers-element': ['./start-viewers-element.ts', '', VIEWERS],
  'start-viewers-three': ['./start-viewers-three.ts', '', VIEWERS],
  viewers: [
    './viewers.ts',
    '',
    `body { margin: 0; overflow: hidden; display: grid; width: 100vw; height: 100vh; }
     phong-viewer { display: block; width: auto; height: auto; }`,
  ],
};

export const PAGE_NAMES = Object.keys(PAGES);

/** @param {string} name */
export function htmlOf(name) {
  const [script, body, style = ''] = PAGES[name] ?? ['', ''];
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <title>A page of the bench: ${name}</title>
    <link rel="icon" href="data:," />
    <style>${style}</style>
    <script type="module" src="${script}"></script>
  </head>
  <body>${body}</body>
</html>`;
}
