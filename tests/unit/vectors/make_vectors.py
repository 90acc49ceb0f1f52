"""Writes equation.jsonl, a case a line: fragments shaded by the textbook equation in 50 digits, from the written equation alone.

Needs Python 3 and mpmath; run it in this folder. The same seed gives the same file.

Inputs are doubles and taken to be exact; results are rounded to doubles once, at the end. World space, colours 255 = 1
coming in and 1 = full going out. Cases that no float64 program could get right to 1e-12 are drawn again: a fragment
within 1e-12 rad of a cone's edge, NoL or a base within 1e-13 of 0 where the result jumps there, and bases whose
rounding the exponent multiplies beyond that. Exact zeros are kept: the equation says what they mean.
"""

import json
import random

from mpmath import atan2, cos, mp, mpf, pi, sin, sqrt

mp.dps = 50
rng = random.Random(20240217)

# Thresholds are doubles, as the inputs that meet them are.
NEAREST = mpf(1e-15)
LEAST_EXPONENT = mpf(1e-6)


class IllConditioned(Exception):
    pass


# --- vectors -----------------------------------------------------------------------------------------------------


def exact(v):
    return [mpf(x) for x in v]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def times(a, s):
    return [x * s for x in a]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def size(a):
    return sqrt(dot(a, a))


def unit(a):
    s = size(a)
    return [mpf(0)] * 3 if s == 0 else [x / s for x in a]


# --- the equation ------------------------------------------------------------------------------------------------


def power(x, n, slack=mpf("2e-16")):
    """max(x, 0)^n; x^0 = 1. `slack` is the absolute rounding that x may have in float64 where it is small."""
    if n < LEAST_EXPONENT:
        return mpf(1)
    if x <= 0:
        if -1e-13 < x < 0:
            raise IllConditioned
        return mpf(0)
    if x < 0.5 and n * x ** (n - 1) * slack > mpf("2e-13"):
        raise IllConditioned
    return x**n


def decode(x):
    if x <= 0:
        return mpf(0)
    return x / mpf("12.92") if x <= mpf("0.04045") else ((x + mpf("0.055")) / mpf("1.055")) ** mpf("2.4")


def encode(x):
    if x <= 0:
        return mpf(0)
    if abs(x - mpf("0.0031308")) < 1e-10:
        raise IllConditioned  # the published branches do not meet there
    return x * mpf("12.92") if x <= mpf("0.0031308") else mpf("1.055") * x ** (1 / mpf("2.4")) - mpf("0.055")


def share(light, fragment, surface, options, N, V):
    linear = options.get("linear", False)
    p, eye = exact(fragment["p"]), exact(fragment["eye"])
    x, y, z, w = exact(light["position"])
    place, axis = [x, y, z], exact(light["axis"])
    if light["space"] == "camera":
        right, up, back = (exact(options["camera"][name]) for name in ("right", "up", "back"))
        turn = lambda v: plus(plus(times(right, v[0]), times(up, v[1])), times(back, v[2]))
        place, axis = turn(place), turn(axis)
        if w == 1:
            place = plus(eye, place)
    to_light = minus(place, p) if w == 1 else place
    d = size(to_light)
    if w == 1 and d < NEAREST:
        present, d, L = False, mpf(0), [mpf(0)] * 3
    else:
        present, L = d > 0, unit(to_light)

    kc, kl, kq = exact(light["attenuation"])
    att = 1 / max(kc + kl * d + kq * d * d, mpf(1)) if w == 1 else mpf(1)

    A = unit(axis)
    away = times(A, -1)
    c, inside, decay = mpf(1), True, mpf(1)
    if present and dot(A, A) != 0:
        c = dot(L, away)
        angle = atan2(size(cross(L, away)), c)
        limit = mpf(light["aperture"]) * pi / 180
        if light["aperture"] < 180:
            if angle != limit and abs(angle - limit) < 1e-12:
                raise IllConditioned
            inside = angle <= limit
        # A chord of unit vectors rounds by 2e-16 at most, its square by that times the chord.
        to_back = (1 + c) / 2
        decay = power(to_back, mpf(light["cutoff"]), slack=sqrt(to_back) * mpf("4e-16"))

    NoL = dot(N, L)
    if present and NoL != 0 and abs(NoL) < 1e-13:
        raise IllConditioned
    if options.get("reflection", "phong") == "phong":
        RoV = dot(minus(times(N, 2 * NoL), L), V)
    else:
        H = plus(L, V)
        if 0 < size(H) < 1e-3:
            raise IllConditioned
        RoV = dot(N, unit(H))
    spec = power(RoV, mpf(surface["shininess"])) if NoL > 0 else mpf(0)

    to_color = lambda v: [decode(x / 255) if linear else x / 255 for x in exact(v)]
    base = [decode(x) if linear else x for x in exact(surface.get("baseColor", [1, 1, 1]))]
    terms = options.get("terms", ["ambient", "diffuse", "specular"])
    total = [mpf(0)] * 3
    if inside:
        for i in range(3):
            if "ambient" in terms:
                total[i] += base[i] * to_color(surface["ka"])[i] * to_color(light["ambient"])[i] * decay
            if "diffuse" in terms:
                k = base[i] * to_color(surface["kd"])[i] * to_color(light["diffuse"])[i]
                total[i] += k * att * max(NoL, mpf(0)) * decay
            if "specular" in terms:
                k = to_color(surface["ks"])[i] * to_color(light["specular"])[i]
                total[i] += k * att * spec * decay
    intensity = sum(max(to_color(light[name])) for name in ("ambient", "diffuse", "specular"))
    return total, {"c": c, "inside": inside, "att": att, "decay": decay, "NoL": NoL, "RoV": RoV}, intensity


def shade(case):
    fragment, surface, options = case["fragment"], case["surface"], case["options"]
    N = unit(exact(fragment["normal"]))
    V = unit(minus(exact(fragment["eye"]), exact(fragment["p"])))
    total, shares, intensity = [mpf(0)] * 3, [], mpf(0)
    for light in case["lights"]:
        if not light["active"]:
            shares.append(None)
            continue
        part, facts, bright = share(light, fragment, surface, options, N, V)
        total = plus(total, part)
        intensity += bright
        shares.append({k: v if isinstance(v, bool) else float(v) for k, v in facts.items()})
    if options.get("linear"):
        total = [encode(x) for x in total]
    return {"sum": [float(x) for x in total], "shares": shares, "intensity": float(intensity)}


# --- cases -------------------------------------------------------------------------------------------------------


def uniform(low, high):
    return float(f"{rng.uniform(low, high):.6g}")


def vector(low=-3.0, high=3.0):
    return [uniform(low, high) for _ in range(3)]


def color(high=255):
    return [rng.randint(0, high) for _ in range(3)]


DEFAULTS = dict(
    active=True, ambient=[0, 0, 0], diffuse=[255, 255, 255], specular=[255, 255, 255], position=[1, 2, 3, 0],
    axis=[0, 0, -1], aperture=180, cutoff=0, attenuation=[1, 0, 0], space="world",
)


def light(**values):
    assert not set(values) - set(DEFAULTS)
    return {**DEFAULTS, **values}


def short(one):
    """The case as it is written: lights without what is their default."""
    lights = [{k: v for k, v in values.items() if v != DEFAULTS[k]} for values in one["lights"]]
    return json.dumps({**one, "lights": lights})


def random_light(spaces=("world",)):
    return light(
        active=rng.random() < 0.9, ambient=color(60), diffuse=color(), specular=color(),
        position=[*vector(), rng.choice([0, 1])], axis=vector(),
        aperture=rng.choice([180, 180, uniform(0, 180), 150, 90, 60]),
        cutoff=rng.choice([0, 0, 1, uniform(0, 2), uniform(0, 60)]),
        attenuation=rng.choice([[1, 0, 0], [0, 0, 0], [uniform(0, 2), uniform(0, 1), uniform(0, 1)]]),
        space=rng.choice(spaces),
    )


def surface(**values):
    return {"ka": color(), "kd": color(), "ks": color(), "shininess": rng.choice([0, 1, 8, 32, uniform(1, 200)]), **values}


def fragment(**values):
    return {"p": vector(-1, 1), "normal": vector(), "eye": vector(2, 6), **values}


def axes():
    """Right, up and back of a camera at random angles, as doubles."""
    theta, phi = mpf(uniform(-180, 180)) * pi / 180, mpf(uniform(1, 179)) * pi / 180
    right = [cos(theta), mpf(0), -sin(theta)]
    back = [sin(phi) * sin(theta), cos(phi), sin(phi) * cos(theta)]
    return {k: [float(x) for x in v] for k, v in (("right", right), ("up", cross(back, right)), ("back", back))}


def case(name, lights, frag=None, surf=None, **options):
    return {
        "name": name, "fragment": frag or fragment(), "surface": surf or surface(), "lights": lights,
        "options": options,
    }


def near(direction, angle):
    """A direction that many radians off another, as doubles of no particular length."""
    d = unit(exact(direction))
    side = unit(cross(d, exact(vector())))
    length = mpf(uniform(0.5, 3))
    return [float(length * (cos(angle) * x + sin(angle) * y)) for x, y in zip(d, side)]


def exponent(low, high):
    return float(f"{10 ** rng.uniform(low, high):.4g}")


def seen_highlight(n, off, **options):
    """A directional light whose highlight is `off` radians from the eye."""
    frag = fragment(p=[0, 0, 0])
    N, V = unit(exact(frag["normal"])), unit(exact(frag["eye"]))
    mirrored = minus(times(N, 2 * dot(N, V)), V)
    if dot(N, V) < 0.1:
        raise IllConditioned
    return case("", [light(position=[*near(mirrored, off), 0])], frag, surface(shininess=n), **options)


def many():
    yield "mixed lights", 60, lambda: case("", [random_light() for _ in range(rng.randint(1, 5))])
    yield "linear", 20, lambda: case("", [random_light() for _ in range(3)], None, surface(baseColor=[uniform(0, 1) for _ in range(3)]), linear=True)
    yield "Blinn's lobe", 20, lambda: case("", [random_light() for _ in range(3)], reflection="blinn-phong")
    yield "camera space", 20, lambda: case("", [random_light(("camera", "world")) for _ in range(3)], camera=axes())
    yield "some terms", 12, lambda: case("", [random_light() for _ in range(3)], terms=rng.sample(["ambient", "diffuse", "specular"], rng.randint(0, 2)))
    yield "base colour", 8, lambda: case("", [random_light() for _ in range(2)], None, surface(baseColor=[uniform(0, 1) for _ in range(3)]))

    def highlight():
        n = exponent(0, 6)
        return seen_highlight(n, rng.uniform(0, 2) / n**0.5)

    yield "highlights to exponent 1e6", 20, highlight

    def half_vector():
        n = exponent(0, 6)
        return seen_highlight(n, rng.uniform(0, 2) / n**0.5, reflection="blinn-phong")

    yield "Blinn's highlights to exponent 1e6", 14, half_vector
    yield "exponents below 1", 12, lambda: case("", [random_light()], None, surface(shininess=rng.choice([1e-7, 1e-6, 1e-3, uniform(0, 1)])))

    def near_axis():
        k = exponent(0, 6)
        at = vector()
        return case("", [light(position=[*at, 1], axis=near(times(exact(at), -1), rng.uniform(0, 3) / k**0.5), cutoff=k, ambient=color())], fragment(p=[0, 0, 0]))

    yield "near a spot's axis, cutoff to 1e6", 20, near_axis

    def behind(low, high, cutoffs):
        at = vector()
        spot = light(position=[*at, 1], axis=near(at, exponent(low, high)), cutoff=rng.choice(cutoffs), ambient=color())
        return case("", [spot], fragment(p=[0, 0, 0]))

    yield "behind a spot", 20, lambda: behind(-1, 0, [uniform(0, 1), uniform(0, 3), 8])
    yield "close to a spot's back axis", 20, lambda: behind(-4, -1, [0.05, 0.1, 0.3, uniform(0, 1)])

    def cone(low, high):
        aperture = exponent(low, high)
        at = vector()
        off = mpf(aperture) * pi / 180 * mpf(rng.choice([0.3, 0.999, 1.001, 1 - 1e-9, 1 + 1e-9]))
        return case("", [light(position=[*at, rng.choice([0, 1])], axis=near(times(exact(at), -1), off), aperture=aperture)], fragment(p=[0, 0, 0]))

    yield "cones under 1 degree", 14, lambda: cone(-2, 0)
    yield "edges of cones", 20, lambda: cone(0.3, 2.25)

    def far(offset):
        shift = lambda v: [float(x + offset) for x in v]
        lights = [light(position=[*shift(vector()), 1], ambient=color(60), axis=vector(), cutoff=2, attenuation=[1, 0.1, 0.1]) for _ in range(3)]
        return case("", lights, fragment(p=shift(vector(-1, 1)), eye=shift(vector(2, 6))))

    for offset in (2**14, 2**27, 2**34):
        yield f"moved by {offset}", 6, lambda offset=offset: far(offset)

    def scaled(s):
        at = lambda v: [x * s for x in v]
        lights = [light(position=[*at(vector()), 1], axis=at(vector()), cutoff=3, attenuation=[0.5, 0.3 / s, 0.2 / s / s]) for _ in range(3)]
        return case("", lights, fragment(p=at(vector(-1, 1)), eye=at(vector(2, 6)), normal=at(vector())))

    for s in (1e-12, 1e-6, 1e6):
        yield f"scaled by {s}", 6, lambda s=s: scaled(s)

    far_away = lambda: [rng.uniform(-1e15, 1e15) for _ in range(3)]
    yield "corners of the domain", 14, lambda: case("", [
        light(position=[*far_away(), 1], axis=far_away(), cutoff=1, attenuation=[uniform(0, 1e6), uniform(0, 1), 1e-30], diffuse=[1e6, 1e6, 0]),
        light(position=[*far_away(), 0], specular=[1e6, 0, 1e6]),
    ], fragment(p=far_away(), eye=far_away(), normal=far_away()))
    yield "the shortest vectors", 8, lambda: case("", [
        light(position=[rng.randint(1, 9) * 5e-324, rng.randint(1, 9) * 1e-320, 0, 0], axis=[0, -5e-324, -1e-322], cutoff=2),
    ], fragment(normal=[1e-310, 5e-311, 1e-310]))
    yield "bright lights, linear", 8, lambda: case("", [light(diffuse=[rng.uniform(0, 1e6) for _ in range(3)], position=[*vector(), 1])], linear=True)
    yield "dark light near the knee of sRGB", 8, lambda: case("", [light(diffuse=[rng.uniform(5, 15) for _ in range(3)], specular=[0, 0, 0], ambient=[uniform(0, 3)] * 3)], None, surface(kd=[255, 255, 200]), linear=True)


def degenerate():
    """The rows of the equation's table of limits."""
    frag = {"p": [0, 0, 0], "normal": [0, 0, 2], "eye": [0, 3, 4]}
    surf = {"ka": [255, 128, 0], "kd": [255, 200, 100], "ks": [128, 128, 255], "shininess": 4}
    sharp, even = {**surf, "shininess": 32}, {**surf, "shininess": 0}
    lit = dict(ambient=[50, 60, 70], position=[0, 0, 2, 1])
    from_side, from_below = [3, 0, 0, 1], [1, 0, -1, 0]
    yield case("exponent 0, base above 0", [light(**lit)], frag, even)
    yield case("exponent 0, base 0", [light(position=[0, -4, 3, 0])], {**frag, "eye": [0, 3, 4]}, even)
    yield case("exponent 0, light below", [light(position=from_below)], frag, even)
    yield case("exponent 0, light at the side", [light(position=from_side)], frag, even)
    yield case("exponent 1e-7", [light(**lit)], frag, {**surf, "shininess": 1e-7})
    yield case("base 0, exponent above 0", [light(position=[0, 4, 3, 0])], {**frag, "eye": [0, 3, 4]}, {**surf, "shininess": 0.5})
    yield case("right behind a spot with a decay", [light(**lit, axis=[0, 0, 1], cutoff=0.5)], frag, sharp)
    yield case("right behind a spot with next to none", [light(**lit, axis=[0, 0, 1], cutoff=1e-7)], frag, sharp)
    yield case("aperture 180, right behind", [light(**lit, axis=[0, 0, 1], aperture=180)], frag, sharp)
    yield case("aperture 0, on the axis", [light(**lit, axis=[0, 0, -7], aperture=0)], frag, sharp)
    yield case("aperture 0, on a slanting axis", [light(**{**lit, "position": [1, 2, 3, 1]}, axis=[-3, -6, -9], aperture=0)], frag, sharp)
    yield case("aperture 0, just off the axis", [light(**lit, axis=[0, 1e-9, -1], aperture=0)], frag, sharp)
    yield case("axis zero", [light(**lit, axis=[0, 0, 0], aperture=5, cutoff=50)], frag, sharp)
    yield case("light at the fragment", [light(ambient=[50, 60, 70], position=[0, 0, 0, 1], axis=[0, 0, 1], aperture=5, cutoff=9, attenuation=[2, 5, 5])], frag, even)
    yield case("light nearer than 1e-15", [light(ambient=[50, 60, 70], position=[0, 0, 9e-16, 1], aperture=5, cutoff=9)], frag, even)
    yield case("light at 2e-15", [light(ambient=[50, 60, 70], position=[0, 0, 2e-15, 1], attenuation=[1, 1, 1])], frag, sharp)
    yield case("directional without a vector", [light(ambient=[50, 60, 70], position=[0, 0, 0, 0], aperture=5, cutoff=9)], frag, even)
    yield case("normal of no length", [light(**lit)], {**frag, "normal": [0, 0, 0]}, even)
    yield case("attenuation 0 0 0", [light(**lit, attenuation=[0, 0, 0])], frag, sharp)
    yield case("attenuation below 1", [light(**lit, attenuation=[0.1, 0.1, 0.1])], frag, sharp)
    yield case("eye at the fragment", [light(**lit)], {**frag, "eye": [0, 0, 0]}, sharp)
    yield case("eye at the fragment, exponent 0", [light(**lit)], {**frag, "eye": [0, 0, 0]}, even)
    yield case("light opposite the eye", [light(position=[0, -3, -4, 0])], {**frag, "normal": [0, 0, -1]}, even, reflection="blinn-phong")
    yield case("no light", [], frag, sharp)
    yield case("no light that is switched on", [light(active=False)], frag, sharp)
    yield case("black in linear light", [light(diffuse=[0, 0, 0], specular=[0, 0, 0])], frag, sharp, linear=True)


def main():
    cases = []
    for one in degenerate():
        cases.append({**one, "want": shade(one)})
    for name, number, make in many():
        while number > 0:
            try:
                one = make()
                one["name"] = one["name"] or name
                cases.append({**one, "want": shade(one)})
            except IllConditioned:
                continue
            number -= 1
    with open("equation.jsonl", "w") as file:
        file.writelines(short(one) + "\n" for one in cases)
    print(len(cases), "cases")


main()
