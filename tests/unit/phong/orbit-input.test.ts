// Does OrbitInput turn events into camera moves, and does a drag that ends where it began leave a
// trace? On a surface made of Node's EventTarget; tests/element uses real pointers.

import { setMaxListeners } from 'node:events';
import { describe, expect, it, vi } from 'vitest';
import { Orbit, type Pose } from '../../../src/phong/camera/orbit.js';
import { OrbitInput } from '../../../src/phong/camera/orbit-input.js';
import { fullOr, SEED } from '../../support/repeats.js';
import { seeded } from '../../visual/random-scene.js';

// The input has twelve listeners with one signal. Node warns from eleven on.
setMaxListeners(12);

class FakeSurface extends EventTarget {
  readonly captured = new Set<number>();
  readonly ownerDocument = { defaultView: new EventTarget() };
  focused = false;
  focus() {
    this.focused = true;
  }
  getRootNode() {
    return { activeElement: this.focused ? this : null };
  }
  contains(other: unknown) {
    return other === this;
  }
  setPointerCapture(id: number) {
    this.captured.add(id);
  }
  hasPointerCapture(id: number) {
    return this.captured.has(id);
  }
  releasePointerCapture(id: number) {
    this.captured.delete(id);
  }
}

const MOUSE = {
  pointerId: 1,
  pointerType: 'mouse',
  button: 0,
  buttons: 1,
  clientY: 0,
  shiftKey: false,
};
const SECONDARY = { button: 2, buttons: 2 };

function setUp() {
  const surface = new FakeSurface();
  const window = surface.ownerDocument.defaultView;
  const orbit = new Orbit();
  const log: string[] = [];
  const size = { width: 600, height: 400 };
  const allows = { orbit: true, zoom: true };
  const input = new OrbitInput(surface as unknown as HTMLElement, {
    orbit,
    size: () => size,
    fov: () => 45,
    radiusLimits: () => ({ min: 1e-3, max: 1e3 }),
    allows: () => allows,
    moved: (source) => log.push(source),
    reset: () => log.push('reset'),
    held: (dragging) => log.push(dragging ? 'held' : 'let go'),
  });
  input.connect();
  /** Dispatches an event and returns whether its default action was prevented. */
  const fire = (type: string, values: object = {}, on: EventTarget = surface) => {
    const event = new Event(type, { cancelable: true });
    for (const [key, value] of Object.entries(values)) {
      Object.defineProperty(event, key, { value });
    }
    return !on.dispatchEvent(event);
  };
  const mouse = (type: string, clientX: number, values: object = {}) =>
    fire(type, { ...MOUSE, clientX, ...values });
  const touch = (type: string, pointerId: number, clientX: number, clientY = 0) =>
    mouse(type, clientX, { pointerType: 'touch', pointerId, clientY });
  const wheel = (deltaY: number, values: object = {}) =>
    fire('wheel', { deltaY, deltaMode: 0, ...values });
  const key = (name: string, values: object = {}) => fire('keydown', { key: name, ...values });
  const listening = vi.spyOn(window, 'addEventListener');
  /** Whether the next click is kept from the page. */
  const keepsClick = () => listening.mock.calls.some(([type]) => type === 'click');
  const menu = (timeStamp: number) => fire('contextmenu', { timeStamp }, window);
  return {
    surface,
    window,
    orbit,
    log,
    size,
    allows,
    input,
    fire,
    mouse,
    touch,
    wheel,
    key,
    menu,
    keepsClick,
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
      if (what === 'blur') {
        fire('blur', {}, window);
      } else if (what === 'a move without buttons') {
        mouse('pointermove', 150, { buttons: 0 });
      } else {
        mouse(what, 100);
      }
      expect(input.dragging).toBe(false);
      mouse('pointermove', 200);
      expect(orbit.version).toBe(0);
    },
  );

  it('shifts the target with Shift or the secondary button, and ignores other buttons', () => {
    for (const values of [{ shiftKey: true }, SECONDARY]) {
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
    const { orbit, touch } = setUp();
    touch('pointerdown', 5, 100);
    touch('pointermove', 5, 102, 20);
    touch('pointercancel', 5, 102, 20);
    expect(orbit.version).toBe(0);
    touch('pointerdown', 5, 100);
    touch('pointermove', 5, 100, 40);
    expect(orbit.phi).toBe(52);
    touch('pointermove', 5, 100, 20);
    expect(orbit.phi).toBe(61);
  });

  it.each([
    ['as far across as along', 120, 20],
    ['32 pixels along', 100, 32],
  ])('turns at once by a stroke %s', (_, x, y) => {
    const { orbit, touch } = setUp();
    touch('pointerdown', 5, 100, 7);
    touch('pointermove', 5, x, 7 + y);
    expect(orbit.version).toBe(1);
  });

  it.each([
    ['mouse', 4, 0, false],
    ['mouse', 3, -3, true],
    ['touch', 10, 0, false],
    ['touch', 8, -8, true],
  ])('a %s that has moved by %d, %d pixels has dragged: %s', (pointerType, x, y, dragged) => {
    const { mouse, keepsClick } = setUp();
    const at = { pointerType, clientY: 10 };
    mouse('pointerdown', 100, at);
    mouse('pointermove', 100 + x, { ...at, clientY: 10 + y });
    mouse('pointermove', 100, at);
    mouse('pointerup', 100, at);
    expect(keepsClick()).toBe(dragged);
  });

  it('a press that moves while nothing turns has not dragged', () => {
    const { orbit, mouse, keepsClick } = setUp();
    orbit.set({ phi: 0 });
    mouse('pointerdown', 100);
    mouse('pointermove', 100, { clientY: 50 });
    mouse('pointerup', 100);
    expect(keepsClick()).toBe(false);
  });

  it('takes a second finger at once, wherever it goes', () => {
    const { orbit, touch } = setUp();
    touch('pointerdown', 5, 100);
    touch('pointermove', 5, 140);
    touch('pointerdown', 6, 200);
    const before = orbit.version;
    touch('pointermove', 6, 200, 20);
    expect(orbit.version).toBe(before + 1);
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

it('the wheel zooms with focus, and is left to the page without it, for horizontal turns and while zoom is off', () => {
  const { surface, orbit, allows, log, wheel } = setUp();
  expect(wheel(100)).toBe(false);
  expect(orbit.radius).toBe(4);
  surface.focused = true;
  expect(wheel(100)).toBe(true);
  expect(orbit.radius).toBeCloseTo(4 * Math.exp(0.1), 7);
  expect(wheel(10, { ctrlKey: true })).toBe(true);
  expect(orbit.radius).toBeCloseTo(4 * Math.exp(0.2), 6);
  expect(wheel(0)).toBe(false);
  allows.zoom = false;
  expect(wheel(100)).toBe(false);
  expect(log).toStrictEqual(['wheel', 'wheel']);
});

describe('keys', () => {
  it('turn, zoom and reset', () => {
    const { orbit, log, key } = setUp();
    expect(key('ArrowRight')).toBe(true);
    expect(orbit.theta).toBe(25);
    key('PageUp');
    expect(orbit.radius).toBeCloseTo(4 / 1.1, 7);
    key('Home');
    expect(log).toStrictEqual(['key', 'key', 'reset']);
  });

  it('are ignored with Ctrl, Alt or Meta, and if they have no meaning', () => {
    const { log, key } = setUp();
    for (const modifier of ['ctrlKey', 'altKey', 'metaKey']) {
      expect(key('ArrowUp', { [modifier]: true })).toBe(false);
    }
    expect(key('a')).toBe(false);
    expect(log).toStrictEqual([]);
  });

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

it('disconnect removes everything, and connect brings it back', () => {
  const { surface, orbit, log, input, fire, mouse, key, menu, window } = setUp();
  mouse('pointerdown', 100, SECONDARY);
  input.disconnect();
  expect([input.dragging, surface.captured.size]).toStrictEqual([false, 0]);
  mouse('pointermove', 200, SECONDARY);
  mouse('pointerdown', 100, SECONDARY);
  key('ArrowUp');
  fire('blur', {}, window);
  expect([menu(0), fire('selectstart'), orbit.version]).toStrictEqual([false, false, 0]);
  input.connect();
  input.connect();
  key('ArrowUp');
  expect(orbit.phi).toBe(75);
  mouse('pointerdown', 100);
  expect(log).toStrictEqual(['held', 'let go', 'key', 'held']);
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

  it.each(['touchstart', 'touchmove'])(
    '%s is prevented for two fingers that hold the picture',
    (type) => {
      const { fire, touch } = setUp();
      const fingers = (length: number) => fire(type, { targetTouches: { length } });
      expect(fingers(2)).toBe(false);
      touch('pointerdown', 1, 0);
      expect(fingers(1)).toBe(false);
      expect(fingers(2)).toBe(true);
      touch('pointerdown', 2, 50);
      expect(fingers(3)).toBe(true);
    },
  );

  it('the context menu opens after a press of the secondary button, but not during or once after its drag', () => {
    const { mouse, menu } = setUp();
    const released = { button: 2, buttons: 0 };
    expect(menu(0)).toBe(false);
    mouse('pointerdown', 0, SECONDARY);
    expect(menu(1)).toBe(true);
    mouse('pointerup', 0, { ...released, timeStamp: 2 });
    expect(menu(2)).toBe(false);
    mouse('pointerdown', 0, SECONDARY);
    mouse('pointermove', 80, SECONDARY);
    mouse('pointerup', 80, { ...released, timeStamp: 10 });
    expect(menu(10)).toBe(true);
    expect(menu(10)).toBe(false);
    mouse('pointerdown', 0, SECONDARY);
    mouse('pointermove', 80, SECONDARY);
    mouse('pointerup', 80, { ...released, timeStamp: 20 });
    mouse('pointerdown', 0, SECONDARY);
    mouse('pointerup', 0, { ...released, timeStamp: 30 });
    expect(menu(30)).toBe(false);
  });

  it('the context menu of the next press opens, here or elsewhere, where a drag had its own at its press', () => {
    const { mouse, menu } = setUp();
    mouse('pointerdown', 0, SECONDARY);
    expect(menu(1)).toBe(true);
    mouse('pointermove', 80, SECONDARY);
    mouse('pointerup', 80, { button: 2, buttons: 0, timeStamp: 10 });
    expect(menu(20)).toBe(false);
  });

  it('a context menu ends the drag of a mouse, which it captures, but not of a finger', () => {
    const { log, mouse, touch, menu } = setUp();
    mouse('pointerdown', 0);
    expect(menu(1e6)).toBe(false);
    expect(log).toEqual(['held', 'let go']);
    touch('pointerdown', 1, 0);
    expect(menu(1e6)).toBe(false);
    expect(log).toEqual(['held', 'let go', 'held']);
  });

  it('a press whose default a script has prevented begins no drag', () => {
    const { input, surface, log, mouse } = setUp();
    input.disconnect();
    // Before the viewer's own listener.
    surface.addEventListener('pointerdown', (event) => event.preventDefault());
    input.connect();
    mouse('pointerdown', 0);
    expect(log).toEqual([]);
  });
});

interface Place {
  readonly clientX: number;
  readonly clientY: number;
}

/** Input on a picture that is focused, at any coordinates: browsers report fractions of pixels. */
function randomSetUp() {
  const coarse = seeded(SEED);
  // All bits of a double: with the generator's 32 bits every product below would be exact.
  const random = () => coarse() + coarse() * 2 ** -32;
  const from = (low: number, high: number) => low + (high - low) * random();
  const { fire, ...hand } = setUp();
  hand.surface.focused = true;
  // A window would wait for the click after each drag.
  Object.assign(hand.surface.ownerDocument, { defaultView: null });
  const pointer = (type: string, place: Place, more: object = {}) =>
    fire(type, { ...MOUSE, ...place, ...more });
  const anyPlace = () => ({ clientX: from(-3000, 3000), clientY: from(-3000, 3000) });
  const anyPose = (): Pose => ({
    theta: from(-1000, 1000),
    phi: from(0, 180),
    radius: 10 ** from(-2, 2),
    target: [from(-9, 9), from(-9, 9), from(-9, 9)],
  });
  /** Up to four moves; any of them can be a return to the start. */
  const wander = (more?: object) => {
    for (let moves = Math.ceil(4 * random()); moves > 0; moves--) {
      pointer('pointermove', anyPlace(), more);
    }
  };
  /**
   * Repeats `drag`, which returns the pose that it should end in, each time from the pose that the
   * last one left.
   */
  const expectNoTrace = (drags: number, drag: () => Pose) => {
    for (let i = 0; i < drags; i++) {
      if (i % 1000 === 0) {
        hand.orbit.set(anyPose());
      }
      const [expected, { pose }] = [drag(), hand.orbit];
      if (JSON.stringify(pose) !== JSON.stringify(expected)) {
        expect(pose, `drag ${i}`).toStrictEqual(expected);
      }
    }
  };
  return { ...hand, random, from, pointer, anyPlace, anyPose, wander, expectNoTrace };
}

describe(`a drag that ends where it began (seed ${SEED})`, () => {
  it('leaves no trace with two fingers, which shift and pinch', () => {
    const { orbit, pointer, anyPlace, random, wander, expectNoTrace } = randomSetUp();
    const finger = (pointerId: number) => ({ pointerType: 'touch', pointerId });
    const drag = () => {
      const { pose } = orbit;
      const starts = [anyPlace(), anyPlace()];
      starts.forEach((start, i) => pointer('pointerdown', start, finger(i)));
      for (let pair = 0; pair < 3; pair++) {
        wander(finger(Math.floor(2 * random())));
      }
      starts.forEach((start, i) => pointer('pointermove', start, finger(i)));
      starts.forEach((start, i) => pointer('pointerup', start, finger(i)));
      return pose;
    };
    expectNoTrace(fullOr(1e5, 2000), drag);
  });

  const drags = fullOr(1e6, 1e4);
  it(`of a mouse, turning or shifting, returns exactly to the pose of its press, or that the wheel, a key, a resize or a property set during it, in ${drags} drags`, () => {
    const buttons = [{}, { shiftKey: true }, SECONDARY];
    let moved = 0;
    const { orbit, input, size, pointer, anyPlace, anyPose, random, from, wheel, key, ...hand } =
      randomSetUp();
    const KEYS = ['ArrowLeft', 'ArrowUp', 'PageUp', '-'];
    const disturbances = [
      () => wheel(from(-200, 200)),
      () => key(KEYS[Math.floor(4 * random())]!),
      // As the element does it: the observer reports the size, and a drag in progress continues
      // from there.
      () => {
        Object.assign(size, {
          width: Math.round(from(1, 2000)),
          height: Math.round(from(1, 2000)),
        });
        if (random() < 0.5) {
          input.reanchor();
        }
      },
      () => {
        orbit.set(anyPose());
        if (random() < 0.5) {
          input.reanchor();
        }
      },
    ];
    const drag = () => {
      const button = buttons[Math.floor(3 * random())];
      let here = anyPlace();
      pointer('pointerdown', here, button);
      if (random() < 0.5) {
        hand.wander(button);
        here = anyPlace();
        pointer('pointermove', here, button);
        disturbances[Math.floor(4 * random())]!();
      }
      const { pose, version } = orbit;
      hand.wander(button);
      moved += Number(orbit.version > version);
      pointer('pointermove', here, button);
      pointer('pointerup', here, { ...button, buttons: 0 });
      return pose;
    };
    hand.expectNoTrace(drags, drag);
    expect(moved).toBe(drags);
  });
});
