"""The fountain: a basin with a broad rim, water, a turned stem, a bowl, and a finial."""

from authoring.blender_files import make_material, make_object
from authoring.parts import revolve, scalloped

STONE, BRONZE, WATER = range(3)


def build():
    basin = [
        (0.0, 0.0), (1.95, 0.0), (1.95, 0.1), (1.86, 0.14), (1.86, 0.42), (1.95, 0.46), (2.0, 0.5), (2.0, 0.56),
        (1.95, 0.6), (1.7, 0.6), (1.66, 0.56), (1.66, 0.12), (0.0, 0.12),
    ]
    water = [(0.0, 0.1), (1.68, 0.1), (1.68, 0.44), (0.0, 0.44)]
    stem = [
        (0.0, 0.1), (0.42, 0.1), (0.42, 0.5), (0.3, 0.58), (0.17, 0.7), (0.13, 0.9), (0.17, 1.1), (0.21, 1.16),
        (0.14, 1.24), (0.16, 1.34), (0.0, 1.36),
    ]
    bowl = [
        (0.0, 1.3), (0.2, 1.3), (0.5, 1.38), (0.78, 1.52), (0.86, 1.64), (0.82, 1.66), (0.7, 1.58), (0.4, 1.48),
        (0.0, 1.46),
    ]
    finial = [
        (0.0, 1.4), (0.1, 1.42), (0.07, 1.6), (0.06, 1.75), (0.12, 1.82), (0.16, 1.92), (0.13, 2.02), (0.06, 2.1),
        (0.0, 2.24),
    ]
    parts = [
        revolve(basin, 64, STONE),
        revolve(water, 64, WATER),
        revolve(stem, 32, BRONZE),
        scalloped(revolve(bowl, 96, BRONZE), 16, 0.045),
        revolve(finial, 24, BRONZE),
    ]
    materials = [
        make_material("fountain_stone", "#cfc2a6", 0.9),
        make_material("fountain_bronze", "#7f7350", 0.5, 0.2),
        make_material("water", "#5f97a8", 0.2),
    ]
    make_object("fountain", parts, materials, 35.0)
