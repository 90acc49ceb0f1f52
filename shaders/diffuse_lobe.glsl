// Lambert's law.

/** max(NoL, 0) for a cosine; NoL may be negative, and above 1 by rounding. To clamp on both sides costs a GPU nothing. */
float diffuseLobe(float NoL) {
  return clamp(NoL, 0.0, 1.0);
}
