// @ts-check
// How far each peer's picture of a lit sphere is from the equation, where it can be asked for Phong's at all: as it comes, and as
// near as its parameters let one come. Screenshots: what the browser shows, in 8 bits.

import { failOnErrors } from '../session.mjs';
import { spread } from '../statistics.mjs';
import { NOTHING } from './peer-row.mjs';
import { freshPage } from './start.mjs';

/**
 * @typedef {object} Case
 * @property {string} peer
 * @property {string} version key of its version
 * @property {string} [page] pages/distance-PAGE.html; none: it cannot be asked
 * @property {string} [query] its ?case=
 * @property {import('../../../src/reference/equation.js').ReferenceOptions} [truth] what it is compared with; none: the equation itself
 * @property {string} note what was asked for, and the difference that is known
 */

const BLINN = /** @type {const} */ ({ reflection: 'blinn-phong' });

/** What is known of MeshPhongMaterial's highlight, whose code A-Frame's is too. */
const LOBE = 'its highlight falls with N·L and grows by Fresnel';
const AS_NAMED = 'Blinn-Phong lobe times (n+2)/8 and N·L, output encoded to sRGB';
const UNENCODED = 'unencoded, light × π, specular as high as Ks';

/** @type {readonly Case[]} */
const CASES = [
  ...['phong', 'blinn-phong'].map((reflection) => ({
    ...{ peer: '<phong-viewer>', version: 'revision', page: 'phong-viewer', query: reflection },
    truth: { reflection: /** @type {'phong' | 'blinn-phong'} */ (reflection) },
    note: `reflection="${reflection}"; rounding to 8 bits, and above 0.5 how triangles are rasterized`,
  })),
  ...three('mesh-phong', 'three.js MeshPhong', 'three', 'a light of 1 is over π'),
  {
    ...{ peer: 'three.js MeshPhong', version: 'three', page: 'mesh-phong', query: 'diffuse' },
    truth: { terms: ['diffuse'] },
    note: 'diffuse term alone: the mapping is fair; Fresnel’s part of the highlight stays at specular 0',
  },
  ...three('aframe', 'A-Frame', 'aframe', 'its own light of 3.14, dithered'),
  {
    ...{ peer: 'X_ITE', version: 'x-ite', page: 'x-ite', query: 'own-exponent', truth: BLINN },
    note: 'Material, against Blinn-Phong with the same n: X3D defines that lobe',
  },
  {
    ...{ peer: 'X_ITE', version: 'x-ite', page: 'x-ite', query: 'nearest-exponent' },
    note: 'Material, exponent 4n, against R·V: its lobe is the half-vector’s',
  },
  ...['model-viewer', 'babylon-viewer'].map((version) => ({
    ...{ peer: `<${version}>`, version },
    note: 'physically based only: cannot be asked',
  })),
];

/** @param {string} page @param {string} peer @param {string} version @param {string} light as it comes @returns {Case[]} */
function three(page, peer, version, light) {
  const common = { peer, version, page };
  return [
    {
      ...common,
      query: 'as-it-comes',
      note: `the same numbers by their names, against R·V: ${AS_NAMED}, ${light}`,
    },
    {
      ...{ ...common, query: 'own-exponent', truth: BLINN },
      note: `${UNENCODED}, against Blinn-Phong with the same n: ${LOBE}`,
    },
    { ...common, query: 'nearest-exponent', note: `${UNENCODED}, exponent 4n, against R·V: ${LOBE}` },
  ];
}

/**
 * @param {import('../session.mjs').Session} session
 * @returns {AsyncGenerator<import('./peer-row.mjs').PeerRow>}
 */
export async function* distances(session) {
  const { browser, page: judge } = await freshPage(session);
  const failed = failOnErrors(judge);
  await judge.goto(`${session.origin}/distance.html`);
  for (const { peer, version, page, query, truth = {}, note } of CASES) {
    const row = { peer, version: session.versions[version] ?? 'unknown', unit: '/255', note };
    const distance =
      page === undefined
        ? undefined
        : await judge.evaluate(
            ([picture, options]) => window.distanceOfPicture(picture, options),
            /** @type {const} */ ([await pictureOf(session, browser, `${page}.html?case=${query}`), truth]),
          );
    for (const key of /** @type {const} */ (['rmse', 'max'])) {
      const value = distance === undefined ? NOTHING : spread([distance[key]]);
      yield { ...row, what: `distance from the equation: ${key === 'rmse' ? 'RMSE' : 'maximum'}`, value };
    }
  }
  failed();
  await browser.close();
}

/** The first viewer's square, as PNG in base64. @param {import('../session.mjs').Session} session @param {import('playwright-core').Browser} browser @param {string} path */
async function pictureOf(session, browser, path) {
  const page = await browser.newPage({ viewport: { width: 256, height: 256 } });
  const failed = failOnErrors(page);
  await page.goto(`${session.origin}/distance-${path}`);
  await page.waitForFunction(() => window.firstPicture !== undefined, undefined, {
    polling: 50,
    timeout: 60_000,
  });
  const picture = await page.screenshot();
  failed();
  await page.close();
  return picture.toString('base64');
}
