// How often does a random test repeat? As often as its claim says in a release run, a twentieth of
// it otherwise: the first repetitions find nearly everything, and mutants run them thousands of
// times.

// Some of these tests run in pages.
const environment = typeof process === 'undefined' ? {} : process.env;

export const RELEASE = environment['PHONG_VIEWER_RELEASE'] !== undefined;

/** The first seed of this run's random tests. */
export const SEED = Number(environment['PHONG_VIEWER_SEED'] ?? 1);

/**
 * The number of repetitions in this run, for a test with `count` in a release run. At least one.
 */
export const repeats = (count: number): number => (RELEASE ? count : Math.ceil(count / 20));

/** A size or a number of points: `full` in a release run, `short` otherwise. */
export const fullOr = (full: number, short: number): number => (RELEASE ? full : short);

/**
 * The whole list in a release run, its first `count` entries otherwise: entries that stand for the
 * others come first.
 */
export const firstOf = <T>(list: readonly T[], count: number): readonly T[] =>
  RELEASE ? list : list.slice(0, count);
