// A spot's cone and the decay away from its axis. Where either is steep, from chords instead of cosines: (1 - cos)/2 =
// |a - b|²/4 for unit vectors does not cancel at small angles. Needs power. `shape` says what the spot has: see light_loop.

/** |v|²/4. */
float quarterSquare(vec3 v) {
  return 0.25 * dot(v, v);
}

/**
 * Whether the direction is inside the cone. toAxis = (1 - c)/2 and toBack = (1 + c)/2 with c the cosine between fragment
 * and axis; limit as packed: >= 0 the largest toAxis, < 0 minus the smallest toBack.
 */
bool insideCone(float toAxis, float toBack, float limit, int shape) {
  bool narrow = (shape & SHAPE_NARROW) != 0;
  bool wide = (shape & SHAPE_WIDE) != 0;
  if (narrow && wide) return limit < 0.0 ? toBack >= -limit : toAxis <= limit;
  if (narrow) return toAxis <= limit;
  if (wide) return toBack >= -limit;
  return true;
}

/** ((c + 1)/2)^cutoff. */
float spotDecay(float toAxis, float toBack, float cutoff, int shape) {
  int whole = shape >> SHAPE_POWER_SHIFT;
  bool chords = (shape & SHAPE_CHORDS) != 0;
  if (whole > 0) return wholePower(chords ? 1.0 - toAxis : toBack, whole);
  if ((shape & SHAPE_DECAY) != 0 && !chords) return tamePower(toBack, cutoff);
  if ((shape & SHAPE_MILD) != 0) return mildPower(toBack, cutoff);
  if ((shape & SHAPE_DECAY) != 0) return powerNearOne(toBack, toAxis, cutoff);
  return 1.0;
}
