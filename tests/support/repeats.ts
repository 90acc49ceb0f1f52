// How often does a random test repeat? As often as its claim says in a release run, a twentieth of it otherwise: the first
// repetitions find nearly everything, and mutants run them thousands of times.

const RELEASE = typeof process !== 'undefined' && process.env['PHONG_VIEWER_RELEASE'] !== undefined;

/** The number of repetitions in this run, for a test with `count` in a release run. At least one. */
export const repeats = (count: number): number => (RELEASE ? count : Math.ceil(count / 20));
