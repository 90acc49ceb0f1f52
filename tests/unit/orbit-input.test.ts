// Does OrbitInput turn events into camera moves? On a surface made of Node's EventTarget; tests/element uses real
// pointers.

import { describe, expect, it } from 'vitest';
import { Orbit } from '../../src/camera/orbit.js';
import { OrbitInput } from '../../src/camera/orbit-input.js';

class FakeSurface extends EventTarget {
  readonly captured = new Set<number>();
  readonly ownerDocument = { defaultView: new EventTarget() };
  focused = false;
  focus(): void {
    this.focused = true;
  }
  getRootNode() {
    return { activeElement: this.focused ? this : null };
  }
  contains(other: unknown): boolean {
    return other === this;
  }
  setPointerCapture(id: number): void {
    this.captured.add(id);
  }
  hasPointerCapture(id: number): boolean {
    return this.captured.has(id);
  }
  releasePointerCapture(id: number): void {
    this.captured.delete(id);
  }
}

function setUp() {
  const surface = new FakeSurface();
  const orbit = new Orbit();
  const log: string[] = [];
  const allows = { orbit: true, zoom: true };
  const input = new OrbitInput(surface as unknown as HTMLElement, {
    orbit,
    size: () => ({ width: 600, height: 400 }),
    fov: () => 45,
    radiusLimits: () => ({ min: 1e-3, max: 1e3 }),
    allows: () => allows,
    moved: (source) => log.push(source),
    reset: () => log.push('reset'),
    held: (dragging) => log.push(dragging ? 'held' : 'let go'),
  });
  input.connect();
  /** Dispatches an event and returns whether its default action was prevented. */
  const fire = (type: string, values: object = {}, on: EventTarget = surface): boolean => {
    const event = new Event(type, { cancelable: true });
    for (const [key, value] of Object.entries(values)) Object.defineProperty(event, key, { value });
    return !on.dispatchEvent(event);
  };
  const mouse = (type: string, clientX: number, values: object = {}): boolean =>
    fire(type, {
      pointerId: 1,
      pointerType: 'mouse',
      button: 0,
      buttons: 1,
      clientX,
      clientY: 0,
      shiftKey: false,
      ...values,
    });
  const touch = (type: string, pointerId: number, clientX: number): boolean =>
    mouse(type, clientX, { pointerType: 'touch', pointerId });
  const wheel = (deltaY: number, values: object = {}): boolean =>
    fire('wheel', { deltaY, deltaMode: 0, ...values });
  const key = (name: string, values: object = {}): boolean => fire('keydown', { key: name, ...values });
  return {
    surface,
    window: surface.ownerDocument.defaultView,
    orbit,
    log,
    allows,
    input,
    fire,
    mouse,
    touch,
    wheel,
    key,
  };
}

describe('the pointer', () => {
  it('is captured and focuses the surface on press, turns, and is released', () => {
    const { surface, orbit, log, input, mouse } = setUp();
    mouse('pointerdown', 100);
    expect(surface.captured.has(1) && surface.focused && input.dragging).toBe(true);
    mouse('pointermove', 160);
    expect(orbit.theta).toBe(-6);
    mouse('pointermove', 160);
    mouse('pointerup', 160, { buttons: 0 });
    mouse('pointermove', 300, { buttons: 0 });
    expect(orbit.theta).toBe(-6);
    expect(surface.captured.size).toBe(0);
    expect(log).toStrictEqual(['held', 'pointer', 'let go']);
  });

  it.each(['pointercancel', 'lostpointercapture', 'blur', 'a move without buttons'])(
    'ends the drag at %s',
    (what) => {
      const { orbit, input, fire, mouse, window } = setUp();
      mouse('pointerdown', 100);
      if (what === 'blur') fire('blur', {}, window);
      else if (what === 'a move without buttons') mouse('pointermove', 150, { buttons: 0 });
      else mouse(what, 100);
      expect(input.dragging).toBe(false);
      mouse('pointermove', 200);
      expect(orbit.version).toBe(0);
    },
  );

  it('shifts the target with Shift or the secondary button, and ignores other buttons', () => {
    for (const values of [{ shiftKey: true }, { button: 2, buttons: 2 }]) {
      const { orbit, mouse } = setUp();
      mouse('pointerdown', 100, values);
      mouse('pointermove', 160, values);
      expect(orbit.theta).toBe(30);
      expect(orbit.target[0]).toBeLessThan(0);
    }
    const { input, mouse } = setUp();
    mouse('pointerdown', 100, { button: 1, buttons: 4 });
    expect(input.dragging).toBe(false);
  });

  it('suppresses the context menu of a secondary drag only', () => {
    const { fire, mouse, window } = setUp();
    const menu = (): boolean => fire('contextmenu', {}, window);
    const secondary = { button: 2, buttons: 2 };
    expect(menu()).toBe(false);
    mouse('pointerdown', 100, secondary);
    mouse('pointermove', 160, secondary);
    mouse('pointerup', 160, { button: 2, buttons: 0 });
    expect(menu()).toBe(true);
    expect(menu()).toBe(false);
    mouse('pointerdown', 100, secondary);
    mouse('pointerup', 100, { button: 2, buttons: 0 });
    expect(menu()).toBe(false);
  });

  it('zooms by two fingers and goes on turning with the remaining one', () => {
    const { orbit, touch, input, log } = setUp();
    touch('pointerdown', 5, 100);
    touch('pointerdown', 6, 200);
    touch('pointermove', 6, 300);
    expect(orbit.radius).toBe(2);
    touch('pointerup', 5, 100);
    expect(input.dragging).toBe(true);
    touch('pointermove', 6, 360);
    expect(orbit.theta).toBe(-6);
    touch('pointerup', 6, 360);
    expect(log).toStrictEqual(['held', 'pointer', 'pointer', 'let go']);
  });

  it('waits until a vertical stroke of a finger is no scroll, then turns by its whole travel', () => {
    const { orbit, mouse } = setUp();
    const finger = { pointerType: 'touch', pointerId: 5 };
    mouse('pointerdown', 100, finger);
    mouse('pointermove', 102, { ...finger, clientY: 20 });
    mouse('pointercancel', 102, { ...finger, clientY: 20 });
    expect(orbit.version).toBe(0);
    mouse('pointerdown', 100, finger);
    mouse('pointermove', 100, { ...finger, clientY: 40 });
    expect(orbit.phi).toBe(52);
    mouse('pointermove', 100, { ...finger, clientY: 20 });
    expect(orbit.phi).toBe(61);
  });

  it('ignores a second mouse or pen during a drag', () => {
    const { input, mouse } = setUp();
    mouse('pointerdown', 100);
    mouse('pointerdown', 100, { pointerId: 2, pointerType: 'pen' });
    mouse('pointerdown', 100, { pointerId: 3, pointerType: 'touch' });
    mouse('pointerup', 100);
    expect(input.dragging).toBe(false);
  });

  it('only focuses the surface while orbit is off, for the wheel', () => {
    const { surface, allows, input, mouse } = setUp();
    allows.orbit = false;
    mouse('pointerdown', 100);
    expect([surface.focused, input.dragging]).toStrictEqual([true, false]);
    allows.zoom = false;
    surface.focused = false;
    mouse('pointerdown', 100);
    expect(surface.focused).toBe(false);
  });
});

describe('the wheel', () => {
  it('zooms only with focus', () => {
    const { surface, orbit, log, wheel } = setUp();
    expect(wheel(100)).toBe(false);
    expect(orbit.radius).toBe(4);
    surface.focused = true;
    expect(wheel(100)).toBe(true);
    expect(orbit.radius).toBeCloseTo(4 * Math.exp(0.1), 14);
    expect(wheel(100, { ctrlKey: true })).toBe(true);
    expect(log).toStrictEqual(['wheel', 'wheel']);
  });

  it('is left to the page while zoom is off, and for horizontal turns', () => {
    const { surface, allows, wheel } = setUp();
    surface.focused = true;
    expect(wheel(0)).toBe(false);
    allows.zoom = false;
    expect(wheel(100)).toBe(false);
  });

  it('lets a drag continue from the new radius', () => {
    const { surface, orbit, mouse, wheel } = setUp();
    mouse('pointerdown', 100);
    mouse('pointermove', 160);
    expect(surface.focused).toBe(true);
    wheel(100);
    mouse('pointermove', 220);
    expect(orbit.radius).toBeCloseTo(4 * Math.exp(0.1), 14);
    expect(orbit.theta).toBe(-42);
  });
});

describe('keys', () => {
  it('turn, zoom and reset', () => {
    const { orbit, log, key } = setUp();
    expect(key('ArrowRight')).toBe(true);
    expect(orbit.theta).toBe(25);
    key('PageUp');
    expect(orbit.radius).toBeCloseTo(4 / 1.1, 14);
    key('Home');
    expect(log).toStrictEqual(['key', 'key', 'reset']);
  });

  it('are ignored with Ctrl, Alt or Meta, and if they have no meaning', () => {
    const { log, allows, key } = setUp();
    for (const modifier of ['ctrlKey', 'altKey', 'metaKey'])
      expect(key('ArrowUp', { [modifier]: true })).toBe(false);
    expect(key('a')).toBe(false);
    allows.orbit = false;
    expect(key('ArrowUp')).toBe(false);
    expect(key('-')).toBe(true);
    allows.zoom = false;
    expect(key('-')).toBe(false);
    expect(key('Home')).toBe(false);
    expect(log).toStrictEqual(['key']);
  });
});

describe('coming and going', () => {
  it('removes everything on disconnect, and works again after connect', () => {
    const { surface, orbit, log, input, fire, mouse, key, window } = setUp();
    mouse('pointerdown', 100);
    input.disconnect();
    expect([input.dragging, surface.captured.size]).toStrictEqual([false, 0]);
    mouse('pointermove', 200);
    key('ArrowUp');
    fire('blur', {}, window);
    expect(orbit.version).toBe(0);
    input.connect();
    input.connect();
    key('ArrowUp');
    expect(orbit.phi).toBe(75);
    expect(log).toStrictEqual(['held', 'let go', 'key']);
  });
});

describe('defaults of the browser', () => {
  it.each(['selectstart', 'dragstart'])('%s is prevented during a drag alone', (type) => {
    const { surface, window, fire, mouse } = setUp();
    // What is dragged may be an element around the picture.
    const on = type === 'dragstart' ? window : surface;
    expect(fire(type, {}, on)).toBe(false);
    mouse('pointerdown', 0);
    expect(fire(type, {}, on)).toBe(true);
    mouse('pointerup', 0);
    expect(fire(type, {}, on)).toBe(false);
  });

  it.each(['touchstart', 'touchmove'])('%s is prevented for two fingers that hold the picture', (type) => {
    const { fire, touch } = setUp();
    const fingers = (length: number): boolean => fire(type, { targetTouches: { length } });
    expect(fingers(2)).toBe(false);
    touch('pointerdown', 1, 0);
    expect(fingers(1)).toBe(false);
    expect(fingers(2)).toBe(true);
    touch('pointerdown', 2, 50);
    expect(fingers(3)).toBe(true);
  });

  it('the context menu opens after a press of the secondary button, but not during or once after its drag', () => {
    const { surface, fire, mouse } = setUp();
    const window = surface.ownerDocument.defaultView;
    const menu = (timeStamp: number): boolean => fire('contextmenu', { timeStamp }, window);
    const secondary = { button: 2, buttons: 2 };
    expect(menu(0)).toBe(false);
    mouse('pointerdown', 0, secondary);
    expect(menu(1)).toBe(true);
    mouse('pointerup', 0, { ...secondary, buttons: 0, timeStamp: 2 });
    expect(menu(2)).toBe(false);
    mouse('pointerdown', 0, secondary);
    mouse('pointermove', 80, secondary);
    mouse('pointerup', 80, { ...secondary, buttons: 0, timeStamp: 10 });
    expect(menu(10)).toBe(true);
    expect(menu(10)).toBe(false);
  });

  it('a context menu ends the drag of a mouse, which it captures, but not of a finger', () => {
    const { surface, log, fire, mouse, touch } = setUp();
    const window = surface.ownerDocument.defaultView;
    mouse('pointerdown', 0);
    expect(fire('contextmenu', { timeStamp: 1e6 }, window)).toBe(false);
    expect(log).toEqual(['held', 'let go']);
    touch('pointerdown', 1, 0);
    expect(fire('contextmenu', { timeStamp: 1e6 }, window)).toBe(false);
    expect(log).toEqual(['held', 'let go', 'held']);
  });

  it('a press whose default a script has prevented begins no drag', () => {
    const { input, surface, log, mouse } = setUp();
    const prevent = (event: Event): void => {
      event.preventDefault();
    };
    input.disconnect();
    surface.addEventListener('pointerdown', prevent); // before the viewer's own listener
    input.connect();
    mouse('pointerdown', 0);
    expect(log).toEqual([]);
  });
});

describe('keys', () => {
  it.each([
    ['ArrowLeft', true, false, true],
    ['ArrowLeft', false, true, false],
    ['+', true, false, false],
    ['+', false, true, true],
    ['Home', true, false, true],
    ['Home', false, true, true],
    ['Home', false, false, false],
  ])('%s with orbit %s and zoom %s is taken: %s', (name, orbit, zoom, taken) => {
    const { allows, key } = setUp();
    Object.assign(allows, { orbit, zoom });
    expect(key(name)).toBe(taken);
  });
});

it('after disconnect the window is not listened to either', () => {
  const { input, surface, log, fire, mouse } = setUp();
  input.disconnect();
  mouse('pointerdown', 0);
  expect(fire('contextmenu', { timeStamp: 0 }, surface.ownerDocument.defaultView)).toBe(false);
  expect(fire('selectstart')).toBe(false);
  expect(log).toEqual([]);
});
