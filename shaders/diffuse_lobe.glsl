// Lambert's law.

/** max(NoL, 0); NoL may be negative. */
float diffuseLobe(float NoL) {
  return max(NoL, 0.0);
}
