// Is a drag kept from the page around it? A window whose listeners the test calls: what a script
// dispatches is not trusted.
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { keepDrag } from '../../../src/phong/camera/kept-drag.js';

const listeners = new Map<string, (event: Event) => void>();
const view = {
  addEventListener: (type: string, listener: (event: Event) => void) =>
    listeners.set(type, listener),
  removeEventListener: (type: string) => listeners.delete(type),
} as unknown as EventTarget;

/** Whether the page hears nothing of an event, and its default does not happen. */
function isKept(type: string, isTrusted = true) {
  const event = { isTrusted, preventDefault: vi.fn(), stopPropagation: vi.fn() };
  listeners.get(type)?.(event as unknown as Event);
  return (
    event.preventDefault.mock.calls.length === 1 && event.stopPropagation.mock.calls.length === 1
  );
}

beforeEach(() => {
  listeners.clear();
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

it('nothing around the picture is dragged until the press ends, and a press that moved nothing is a click', () => {
  const end = keepDrag(view);
  expect([isKept('dragstart'), isKept('click')]).toEqual([true, false]);
  end(false);
  expect([isKept('dragstart'), isKept('click')]).toEqual([false, false]);
});

it('the click that ends a drag is kept, once, but not one that a script makes', () => {
  keepDrag(view)(true);
  expect(isKept('click', false)).toBe(false);
  expect(isKept('click')).toBe(true);
  expect(listeners.size).toBe(0);
});

it('a click after the next press, or a third of a second later, is another one', () => {
  keepDrag(view)(true);
  listeners.get('pointerdown')?.(new Event('pointerdown'));
  expect(isKept('click')).toBe(false);
  keepDrag(view)(true);
  vi.advanceTimersByTime(300);
  expect(listeners.size).toBe(0);
});

it('a document without a window has nothing to keep', () => {
  keepDrag(null)(true);
  expect(() => vi.advanceTimersByTime(300)).not.toThrow();
});
