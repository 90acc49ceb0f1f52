// Does a drag of a handle, a divider or a number follow its own pointer to its end? On elements
// made of Node's EventTarget; tests/extras uses real pointers.

import { expect, it, vi } from 'vitest';
import { followDrag } from '../../../src/phong/camera/followed-drag.js';

const PRESS = { pointerId: 7, clientX: 100, clientY: 50, buttons: 1 };

function press(slop: number, canCapture = true, view: EventTarget | null = new EventTarget()) {
  const captured = new Set<number>();
  const element = Object.assign(new EventTarget(), {
    ownerDocument: { defaultView: view },
    setPointerCapture(id: number) {
      if (!canCapture) throw new Error('no such pointer');
      captured.add(id);
    },
    hasPointerCapture: (id: number) => captured.has(id),
    releasePointerCapture: (id: number) => captured.delete(id),
  });
  const log: string[] = [];
  const end = followDrag(
    element as unknown as HTMLElement,
    PRESS as unknown as PointerEvent,
    slop,
    {
      moved: (dx, dy) => log.push(`${dx} ${dy}`),
      ended: () => log.push('ended'),
    },
  );
  const fire = (type: string, values: object = {}, on: EventTarget = element) => {
    on.dispatchEvent(Object.assign(new Event(type), PRESS, values));
  };
  return { captured, log, end, fire, view: view! };
}

it('gives the whole travel of its own pointer, once it has left the slop', () => {
  const { log, fire, captured } = press(5);
  fire('pointermove', { clientX: 103, clientY: 53 });
  fire('pointermove', { clientX: 200, pointerId: 8 });
  expect(log).toEqual([]);
  fire('pointermove', { clientX: 103, clientY: 54 });
  fire('pointermove', { clientX: 99, clientY: 50 });
  expect(log).toEqual(['3 4', '-1 0']);
  expect(captured.has(7)).toBe(true);
});

it('follows from the first pixel what is never clicked, and without capture', () => {
  const { log, fire } = press(0, false);
  fire('pointermove', { clientX: 100 });
  expect(log).toEqual(['0 0']);
});

it.each(['pointerup', 'pointercancel', 'lostpointercapture', 'blur'])(
  'ends once at %s, lets go of the pointer, and follows no further',
  (type) => {
    const { log, fire, view, captured, end } = press(0);
    if (type !== 'blur') {
      fire(type, { pointerId: 8 }, view);
      expect(log).toEqual([]);
    }
    fire(type, {}, view);
    fire('pointermove', { clientX: 120 });
    fire('pointerup', {}, view);
    end();
    expect(log).toEqual(['ended']);
    expect(captured.size).toBe(0);
  },
);

it('ends where the button was released without an event', () => {
  const { log, fire } = press(0);
  fire('pointermove', { buttons: 2 });
  fire('pointermove', { clientX: 120 });
  expect(log).toEqual(['ended']);
});

it('lets go of nothing that it has not captured', () => {
  const { end, log, captured } = press(0, false);
  captured.add(8);
  end();
  expect(log).toEqual(['ended']);
  expect([...captured]).toEqual([8]);
});

it('works in a document without a window', () => {
  const { log, fire, end } = press(0, true, null);
  fire('pointermove', { clientX: 101 });
  end();
  expect(log).toEqual(['1 0', 'ended']);
});

it.each([
  [1, 0],
  [9, 1],
])('after a travel of %i pixels keeps %i click from the page', (dx, kept) => {
  const view = new EventTarget();
  const listening = vi.spyOn(view, 'addEventListener');
  const { fire } = press(5, true, view);
  fire('pointermove', { clientX: 100 + dx });
  fire('pointerup', {}, view);
  expect(listening.mock.calls.filter(([type]) => type === 'click')).toHaveLength(kept);
});
