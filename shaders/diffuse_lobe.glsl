// Lambert's law.

/**
 * max(NoL, 0). NoL is a cosine: it may be negative, and above 1 by rounding. Clamping both sides is
 * free on a GPU.
 */
float diffuseLobe(float NoL) {
  return clamp(NoL, 0.0, 1.0);
}
