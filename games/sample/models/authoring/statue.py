"""The hero of the court's shadows: a robed figure, a hand on the hip, that lifts a ring over its head."""

import numpy as np

from authoring import distance_fields as fields
from authoring.blender_files import make_material, make_object
from authoring.parts import Part

STEP = 0.016
ROBE_FOOT, WAIST = 0.12, 1.02
RING_AXIS = np.array((0.35, -1.0, 0.15)) / np.linalg.norm((0.35, -1.0, 0.15))


def robe(points):
    """A skirt that narrows to the waist; its folds wind upwards and fade, and it sways to one side."""
    height = points[..., 2]
    share = np.clip((height - ROBE_FOOT) / (WAIST - ROBE_FOOT), 0.0, 1.0)
    x = points[..., 0] - 0.05 * np.sin(np.pi * share)
    y = points[..., 1] - 0.02 * np.sin(np.pi * share)
    angle = np.arctan2(y, x)
    folds = np.cos(9.0 * angle + 3.5 * share) + 0.5 * np.cos(5.0 * angle - 2.0 * share + 1.0)
    radius = 0.125 + 0.135 * (1.0 - share) ** 1.6 + 0.05 * np.sin(np.pi * share) ** 2
    radius = radius + 0.016 * (1.0 - share) ** 0.8 * folds
    side = 0.75 * (np.hypot(x, y / 0.9) - radius)
    ends = np.maximum(ROBE_FOOT - height, height - WAIST - 0.02)
    return np.maximum(side, ends)


def trunk(points):
    body = fields.blend(robe(points), fields.ellipsoid(points, (0.0, 0.0, 1.04), (0.132, 0.108, 0.17)), 0.12)
    body = fields.blend(body, fields.ellipsoid(points, (-0.01, -0.01, 1.27), (0.165, 0.115, 0.2)), 0.1)
    shoulders = fields.capsule(points, (-0.15, 0.0, 1.39), (0.15, 0.0, 1.42), 0.06, 0.06)
    body = fields.blend(body, shoulders, 0.08)
    neck = fields.capsule(points, (-0.01, 0.0, 1.42), (-0.015, -0.01, 1.56), 0.055, 0.047)
    body = fields.blend(body, neck, 0.06)
    head = fields.ellipsoid(points, (-0.02, -0.025, 1.655), (0.086, 0.1, 0.122))
    knot = fields.ellipsoid(points, (-0.015, 0.085, 1.7), (0.05, 0.05, 0.05))
    return fields.blend(body, fields.blend(head, knot, 0.03), 0.035)


def raised_arm(points):
    upper = fields.capsule(points, (0.17, 0.0, 1.42), (0.325, -0.03, 1.61), 0.055, 0.043)
    lower = fields.capsule(points, (0.325, -0.03, 1.61), (0.235, -0.06, 1.865), 0.043, 0.03)
    hand = fields.ellipsoid(points, (0.225, -0.062, 1.895), (0.038, 0.042, 0.05))
    return fields.blend(fields.blend(upper, lower, 0.03), hand, 0.03)


def lowered_arm(points):
    upper = fields.capsule(points, (-0.17, 0.0, 1.39), (-0.345, 0.05, 1.2), 0.055, 0.043)
    lower = fields.capsule(points, (-0.345, 0.05, 1.2), (-0.165, -0.04, 1.04), 0.043, 0.034)
    return fields.blend(upper, lower, 0.03)


def figure(points):
    plinth = fields.rounded_box(points, (0.0, 0.0, 0.07), (0.34, 0.34, 0.07), 0.025)
    body = fields.blend(plinth, trunk(points), 0.03)
    body = fields.blend(body, lowered_arm(points), 0.04)
    body = fields.blend(body, raised_arm(points), 0.05)
    halo = fields.ring(points, (0.11, -0.075, 2.0), RING_AXIS, 0.17, 0.026)
    return fields.blend(body, halo, 0.025)


def build():
    vertices, quads = fields.surface_nets(figure, (-0.5, -0.45, -0.06), (0.5, 0.45, 2.3), STEP)
    for _ in range(3):
        vertices = fields.on_surface(figure, fields.evened(vertices, quads), STEP)
    part = Part(vertices.tolist(), fields.triangles(vertices, quads).tolist())
    make_object("statue", [part], [make_material("marble", "#d9cdb8", 0.7)], 180.0)
