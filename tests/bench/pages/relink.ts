// What the frame costs that has one light more than the one before: ?peer=element&lights=3&seed=1. On a canvas so small that
// drawing costs next to nothing, so that what is left is programs. Times are milliseconds by the clock, each closed by
// reading a pixel back.
import { MeshPhongMaterial } from 'three';
import { bentPlane, type Light, lightsOf, SURFACE } from './scenes.js';
import { element } from './peers/element.js';
import { lightOf } from './peers/mesh-phong.js';
import { finish, type Peer, pause, settle } from './peers/peer.js';
import { geometryOf, plainThree, threePeer } from './peers/plain-three.js';

export interface Relink {
  /** Median of still frames before. */
  readonly still: number;
  /** The frame with the new light, from the call that adds it. */
  readonly added: number;
  /** The longest of the frames after it, by when a program made in the background has taken over. */
  readonly longest: number;
}

declare global {
  interface Window {
    relinkBench?: () => Promise<Relink>;
  }
}

interface Growing {
  readonly peer: Peer;
  add(light: Light): Promise<void>;
}

const FRAMES = { still: 31, after: 120 } as const;
/** Between frames, as a screen leaves time between them: what is made in the background is made then. */
const BETWEEN_MS = 10;

const query = new URLSearchParams(location.search);
const lights = Number(query.get('lights'));
const scene = { lights, active: lights, kind: 'mixed', seed: Number(query.get('seed')) } as const;
const holder = document.getElementById('holder')!;

async function growingElement(): Promise<Growing> {
  const peer = await element(holder, scene);
  const viewer = holder.querySelector('phong-viewer')!;
  return {
    peer,
    async add(values) {
      viewer.append(Object.assign(document.createElement('phong-light'), values));
      await Promise.resolve(); // the viewer is told of its new child before this goes on
      if (viewer.lights.length !== lights + 1) throw new Error('the viewer has not seen its new light');
    },
  };
}

function growingMeshPhong(): Promise<Growing> {
  const material = new MeshPhongMaterial({ shininess: SURFACE.shininess });
  const three = plainThree(holder, geometryOf(bentPlane()), material, true);
  for (const light of lightsOf(scene)) three.scene.add(...lightOf(light));
  const add = (light: Light): Promise<void> => {
    three.scene.add(...lightOf(light));
    return Promise.resolve();
  };
  return Promise.resolve({ peer: threePeer(three), add });
}

const { peer, add } = await (query.get('peer') === 'element' ? growingElement() : growingMeshPhong());
await peer.resize(holder.clientWidth, holder.clientHeight);
await settle(peer);

const timed = (): number => {
  const start = performance.now();
  peer.draw();
  finish(peer.gl);
  return performance.now() - start;
};

window.relinkBench = async () => {
  const still: number[] = [];
  for (let i = 0; i < FRAMES.still; i++) still.push(timed());
  // Of the kind whose turn it is: the page has had one of it since its start.
  const next = lightsOf(scene)[lights % 3]!;
  const start = performance.now();
  await add(next);
  peer.draw();
  finish(peer.gl);
  const added = performance.now() - start;
  let longest = 0;
  for (let i = 0; i < FRAMES.after; i++) {
    await pause(BETWEEN_MS);
    longest = Math.max(longest, timed());
  }
  return { still: still.sort((a, b) => a - b)[FRAMES.still >> 1]!, added, longest };
};
