// How far a picture is from the truth, in 1/255 of a channel.

/**
 * Of every channel. What is not a number is as wrong as a channel can be. Throws a RangeError for
 * pictures of different sizes.
 */
export function errorsOf(picture: Float64Array, truth: Float64Array): Float64Array {
  if (picture.length !== truth.length || picture.length === 0) {
    throw new RangeError(
      `a picture of ${picture.length} channels has no error against ${truth.length}`,
    );
  }
  return picture.map((channel, i) => (Number.isNaN(channel) ? 255 : Math.abs(channel - truth[i]!)));
}

export const largest = (errors: Float64Array): number =>
  errors.reduce((most, error) => Math.max(most, error), 0);
