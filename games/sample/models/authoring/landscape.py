"""What lies round the court: a cypress, and hills on the horizon."""

import math

from authoring.blender_files import make_material, make_object
from authoring.parts import Part, revolve


def build_cypress():
    """6 m high. Its leaves are one closed surface with lumps that wind upwards."""
    rings, segments = 26, 28
    profile = [(0.0, 0.55)]
    for i in range(1, rings):
        share = i / rings
        profile.append((0.74 * math.sin(math.pi * share**0.62) ** 0.8 * (1.0 - 0.35 * share), 0.55 + 5.45 * share))
    profile.append((0.0, 6.0))
    crown = revolve(profile, segments, 0)
    lumpy = []
    for x, y, z in crown.vertices:
        angle = math.atan2(y, x)
        lump = 1.0 + 0.1 * math.sin(5.0 * angle + 3.1 * z) + 0.07 * math.sin(9.0 * angle - 5.3 * z + 1.0)
        lumpy.append((x * lump, y * lump, z + 0.05 * math.sin(7.0 * angle + 2.0 * z)))
    trunk = [(0.0, -0.1), (0.17, -0.1), (0.12, 0.2), (0.1, 1.2), (0.0, 1.25)]
    materials = [make_material("cypress", "#41613a", 0.95), make_material("bark", "#5d4a38", 0.95)]
    make_object("cypress", [crown._replace(vertices=lumpy), revolve(trunk, 12, 1)], materials, 60.0)


def ridge(angle, share):
    """Height of the land, share 0 at its inner edge to 1 at its outer edge."""
    waves = (
        0.5 + 0.28 * math.sin(3.0 * angle + 0.4) + 0.2 * math.sin(7.0 * angle + 2.0)
        + 0.12 * math.sin(13.0 * angle + 5.0 * share) + 0.06 * math.sin(29.0 * angle + 9.0 * share)
    )
    return 44.0 * max(waves, 0.08) * math.sin(math.pi * share) ** 1.3


def build_hills():
    """A ring of land from 90 to 380 m away, closed from below, a little deeper than the plain."""
    segments, rings, low = 144, 12, -3.0
    vertices = []
    for ring in range(rings + 1):
        share = ring / rings
        for i in range(segments):
            angle = math.tau * i / segments
            radius = 90.0 + 290.0 * share
            vertices.append((radius * math.cos(angle), radius * math.sin(angle), low + ridge(angle, share)))
    faces = []
    for i in range(segments):
        after = (i + 1) % segments
        for ring in range(rings):
            a, b = ring * segments, (ring + 1) * segments
            faces.append((a + i, b + i, b + after, a + after))
    floor = len(vertices)
    for radius in (90.0, 380.0):
        for i in range(segments):
            angle = math.tau * i / segments
            vertices.append((radius * math.cos(angle), radius * math.sin(angle), low - 4.0))
    inner, outer, last = floor, floor + segments, rings * segments
    for i in range(segments):
        after = (i + 1) % segments
        faces.append((inner + i, i, after, inner + after))
        faces.append((last + i, outer + i, outer + after, last + after))
        faces.append((outer + i, inner + i, inner + after, outer + after))
    make_object("hills", [Part(vertices, faces)], [make_material("hills", "#8d8f6a", 1.0)], 60.0)
