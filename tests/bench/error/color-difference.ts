// How different two colours look side by side: CIEDE2000, by culori, between sRGB colours in 1/255 under D65.

import { differenceCiede2000, modeLab65, modeRgb, useMode, type Lab65 } from 'culori/fn';

useMode(modeRgb);
const labOf = useMode(modeLab65);
const ciede2000 = differenceCiede2000();

type Channels = Float32Array | Float64Array;

/** CIEDE2000 between the colours whose r g b start at `i` in each; exactly 0 where they are equal. Channels in 0-255. */
export function colorDifference(ours: Channels, theirs: Channels, i: number): number {
  // Most pixels of a good approximation are equal, and the formula takes microseconds.
  if (ours[i] === theirs[i] && ours[i + 1] === theirs[i + 1] && ours[i + 2] === theirs[i + 2]) return 0;
  return ciede2000(labAt(ours, i), labAt(theirs, i));
}

const labAt = (data: Channels, i: number): Lab65 =>
  labOf({ mode: 'rgb', r: data[i]! / 255, g: data[i + 1]! / 255, b: data[i + 2]! / 255 });
