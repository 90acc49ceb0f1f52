// What float64 says of a scene, told once: several pictures of one scene are held against it.
import type { CastScene } from './ray-cast.js';

/** `tell` as a function that remembers its answers for as long as the scene lives; other arguments are told apart by their text. */
export function remembered<A extends readonly (number | string)[], T>(
  tell: (scene: CastScene, ...more: A) => T,
): (scene: CastScene, ...more: A) => T {
  const known = new WeakMap<CastScene, Map<string, T>>();
  return (scene, ...more) => {
    const answers = known.get(scene) ?? new Map<string, T>();
    known.set(scene, answers);
    const key = more.join();
    const answer = answers.has(key) ? answers.get(key)! : tell(scene, ...more);
    answers.set(key, answer);
    return answer;
  };
}
