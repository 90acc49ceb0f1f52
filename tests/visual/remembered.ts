// Caches float64 results for a scene, because several pictures of one scene are compared with them.
import type { DeclaredScene } from './ray-cast.js';

/** A memoised `tell`: results are kept as long as the scene exists, keyed by the text of the other arguments. */
export function remembered<A extends readonly (number | string)[], T>(
  tell: (scene: DeclaredScene, ...more: A) => T,
): (scene: DeclaredScene, ...more: A) => T {
  const known = new WeakMap<DeclaredScene, Map<string, T>>();
  return (scene, ...more) => {
    const answers = known.get(scene) ?? new Map<string, T>();
    known.set(scene, answers);
    const key = more.join();
    const answer = answers.has(key) ? answers.get(key)! : tell(scene, ...more);
    answers.set(key, answer);
    return answer;
  };
}
