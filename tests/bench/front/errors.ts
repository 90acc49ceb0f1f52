// How far a picture is from the truth, in 1/255 of a channel, over all channels of all pixels.

export interface ErrorFigures {
  readonly rmse: number;
  /** The error that 99.9 % of the channels do not exceed. */
  readonly p999: number;
  readonly max: number;
}

/** Both of one length, without NaN. Throws a RangeError otherwise. */
export function errorOf(picture: Float64Array, truth: Float64Array): ErrorFigures {
  if (picture.length !== truth.length || picture.length === 0) {
    throw new RangeError(
      `a picture of ${picture.length} channels has no error against ${truth.length}`,
    );
  }
  const errors = picture.map((channel, i) => Math.abs(channel - truth[i]!)).sort();
  const max = errors[errors.length - 1]!; // NaN sorts last
  if (Number.isNaN(max)) throw new RangeError('a channel is not a number');
  return {
    rmse: Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / errors.length),
    p999: errors[Math.floor(0.999 * (errors.length - 1))]!,
    max,
  };
}
