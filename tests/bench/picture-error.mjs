// @ts-check
// How far a picture of codes is from the exact means.

/**
 * The root of the mean square over r, g, b, and the share of pixels whose channels are all within one code. In codes.
 * @param {Uint8Array} codes r, g, b of each pixel @param {Float64Array} means r, g, b, a of each pixel, not rounded; premultiplied as the codes
 * @returns {{ rmse: number, within: number }} `within` 0–1
 */
export function pictureError(codes, means) {
  if (codes.length / 3 !== means.length / 4)
    throw new RangeError(`${codes.length / 3} pixels cannot be compared with ${means.length / 4}`);
  let squares = 0;
  let within = 0;
  for (let pixel = 0; pixel < codes.length / 3; pixel++) {
    let largest = 0;
    for (let channel = 0; channel < 3; channel++) {
      const error = Math.abs((codes[3 * pixel + channel] ?? NaN) - (means[4 * pixel + channel] ?? NaN));
      squares += error * error;
      largest = Math.max(largest, error);
    }
    if (largest <= 1) within += 1;
  }
  return { rmse: Math.sqrt(squares / codes.length), within: within / (codes.length / 3) };
}
