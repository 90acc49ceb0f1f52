// @ts-check
// The element beside everything else that shows a lit 3D scene in a page: start, idling, many viewers, one more light, and how
// far each picture is from the equation. Rows as they come, each with what was asked for.

import { interleaved } from '../statistics.mjs';
import { distances } from './peer-distance.mjs';
import { openPeer } from './peer-pages.mjs';
import { relinks } from './peer-relink.mjs';
import { litCount, rowsOf } from './peer-row.mjs';

/**
 * @typedef {import('./peer-row.mjs').PeerRow} PeerRow
 * @typedef {import('./peer-pages.mjs').Opened} Opened
 *
 * @typedef {object} PeerSettings
 * @property {number} launches
 * @property {number} rounds
 * @property {number} seed
 */

/** The first is what the others' ratios are to. @type {readonly import('./peer-pages.mjs').PeerPage[]} */
const PEERS = [
  { name: '<phong-viewer>', page: 'phong-viewer', tag: 'phong-viewer', from: 'revision' },
  { name: 'three.js MeshPhong', page: 'mesh-phong', tag: '.peer', from: 'three' },
  { name: '<model-viewer>', page: 'model-viewer', tag: 'model-viewer', from: 'model-viewer' },
  { name: 'A-Frame', page: 'aframe', tag: 'a-scene', from: 'aframe' },
  { name: '<babylon-viewer>', page: 'babylon-viewer', tag: 'babylon-viewer', from: 'babylon-viewer' },
  { name: 'X_ITE', page: 'x-ite', tag: 'x3d-canvas', from: 'x-ite' },
];

/** How often what is slow is measured at the most: its spread is small beside the peers' differences. */
const MOST = { starts: 5, alone: 2, 16: 3, 64: 2 };

/**
 * @param {import('../session.mjs').Session} session @param {PeerSettings} settings
 * @returns {AsyncGenerator<PeerRow>}
 */
export async function* peers(session, settings) {
  const { launches, rounds } = settings;
  const { versions } = session;
  const named = PEERS.map(({ name, from }) => ({ name, version: versions[from] ?? 'unknown' }));
  yield* starts(session, named, Math.min(MOST.starts, launches * rounds));
  const alone = await inTurns(Math.min(MOST.alone, launches), (peer) =>
    openPeer(session, peer, { count: 1, idle: true }),
  );
  yield* idling(named, alone);
  yield* viewers(named, 1, alone, alone);
  for (const count of /** @type {const} */ ([16, 64])) {
    const many = await inTurns(Math.min(MOST[count], launches), (peer) => openPeer(session, peer, { count }));
    yield* viewers(named, count, many, alone);
  }
  yield* relinks(session, settings);
  yield* distances(session);
}

/**
 * Samples of all peers in turns.
 * @param {number} rounds @param {(peer: import('./peer-pages.mjs').PeerPage) => Promise<Opened>} sample
 * @returns {Promise<Opened[][]>} [peer][round]
 */
async function inTurns(rounds, sample) {
  /** @type {Opened[][]} */
  const samples = PEERS.map(() => []);
  await interleaved([...PEERS.entries()], rounds, async ([i, peer]) => {
    const opened = await sample(peer);
    samples[i]?.push(opened);
    return opened.ms;
  });
  return samples;
}

/** @typedef {readonly { name: string, version: string }[]} Named */

/** @param {import('../session.mjs').Session} session @param {Named} named @param {number} rounds */
async function* starts(session, named, rounds) {
  const samples = await inTurns(rounds, (peer) => openPeer(session, peer));
  yield* rowsOf(named, 'start to first frame', 'ms', samples, ({ ms }) => ms);
  yield* rowsOf(named, 'start, CPU time of the page', 'ms', samples, ({ pageMs }) => pageMs);
  yield* rowsOf(named, 'start, CPU time of the GPU process', 'ms', samples, ({ gpuMs }) => gpuMs);
  yield* rowsOf(named, 'heap after garbage collection', 'KiB', samples, ({ heap }) => heap);
  yield* rowsOf(named, 'fetched, uncompressed', 'KiB', samples, ({ bytes }) => bytes);
  yield* rowsOf(named, 'fetched, gzipped', 'KiB', samples, ({ gzipped }) => gzipped);
}

/** @param {Named} named @param {readonly (readonly Opened[])[]} samples */
function* idling(named, samples) {
  const name = 'idle second';
  const more = { ratios: false };
  yield* rowsOf(named, `${name}: animation frames`, 'callbacks', samples, ({ idle }) => idle.frames, more);
  yield* rowsOf(named, `${name}: draw calls`, 'calls', samples, ({ idle }) => idle.draws, more);
  yield* rowsOf(named, `${name}: timers`, 'callbacks', samples, ({ idle }) => idle.timers, more);
}

/**
 * @param {Named} named @param {number} count @param {readonly (readonly Opened[])[]} samples
 * @param {readonly (readonly Opened[])[]} alone one viewer a page
 */
function* viewers(named, count, samples, alone) {
  const counted = samples.map((list, i) => {
    const box = alone[i]?.[0]?.middles[0] ?? /** @type {const} */ ([255, 255, 255]);
    return list.map((opened) => ({ ...opened, lit: litCount(opened.middles, box) }));
  });
  const name = count === 1 ? '1 small viewer' : `${count} viewers`;
  /** @param {readonly { lit: number, lost: number }[]} list */
  const unlit = (list) => {
    const least = Math.min(...list.map(({ lit }) => lit));
    if (least === count) return undefined;
    const lost = Math.max(...list.map((sample) => sample.lost));
    const why = lost > 0 ? `: the browser takes ${lost} contexts away` : '';
    return `only ${least} of ${count} are lit in the end${why}`;
  };
  const more = { note: unlit };
  const plain = { ...more, ratios: false };
  yield* rowsOf(named, `${name}: lit in the end`, `of ${count}`, counted, ({ lit }) => lit, plain);
  // A page that never has them all lit has no such time: it would count as fast what is not there.
  yield* rowsOf(
    named,
    `${name}: to all lit`,
    'ms',
    counted,
    ({ ms, lit }) => (lit === count ? ms : NaN),
    more,
  );
  yield* rowsOf(named, `${name}: CPU time of the page`, 'ms', counted, ({ pageMs }) => pageMs, more);
  yield* rowsOf(named, `${name}: CPU time of the GPU process`, 'ms', counted, ({ gpuMs }) => gpuMs, more);
  yield* rowsOf(named, `${name}: WebGL contexts held`, 'contexts', counted, ({ contexts }) => contexts, {
    ratios: false,
  });
}
