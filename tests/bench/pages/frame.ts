// One peer on one page, drawn and timed by the bench: ?peer=element&lights=8&active=8&kind=mixed&seed=1
import { rendererName } from '../../glsl/float-pass.js';
import { type Capture, captureOf } from './capture.js';
import { core } from './peers/core.js';
import { element } from './peers/element.js';
import { meshPhong, meshPhongLinear, unlit } from './peers/mesh-phong.js';
import {
  clockFrames,
  litShare,
  type Peer,
  type PeerMaker,
  settle,
  SETTLED_AT_SIZE,
  timeFrames,
} from './peers/peer.js';
import { raw } from './peers/raw.js';
import type { Kind } from './scenes.js';

const MAKERS: Readonly<Record<string, PeerMaker>> = {
  element,
  core,
  'mesh-phong': meshPhong,
  'mesh-phong-linear': meshPhongLinear,
  unlit,
};

export interface FrameBench {
  readonly renderer: string;
  readonly hasTimer: boolean;
  /** At a small size, where frames cost little. */
  settle(): Promise<{ frames: number; programs: number; most: number }>;
  resize(width: number, height: number): Promise<void>;
  /** Once more, where frames cost what they are timed for. */
  settleAtSize(): Promise<void>;
  lit(): number;
  draw(frames: number): number;
  time(frames: number): Promise<number>;
  capture(): Capture;
}

declare global {
  interface Window {
    openPeer: (capture?: Capture) => Promise<void>;
    frameBench: FrameBench;
  }
}

window.openPeer = async (capture) => {
  const query = new URLSearchParams(location.search);
  const holder = document.getElementById('holder')!;
  const number = (name: string): number => Number(query.get(name));
  const scene = {
    lights: number('lights'),
    active: number('active'),
    kind: query.get('kind') as Kind | 'mixed',
    seed: number('seed'),
  };
  const peer: Peer =
    capture === undefined ? await MAKERS[query.get('peer')!]!(holder, scene) : raw(holder, capture);
  window.frameBench = {
    renderer: rendererName(peer.gl),
    hasTimer: peer.gl.getExtension('EXT_disjoint_timer_query_webgl2') !== null,
    settle: () => settle(peer),
    resize: (width, height) => peer.resize(width, height),
    settleAtSize: () => settle(peer, SETTLED_AT_SIZE).then(() => undefined),
    lit: () => litShare(peer),
    draw: (frames) => clockFrames(peer, frames),
    time: (frames) => timeFrames(peer, frames),
    capture: () => captureOf(peer),
  };
};
