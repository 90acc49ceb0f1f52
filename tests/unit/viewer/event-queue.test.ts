// When and how often a viewer's events are dispatched, without a browser.

import { describe, expect, it } from 'vitest';
import { Signal } from '../../../src/phong/fields/signal.js';
import { LightState } from '../../../src/phong/light/light-state.js';
import { ElementLight, type PhongLight } from '../../../src/viewer/element/phong-light.js';
import { EventQueue } from '../../../src/viewer/element/viewer/event-queue.js';

const nextTask = () => new Promise<void>((resolve) => setTimeout(resolve));

const TYPES = ['load', 'progress', 'camera-change', 'light-change'] as const;

/** A queue, and what it has dispatched: types and details in order. */
function queueOf(lightsChanged: (lights: readonly PhongLight[]) => void = () => undefined) {
  const element = new EventTarget();
  const seen: [string, unknown][] = [];
  for (const type of TYPES) {
    element.addEventListener(type, (event) => seen.push([type, (event as CustomEvent).detail]));
  }
  const lightsReported = new Signal<readonly PhongLight[]>();
  lightsReported.listen(lightsChanged);
  return { element, queue: new EventQueue(element, lightsReported), seen };
}

function lightNamed(name: string) {
  const light = new ElementLight();
  // The queue only passes elements on.
  light.element = { name } as unknown as PhongLight;
  return light;
}

describe('the events of a viewer', () => {
  it('are dispatched at the end of the task, in the order in which their types first came', async () => {
    const { queue, seen } = queueOf();
    queue.enqueue('camera-change', { source: 'pointer' });
    queue.enqueue('progress', { totalProgress: 0.2 });
    queue.enqueue('camera-change', { source: 'wheel' });
    expect(seen).toEqual([]);
    await nextTask();
    expect(seen).toEqual([
      ['camera-change', { source: 'wheel' }],
      ['progress', { totalProgress: 0.2 }],
    ]);
  });

  it('are dispatched one by one where each is about something else', async () => {
    const { queue, seen } = queueOf();
    queue.append('load', { url: 'a', missing: [] });
    queue.append('load', { url: 'b', missing: ['b.png'] });
    await nextTask();
    expect(seen).toEqual([
      ['load', { url: 'a', missing: [] }],
      ['load', { url: 'b', missing: ['b.png'] }],
    ]);
  });

  it('wait for the next end of a task where a listener causes them', async () => {
    const { element, queue, seen } = queueOf();
    element.addEventListener('progress', (event) => {
      const { totalProgress } = (event as CustomEvent<{ totalProgress: number }>).detail;
      if (totalProgress < 1) {
        queue.enqueue('progress', { totalProgress: 1 });
      }
    });
    queue.enqueue('progress', { totalProgress: 0 });
    await nextTask();
    expect(seen).toEqual([
      ['progress', { totalProgress: 0 }],
      ['progress', { totalProgress: 1 }],
    ]);
  });
});

describe('light-change', () => {
  it('names each light once, in the order of the first writes, in a list that nobody can change', async () => {
    const { queue, seen } = queueOf();
    const [a, b] = [lightNamed('a'), lightNamed('b')];
    for (const light of [b, a, b, b]) {
      queue.enqueueLight(light);
    }
    await nextTask();
    expect(seen).toEqual([['light-change', { lights: [b.element, a.element] }]]);
    expect(Object.isFrozen((seen[0]![1] as { lights: unknown }).lights)).toBe(true);
  });

  it('names a light again that is written to again, at each viewer that it belongs to', async () => {
    const viewers = [queueOf(), queueOf()];
    const light = lightNamed('a');
    const change = ['light-change', { lights: [light.element] }];
    for (const changes of [[change], [change, change]]) {
      for (const { queue } of viewers) {
        queue.enqueueLight(light);
      }
      await nextTask();
      for (const { seen } of viewers) {
        expect(seen).toEqual(changes);
      }
    }
  });

  it('names no light where lights come and go, and none that no element declares', async () => {
    const { queue, seen } = queueOf();
    queue.enqueueLight(null);
    queue.enqueueLight(new LightState());
    await nextTask();
    expect(seen).toEqual([['light-change', { lights: [] }]]);
  });

  it('is known to the viewer before its listeners', async () => {
    const order: string[] = [];
    const { element, queue } = queueOf(() => order.push('viewer'));
    element.addEventListener('light-change', () => order.push('listener'));
    queue.enqueueLight(null);
    await nextTask();
    expect(order).toEqual(['viewer', 'listener']);
  });
});
