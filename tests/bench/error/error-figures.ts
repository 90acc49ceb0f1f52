// How far a picture is from what it should be, in figures of two kinds: of channels (root mean square, 99.9 %, maximum, share of
// other codes) and of what an eye sees (CIEDE2000, FLIP). Channels are sRGB as a page shows them, in 1/255, not rounded. Knows
// nothing of how either picture came to be; runs in pages and in Node.

import { colorDifference } from './color-difference.js';
import { flipMap } from './flip.js';

/** r g b of each pixel in 1/255, rows from the top, not rounded, all finite. */
export interface ColorPicture {
  readonly width: number;
  readonly height: number;
  /** 3 * width * height numbers; 0 to 255 is what a screen can show, more is kept for the figures of channels. */
  readonly data: Float32Array | Float64Array;
}

export interface ErrorFigures {
  pixels: number;
  /** Root of the mean squared error of channels, in 1/255. */
  rmse: number;
  /** 99.9 % of the channels' absolute errors are no larger, in 1/255. */
  p999: number;
  /** Largest absolute error of a channel, in 1/255. */
  max: number;
  /** Of the channels, 0-1: those whose nearest codes differ. */
  share: number;
  /** Mean CIEDE2000 over pixels. About 1 is just seen between large even fields. */
  deltaE: number;
  /** Largest CIEDE2000 of a pixel. */
  deltaEMax: number;
  /** Mean of LDR-FLIP's map, 0-1. */
  flip: number;
}

/** Throws a RangeError where the sizes differ, a picture is empty or not as large as it says, or a number is not finite. */
export function errorOf(picture: ColorPicture, truth: ColorPicture): ErrorFigures {
  check(picture, 'the picture');
  check(truth, 'the truth');
  if (picture.width !== truth.width || picture.height !== truth.height) {
    throw new RangeError(`sizes differ: ${sizeOf(picture)} and ${sizeOf(truth)}`);
  }
  const pixels = picture.width * picture.height;
  return { pixels, ...channelErrors(picture.data, truth.data), ...seenErrors(picture, truth) };
}

function channelErrors(
  data: ColorPicture['data'],
  truth: ColorPicture['data'],
): Pick<ErrorFigures, 'rmse' | 'p999' | 'max' | 'share'> {
  const errors = new Float64Array(data.length);
  let squares = 0;
  let otherCodes = 0;
  for (let i = 0; i < data.length; i++) {
    const error = Math.abs(data[i]! - truth[i]!);
    errors[i] = error;
    squares += error * error;
    if (nearestCode(data[i]!) !== nearestCode(truth[i]!)) otherCodes += 1;
  }
  errors.sort();
  return {
    rmse: Math.sqrt(squares / errors.length),
    p999: quantileOf(errors, 0.999),
    max: errors[errors.length - 1]!,
    share: otherCodes / errors.length,
  };
}

function seenErrors(
  picture: ColorPicture,
  truth: ColorPicture,
): Pick<ErrorFigures, 'deltaE' | 'deltaEMax' | 'flip'> {
  const [shown, wanted] = [shownOf(picture), shownOf(truth)];
  const pixels = picture.width * picture.height;
  let [sum, max] = [0, 0];
  for (let i = 0; i < shown.data.length; i += 3) {
    const difference = colorDifference(shown.data, wanted.data, i);
    sum += difference;
    if (difference > max) max = difference;
  }
  const map = flipMap(shown, wanted);
  return { deltaE: sum / pixels, deltaEMax: max, flip: map.reduce((total, x) => total + x, 0) / pixels };
}

/** What a screen can show of it. */
function shownOf({ width, height, data }: ColorPicture): ColorPicture {
  return { width, height, data: Float64Array.from(data, clamped) };
}

const clamped = (channel: number): number => Math.min(255, Math.max(0, channel));

/** Halves upwards, as shaders/nearest_code.glsl. */
const nearestCode = (channel: number): number => Math.floor(clamped(channel) + 0.5);

/** As `quantile` of ../statistics.mjs, of numbers that are sorted already: there may be a million. */
function quantileOf(sorted: Float64Array, share: number): number {
  const at = share * (sorted.length - 1);
  const low = sorted[Math.floor(at)]!;
  return low + (sorted[Math.ceil(at)]! - low) * (at - Math.floor(at));
}

function check(picture: ColorPicture, name: string): void {
  const { width, height, data } = picture;
  if (data.length === 0 || data.length !== 3 * width * height) {
    throw new RangeError(`${name} has ${data.length} numbers for ${sizeOf(picture)} pixels of three`);
  }
  const at = data.findIndex((channel) => !Number.isFinite(channel));
  if (at >= 0) {
    const pixel = Math.floor(at / 3);
    const place = `${pixel % width}, ${Math.floor(pixel / width)}`;
    throw new RangeError(`${name} has ${String(data[at])} in channel ${at % 3} of pixel ${place}`);
  }
}

const sizeOf = ({ width, height }: ColorPicture): string => `${width}×${height}`;
