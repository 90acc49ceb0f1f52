// Lets a bounded amount of work run at a time; the rest waits for its turn.

/** Runs `work`, of that weight, once what runs with it weighs no more than the limit. */
type InTurn = <Result>(weight: number, work: () => Promise<Result>) => Promise<Result>;

export function turnsOf(limit: number): InTurn {
  let running = 0;
  const waiting: { readonly weight: number; readonly start: () => void }[] = [];
  const fits = (weight: number) => running + weight <= limit;
  return async (weight, work) => {
    if (waiting.length > 0 || !fits(weight)) {
      await new Promise<void>((resolve) => waiting.push({ weight, start: resolve }));
    } else {
      running += weight;
    }
    try {
      return await work();
    } finally {
      running -= weight;
      for (let next = waiting[0]; next && fits(next.weight); next = waiting[0]) {
        waiting.shift();
        running += next.weight;
        next.start();
      }
    }
  };
}
