// A specular lobe averaged over a pixel, in closed form. For fragment shaders; needs power.
//
// A lobe is (1 - y)^n with y = |e|²/2, where e is L - W or N - H. Near the highlight that is exp(-n|e|²/2): a normal
// distribution of e, of variance 1/n. From one side of the pixel to the other e moves by dx and by dy, every place
// alike: j = dx/√12 and dy/√12 are the standard deviations. The average is to second order again a normal distribution,
// its covariance C = I/n + jx jxᵀ + jy jyᵀ, its height 1/√det(nC) (filtering a lobe by the pixel's footprint:
// Kaplanyan, Hill, Patney and Lefohn, "Filtering distributions of normals for shading antialiasing", HPG 2016;
// Tokuyoshi and Kaplanyan, "Improved geometric specular antialiasing", I3D 2019; both for distributions of
// microfacets). Along the principal axes of jx jxᵀ + jy jyᵀ, C is diagonal, so nothing cancels where the sides are
// parallel, as they are on a cylinder.
//
// A pixel is flatter than a normal distribution: the fourth cumulant of a side's places is -w⁴/120, w = √12 j. With z =
// C⁻¹e, s = j·z and q = jᵀC⁻¹j that is, by Edgeworth's series, the factor 1 - (144/120)/24 Σ (s⁴ - 6 s²q + 3q²) over
// both sides. Without it the largest error is two to three times as large.

/** A pixel as a lobe meets it. */
struct Footprint {
  /** Principal axes: perpendicular, each as long as the standard deviation of e along it. */
  vec3 first;
  vec3 second;
  /** n/(1 + n|axis|²) of each. */
  vec2 pull;
  /** Cosine and sine of the turn from the axes to the pixel's sides. */
  vec2 turn;
  /** q of each side, in [0, 1). */
  vec2 share;
  /** The average where e is zero, without the factor; in (0, 1]. */
  float peak;
};

/** Of how e moves from one side of the pixel to the other, |dx|, |dy| <= 4, and n >= 0. */
Footprint footprintOf(vec3 dx, vec3 dy, float n) {
  const float DEVIATION = 0.28867513459481287; // 1/√12
  vec3 jx = dx * DEVIATION;
  vec3 jy = dy * DEVIATION;
  // Jacobi's rotation by the smaller angle, for |jx|² - |jy|² = 2 d and jx·jy = b. Where both are below 1e-16, n times
  // them is nothing beside 1, and it does not matter how the axes lie.
  float d = 0.5 * dot(jx + jy, jx - jy);
  float b = dot(jx, jy);
  float tangent = (d < 0.0 ? -b : b) / (abs(d) + sqrt(max(d * d + b * b, 1e-32)));
  float cosine = inversesqrt(1.0 + tangent * tangent);
  vec2 turn = vec2(cosine, tangent * cosine);
  vec3 first = turn.x * jx + turn.y * jy;
  vec3 second = turn.x * jy - turn.y * jx;
  vec2 squares = vec2(dot(first, first), dot(second, second));
  vec2 grown = 1.0 + n * squares;
  vec2 pull = vec2(n / grown.x, n / grown.y);
  vec2 shares = pull * squares;
  vec2 turned = turn * turn;
  vec2 share = vec2(dot(turned, shares), dot(turned, shares.yx));
  return Footprint(first, second, pull, turn, share, inversesqrt(grown.x * grown.y));
}

/** The average of the lobe (1 - |e|²/2)^n over the footprint. In [0, 1]. */
float averagedLobe(vec3 e, float n, Footprint pixel) {
  vec2 along = vec2(dot(e, pixel.first), dot(e, pixel.second));
  vec2 t = pixel.pull * along;
  // |e|² is at least what is taken from it, but for rounding.
  float y = max(0.5 * dot(e, e) - 0.5 * dot(along, t), 0.0);
#if defined(INTEGER_SHININESS)
  float lobe = powInteger(max(1.0 - y, 0.0), INTEGER_SHININESS);
#elif defined(SHININESS_IS_MILD)
  float lobe = powMild(1.0 - y, n);
#else
  float lobe = powNearOne(1.0 - y, y, n);
#endif
  vec2 s = vec2(pixel.turn.x * t.x - pixel.turn.y * t.y, pixel.turn.y * t.x + pixel.turn.x * t.y);
  vec2 s2 = s * s;
  vec2 q = pixel.share;
  vec2 flatness = s2 * (s2 - 6.0 * q) + 3.0 * q * q;
  // Far off the highlight the series has left the distribution: below 0, where next to nothing is left.
  return clamp(lobe * pixel.peak * (1.0 - 0.05 * (flatness.x + flatness.y)), 0.0, 1.0);
}

/**
 * How the unit vector `along` of a vector, whose square is `squared`, turns when that vector moves by `move`. At most
 * of length 1, however far: the sine of the angle. `move` up to 1e19; `along` may be zero.
 */
vec3 turning(vec3 along, vec3 move, float squared) {
  vec3 across = move - along * dot(along, move);
  return across * inversesqrt(max(squared + dot(across, across), NEAREST_SQUARED));
}
