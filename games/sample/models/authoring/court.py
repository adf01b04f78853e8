"""What the court is built of: a fluted column, an arch, a lantern, a bench, a jar."""

import math

from authoring.blender_files import make_material, make_object
from authoring.parts import Part, box, prism, revolve

BAY = 7.0 / 3.0  # metres from column to column


def fluted(profile, segments, flutes, depth, material=0):
    """Turned round z like revolve(), with grooves between the second and the last but one ring."""
    part = revolve(profile, segments, material)
    grooved = []
    for i, (x, y, z) in enumerate(part.vertices):
        ring, at = divmod(i - 1, segments)
        if 1 < ring < len(profile) - 4 and 0 < i < len(part.vertices) - 1:
            factor = 1.0 - depth * abs(math.sin(0.5 * flutes * math.tau * at / segments))
            x, y = x * factor, y * factor
        grooved.append((x, y, z))
    return part._replace(vertices=grooved)


def build_column():
    """3.4 m high, its foot in the origin."""
    swelling = [(0.245 - 0.045 * share**1.6, 0.3 + 2.6 * share) for share in (0.0, 0.02, 0.25, 0.5, 0.75, 0.98, 1.0)]
    shaft = [(0.0, 0.26), (0.245, 0.26), *swelling, (0.2, 2.94), (0.0, 2.94)]
    torus = [(0.0, 0.14), (0.29, 0.14), (0.32, 0.17), (0.32, 0.2), (0.29, 0.24), (0.25, 0.28), (0.0, 0.28)]
    echinus = [(0.0, 2.9), (0.2, 2.9), (0.22, 2.95), (0.22, 2.98), (0.3, 3.1), (0.32, 3.16), (0.0, 3.16)]
    parts = [
        box((0.0, 0.0, 0.075), (0.72, 0.72, 0.15)),
        revolve(torus, 32),
        fluted(shaft, 64, 16, 0.07),
        revolve(echinus, 32),
        box((0.0, 0.0, 3.275), (0.7, 0.7, 0.25)),
    ]
    make_object("column", parts, [make_material("column", "#d6cab0", 0.9)], 32.0)


def build_arch():
    """Between two columns: a wall with a round opening, from the capitals up, 0.5 m thick. Its origin is half way."""
    half, radius, rise, segments = 0.5 * BAY, 0.5 * BAY - 0.3, 1.3, 20
    outline = [(half, 0.0), (half, rise), (-half, rise), (-half, 0.0), (-radius, 0.0)]
    outline += [
        (-radius * math.cos(math.pi * i / segments), radius * math.sin(math.pi * i / segments))
        for i in range(1, segments)
    ]
    outline += [(radius, 0.0)]
    wall = prism(outline, -0.25, 0.25)
    upright = wall._replace(vertices=[(x, -z, y) for x, y, z in wall.vertices])
    make_object("arch", [upright], [make_material("arch", "#cbbd9f", 0.9)], 25.0)


def build_lantern():
    """An iron cage that hangs from its origin and narrows downwards; the light sits 0.25 m below its origin."""
    iron, wax = 0, 1
    cap = [(0.0, -0.2), (0.16, -0.2), (0.165, -0.185), (0.06, -0.08), (0.02, -0.06), (0.02, 0.0), (0.0, 0.0)]
    foot = [(0.0, -0.5), (0.02, -0.49), (0.065, -0.47), (0.065, -0.45), (0.03, -0.445), (0.0, -0.445)]
    candle = [(0.0, -0.45), (0.025, -0.45), (0.025, -0.33), (0.0, -0.325)]

    def bar(angle):
        rod = box((0.0, 0.0, -0.325), (0.014, 0.014, 0.28), iron)
        return rod._replace(vertices=[
            (x + (0.27 + 0.47 * z) * math.cos(angle), y + (0.27 + 0.47 * z) * math.sin(angle), z)
            for x, y, z in rod.vertices
        ])

    materials = [make_material("iron", "#3b3630", 0.6), make_material("wax", "#f0e6c8", 0.8)]
    bars = [bar(math.tau * (i + 0.5) / 6) for i in range(6)]
    parts = [revolve(cap, 24, iron), revolve(foot, 24, iron), revolve(candle, 12, wax), *bars]
    make_object("lantern", parts, materials, 35.0)


def build_bench():
    seat = box((0.0, 0.0, 0.43), (1.8, 0.46, 0.08))
    legs = [box((x, 0.0, 0.2), (0.16, 0.38, 0.4)) for x in (-0.65, 0.65)]
    make_object("bench", [seat, *legs], [make_material("bench", "#bdb094", 0.9)], 30.0)


def build_jar():
    """Half a metre wide, with two handles."""
    clay = [
        (0.0, 0.0), (0.13, 0.0), (0.15, 0.03), (0.22, 0.2), (0.27, 0.42), (0.26, 0.56), (0.19, 0.72), (0.11, 0.8),
        (0.095, 0.88), (0.14, 0.96), (0.14, 0.98), (0.11, 0.98), (0.07, 0.88), (0.07, 0.8), (0.0, 0.78),
    ]
    handles = [handle(sign) for sign in (-1.0, 1.0)]
    make_object("jar", [revolve(clay, 32), *handles], [make_material("clay", "#a8623f", 0.8)], 40.0)


def handle(sign):
    """A bent rod of eight sides from the neck to the shoulder, its ends inside of the jar."""
    sides, steps = 8, 10
    rings = []
    for step in range(steps + 1):
        angle = math.radians(110.0 - 190.0 * step / steps)
        center = (sign * (0.12 + 0.13 * math.cos(angle)), 0.0, 0.74 + 0.15 * math.sin(angle))
        out = (sign * math.cos(angle), 0.0, math.sin(angle))
        rings.append([
            (center[0] + 0.022 * math.cos(b) * out[0], 0.022 * math.sin(b), center[2] + 0.022 * math.cos(b) * out[2])
            for b in (math.tau * side / sides for side in range(sides))
        ])
    vertices = [vertex for ring in rings for vertex in ring]
    faces = [
        (r * sides + i, r * sides + (i + 1) % sides, (r + 1) * sides + (i + 1) % sides, (r + 1) * sides + i)
        for r in range(steps) for i in range(sides)
    ]
    faces += [tuple(reversed(range(sides))), tuple(range(steps * sides, (steps + 1) * sides))]
    if sign > 0.0:
        return Part(vertices, [tuple(reversed(face)) for face in faces])
    return Part(vertices, faces)
