"""Closed surfaces as plain lists: what the models are put together from. Z is up, metres."""

import math
from typing import NamedTuple


class Part(NamedTuple):
    """A closed surface whose faces turn counter-clockwise seen from outside."""

    vertices: list  # of (x, y, z)
    faces: list  # of tuples of vertex numbers
    material: int = 0


def revolve(profile, segments, material=0):
    """A profile of (radius, height), upwards, turned round the z axis. Its ends must lie on the axis."""
    assert profile[0][0] == 0.0 and profile[-1][0] == 0.0
    rings = profile[1:-1]
    vertices = [(0.0, 0.0, profile[0][1])]
    for radius, height in rings:
        for i in range(segments):
            angle = math.tau * i / segments
            vertices.append((radius * math.cos(angle), radius * math.sin(angle), height))
    vertices.append((0.0, 0.0, profile[-1][1]))

    def at(ring, i):
        return 1 + ring * segments + i % segments

    faces = []
    for i in range(segments):
        faces.append((0, at(0, i + 1), at(0, i)))
        for ring in range(len(rings) - 1):
            faces.append((at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)))
        faces.append((at(len(rings) - 1, i), at(len(rings) - 1, i + 1), len(vertices) - 1))
    return Part(vertices, faces, material)


def prism(outline, low, high, material=0):
    """An outline of (x, y), counter-clockwise, raised from z = low to z = high."""
    count = len(outline)
    vertices = [(x, y, z) for z in (low, high) for x, y in outline]
    sides = [(i, (i + 1) % count, count + (i + 1) % count, count + i) for i in range(count)]
    return Part(vertices, [tuple(reversed(range(count))), tuple(range(count, 2 * count)), *sides], material)


def box(center, size, material=0):
    x, y = 0.5 * size[0], 0.5 * size[1]
    half = 0.5 * size[2]
    return moved(prism([(-x, -y), (x, -y), (x, y), (-x, y)], -half, half, material), center)


def scalloped(part, count, depth):
    """Waves round the z axis that grow with the distance from it, squared."""
    def waved(vertex):
        x, y, z = vertex
        factor = 1.0 + depth * (x * x + y * y) * math.cos(count * math.atan2(y, x))
        return x * factor, y * factor, z

    return part._replace(vertices=[waved(vertex) for vertex in part.vertices])


def ellipsoid(center, radii, rings, segments, material=0):
    """Rings do not count the poles."""
    heights = [math.pi * i / (rings + 1) for i in range(1, rings + 1)]
    profile = [(0.0, -1.0), *((math.sin(a), -math.cos(a)) for a in heights), (0.0, 1.0)]
    return moved(scaled(revolve(profile, segments, material), radii), center)


def scaled(part, factors):
    return part._replace(vertices=[tuple(v * f for v, f in zip(vertex, factors)) for vertex in part.vertices])


def moved(part, offset):
    return part._replace(vertices=[tuple(v + o for v, o in zip(vertex, offset)) for vertex in part.vertices])


def turned(part, matrix):
    """By a rotation (mathutils.Matrix, 3 by 3)."""
    from mathutils import Vector

    return part._replace(vertices=[tuple(matrix @ Vector(vertex)) for vertex in part.vertices])
