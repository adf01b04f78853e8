"""A sundial: a stone pedestal, a bronze plate with hour marks, and the gnomon, which points north.

North is +y here, -z in glTF.
"""

import math

from mathutils import Matrix

from authoring.blender_files import make_material, make_object
from authoring.parts import moved, prism, revolve, turned

STONE, BRONZE, DARK = range(3)
LATITUDE = math.radians(42.0)
PLATE_HEIGHT = 1.0


def pedestal():
    profile = [
        (0.0, 0.0), (0.36, 0.0), (0.36, 0.1), (0.3, 0.12), (0.3, 0.17), (0.24, 0.22), (0.17, 0.3), (0.145, 0.5),
        (0.15, 0.7), (0.18, 0.82), (0.25, 0.88), (0.25, 0.9), (0.32, 0.92), (0.32, 0.985), (0.3, 1.0), (0.0, 1.0),
    ]
    return revolve(profile, 48, STONE)


def plate():
    """Sunk a little into the stone, so that no two faces share a plane."""
    low, high = PLATE_HEIGHT - 0.01, PLATE_HEIGHT + 0.02
    profile = [(0.0, low), (0.27, low), (0.27, high - 0.005), (0.265, high), (0.0, high)]
    return revolve(profile, 48, BRONZE)


def hour_angle(hour):
    """Of the shadow's line on a level plate, from north towards east. Source: tan a = sin(latitude) tan(15 h)."""
    turn = math.radians(15.0 * (hour - 12))
    return math.atan2(math.sin(LATITUDE) * math.sin(turn), math.cos(turn))


def hour_mark(hour):
    long = hour % 3 == 0
    outline = [(-0.006, 0.19 if long else 0.21), (0.006, 0.19 if long else 0.21), (0.006, 0.25), (-0.006, 0.25)]
    mark = prism(outline, PLATE_HEIGHT + 0.01, PLATE_HEIGHT + 0.026, DARK)
    return turned(mark, Matrix.Rotation(-hour_angle(hour), 3, "Z"))


def gnomon():
    """A right triangle that rises northwards at the angle of the latitude; its foot is sunk into the plate."""
    south, north = -0.08, 0.17
    height = (north - south) * math.tan(LATITUDE)
    outline = [(south, 0.0), (north, 0.0), (north, height), (north - 0.02, height)]
    blade = prism(outline, -0.009, 0.009, DARK)
    upright = Matrix(((0, 0, 1), (1, 0, 0), (0, 1, 0)))  # x to y, y to z, z to x
    return moved(turned(blade, upright), (0.0, 0.0, PLATE_HEIGHT + 0.01))


def build():
    materials = [
        make_material("stone", "#cdbf9f", 0.9),
        make_material("bronze", "#a9793c", 0.45, 0.2),
        make_material("dark_bronze", "#5d4526", 0.5, 0.2),
    ]
    parts = [pedestal(), plate(), gnomon(), *(hour_mark(hour) for hour in range(6, 19))]
    make_object("sundial", parts, materials, 35.0)
