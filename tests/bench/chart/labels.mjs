// @ts-check
// Where the labels of a chart's points go: beside them where there is room, else farther off with a line that leads back.
// One after another, then each once more among all others; again and again with those first that had the worst places before, and
// the cheapest of all is taken. Pixels, y down.

/**
 * @typedef {{ x: number, y: number, width: number, height: number }} Box
 * @typedef {{ x: number, y: number, width: number, height: number }} Wanted a label of that size for the point at x, y
 * @typedef {{ from: readonly [number, number], to: readonly [number, number] }} Segment
 * @typedef {{ box: Box, leader: Segment | null, overlaps: boolean, unclear: boolean }} Placed
 */

/** From a point's centre to its label. */
const DISTANCES = [10, 19, 29, 40, 53, 68, 85, 104, 126, 150, 178];
/** Labels as far as this need no line to their point. */
const PLAIN = 12;
/** How often all labels are placed again, now that the others are there. */
const ROUNDS = 2;
/** Orders tried. */
const ATTEMPTS = 20;
/** What is left of trouble from one order to the next. */
const FADING = 0.7;

/**
 * One for each that is wanted; `overlaps` where no place was free, `unclear` where it is hard to see whose label it is.
 * @param {readonly Wanted[]} wanted @param {Box} inside
 * @param {{ marks: readonly Box[], lines: readonly Segment[] }} around what labels may not, and should not, cover
 * @returns {Placed[]}
 */
export function placeLabels(wanted, inside, { marks, lines }) {
  const indices = wanted.map((_, i) => i);
  /** How badly each was placed, of late more than before: else two orders take turns for ever. */
  const trouble = wanted.map(() => 0);
  let best = inOrder(wanted, indices, inside, marks, lines);
  for (let attempt = 0, last = best; attempt < ATTEMPTS; attempt++) {
    for (const i of indices)
      trouble[i] = FADING * (trouble[i] ?? 0) + Math.min(last.costs[i] ?? 0, COST.overlap);
    const order = [...indices].sort((a, b) => (trouble[b] ?? 0) - (trouble[a] ?? 0));
    last = inOrder(wanted, order, inside, marks, lines);
    if (sum(last.costs) < sum(best.costs)) best = last;
  }
  return best.placed;
}

/** @param {readonly number[]} numbers */
const sum = (numbers) => numbers.reduce((total, x) => total + x, 0);

/**
 * @param {readonly Wanted[]} wanted @param {readonly number[]} order @param {Box} inside
 * @param {readonly Box[]} marks @param {readonly Segment[]} lines
 */
function inOrder(wanted, order, inside, marks, lines) {
  /** @type {Placed[]} */
  const placed = [];
  /** @type {number[]} */
  const costs = [];
  for (let round = 0; round < ROUNDS; round++) {
    for (const i of order) {
      delete placed[i];
      const others = Object.values(placed);
      costs[i] = Infinity;
      for (const place of places(/** @type {Wanted} */ (wanted[i]))) {
        // Places come in the order of their distance, which is the least that they cost.
        if (place.far - DIRECTIONS.length / 2 > (costs[i] ?? 0)) break;
        const cost = costOf(place, inside, marks, lines, others);
        if (cost >= (costs[i] ?? 0)) continue;
        costs[i] = cost;
        placed[i] = {
          box: place.box,
          leader: place.leader,
          overlaps: cost >= COST.overlap,
          unclear: cost >= UNCLEAR,
        };
      }
    }
  }
  return { placed, costs };
}

/** What a place costs, in pixels of distance from the point: all that could make a label seem another point's. */
const COST = {
  overlap: 1e4,
  /** A leader through another mark. */
  through: 400,
  /** A label on a line of the chart. */
  onLine: 90,
  /** Two leaders across each other. */
  crossing: 60,
  /** A leader along the bar of its own quartiles, or along a step of the front. */
  level: 150,
  /** Close to another point's mark. */
  beside: 25,
};

/** A place that costs as much, by distance or by what it lies on, is not read at a glance. */
const UNCLEAR = 220;

/** So close, in pixels, that a label could be either point's. */
const BESIDE = 6;

/**
 * @param {Pick<Placed, 'box' | 'leader'> & { far: number, point: readonly [number, number] }} place @param {Box} inside
 * @param {readonly Box[]} marks @param {readonly Segment[]} lines @param {readonly Placed[]} others
 */
function costOf({ box, leader, far, point }, inside, marks, lines, others) {
  const out =
    Math.max(0, inside.x - box.x) +
    Math.max(0, inside.y - box.y) +
    Math.max(0, box.x + box.width - inside.x - inside.width) +
    Math.max(0, box.y + box.height - inside.y - inside.height);
  let cost = far + (out > 0 ? COST.overlap * (1 + out) : 0);
  for (const mark of marks) {
    if (overlap(box, mark)) cost += COST.overlap;
    else if (!holds(mark, point) && overlap(grown(box), mark)) cost += COST.beside;
  }
  for (const line of lines) if (crosses(line, box)) cost += COST.onLine;
  for (const other of others) {
    if (overlap(box, other.box)) cost += COST.overlap;
    if (other.leader !== null && crosses(other.leader, box)) cost += COST.overlap;
    if (leader === null) continue;
    if (crosses(leader, other.box)) cost += COST.overlap;
    if (other.leader !== null && meet(leader, other.leader)) cost += COST.crossing;
  }
  if (leader !== null) {
    if (leader.from[1] === leader.to[1]) cost += COST.level;
    for (const mark of marks) if (!holds(mark, point) && crosses(leader, mark)) cost += COST.through;
  }
  return cost;
}

/** Round about the point, ever farther. @param {Wanted} wanted */
function* places({ x, y, width, height }) {
  for (const far of DISTANCES) {
    for (const [i, [dx, dy]] of DIRECTIONS.entries()) {
      const box = {
        x: x + dx * far - ((1 - dx) * width) / 2,
        y: y + dy * far - ((1 - dy) * height) / 2,
        ...{ width, height },
      };
      const to = /** @type {const} */ ([
        Math.min(Math.max(x, box.x), box.x + width),
        Math.min(Math.max(y, box.y), box.y + height),
      ]);
      const point = /** @type {const} */ ([x, y]);
      const leader = far > PLAIN ? { from: point, to } : null;
      // Earlier directions are a little better: to the right, then above, where labels are looked for.
      yield { box, leader, point, far: far + i / 2 };
    }
  }
}

/** Where the label's centre lies from the point: fully beside it, or in between. @type {readonly (readonly [number, number])[]} */
const DIRECTIONS = [
  [1, 0],
  [-1, 0],
  [0, -1],
  [0, 1],
  [1, -1],
  [1, 1],
  [-1, -1],
  [-1, 1],
  [0.5, -1],
  [-0.5, -1],
  [0.5, 1],
  [-0.5, 1],
  [1, -0.5],
  [1, 0.5],
  [-1, -0.5],
  [-1, 0.5],
  [0.2, -1],
  [-0.2, -1],
  [0.2, 1],
  [-0.2, 1],
];

/** @param {Box} a @param {Box} b */
export const overlap = (a, b) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** @param {Box} box @returns {Box} */
const grown = ({ x, y, width, height }) => ({
  ...{ x: x - BESIDE, y: y - BESIDE, width: width + 2 * BESIDE, height: height + 2 * BESIDE },
});

/** @param {Box} box @param {readonly [number, number]} point */
const holds = (box, [x, y]) => x >= box.x && x <= box.x + box.width && y >= box.y && y <= box.y + box.height;

/** Whether a segment touches a box. @param {Segment} segment @param {Box} box */
function crosses(segment, box) {
  if (holds(box, segment.from) || holds(box, segment.to)) return true;
  const [left, right, top, bottom] = [box.x, box.x + box.width, box.y, box.y + box.height];
  return (
    meet(segment, { from: [left, top], to: [right, bottom] }) ||
    meet(segment, { from: [left, bottom], to: [right, top] })
  );
}

/** Whether two segments cross. @param {Segment} a @param {Segment} b */
function meet(a, b) {
  const side = (/** @type {Segment} */ { from, to }, /** @type {readonly [number, number]} */ p) =>
    Math.sign((to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0]));
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}
