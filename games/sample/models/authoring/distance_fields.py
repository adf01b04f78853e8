"""Shapes as signed distances over arrays of points (numpy, shape (..., 3)), and the surface where they are zero."""

import numpy as np


def capsule(points, start, end, start_radius, end_radius):
    """A rod between two points whose radius changes along it; near enough to a distance."""
    start, end = np.array(start), np.array(end)
    axis = end - start
    share = np.clip((points - start) @ axis / (axis @ axis), 0.0, 1.0)
    nearest = start + share[..., None] * axis
    return np.linalg.norm(points - nearest, axis=-1) - (start_radius + share * (end_radius - start_radius))


def ellipsoid(points, center, radii):
    """Source: Quilez, "Distance functions", 2008: the bound by two lengths."""
    offset, radii = points - np.array(center), np.array(radii)
    near = np.linalg.norm(offset / radii, axis=-1)
    steep = np.linalg.norm(offset / radii**2, axis=-1)
    return near * (near - 1.0) / np.maximum(steep, 1e-9)


def rounded_box(points, center, half, rounding):
    outside = np.abs(points - np.array(center)) - (np.array(half) - rounding)
    away = np.linalg.norm(np.maximum(outside, 0.0), axis=-1)
    return away + np.minimum(outside.max(axis=-1), 0.0) - rounding


def ring(points, center, axis, major, minor):
    """A torus round an axis of unit length."""
    offset, axis = points - np.array(center), np.array(axis)
    along = offset @ axis
    across = np.linalg.norm(offset - along[..., None] * axis, axis=-1)
    return np.hypot(across - major, along) - minor


def blend(first, second, width):
    """The union with a fillet. Source: Quilez, "Smooth minimum", 2013, the polynomial of degree two."""
    near = np.maximum(width - np.abs(first - second), 0.0) / width
    return np.minimum(first, second) - near * near * width * 0.25


def grid_points(low, high, step):
    counts = np.ceil((np.array(high) - np.array(low)) / step).astype(int) + 1
    axes = [low[i] + step * np.arange(counts[i]) for i in range(3)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)


def surface_nets(field, low, high, step):
    """Vertices and quads of the zero surface: one vertex in each cell that it crosses.

    Source: Gibson, "Constrained Elastic Surface Nets", 1998.
    """
    points = grid_points(low, high, step)
    inside = field(points) < 0.0
    cells = tuple(n - 1 for n in inside.shape)
    filled = sum(
        inside[x : x + cells[0], y : y + cells[1], z : z + cells[2]].astype(int)
        for x in (0, 1) for y in (0, 1) for z in (0, 1)
    )
    crossed = (filled > 0) & (filled < 8)
    number = np.full(cells, -1)
    number[crossed] = np.arange(crossed.sum())
    vertices = points[:-1, :-1, :-1][crossed] + 0.5 * step
    quads = [_quads_across(inside, number, axis) for axis in range(3)]
    return vertices, np.concatenate(quads)


def _quads_across(inside, number, axis):
    """One quad round each grid edge along `axis` that goes in or out."""
    inside, number = (np.moveaxis(a, (axis, (axis + 1) % 3, (axis + 2) % 3), (0, 1, 2)) for a in (inside, number))
    changes = inside[:-1, 1:-1, 1:-1] != inside[1:, 1:-1, 1:-1]
    a, b, c = np.nonzero(changes)
    b, c = b + 1, c + 1
    quads = np.stack([number[a, b - 1, c - 1], number[a, b, c - 1], number[a, b, c], number[a, b - 1, c]], axis=-1)
    leaves = inside[a, b, c]
    return np.where(leaves[:, None], quads, quads[:, ::-1])


def gradient(field, points, reach):
    slopes = [
        (field(points + reach * unit) - field(points - reach * unit)) / (2.0 * reach) for unit in np.eye(3)
    ]
    return np.stack(slopes, axis=-1)


def on_surface(field, points, step):
    """Points moved down the field to where it is zero, by Newton's rule with short steps."""
    for _ in range(4):
        slope = gradient(field, points, 0.1 * step)
        move = field(points) / np.maximum((slope * slope).sum(axis=-1), 0.05)
        points = points - np.clip(move, -0.5 * step, 0.5 * step)[:, None] * slope
    return points


def evened(vertices, quads):
    """Each vertex in the middle of its neighbours."""
    sums, counts = np.zeros_like(vertices), np.zeros(len(vertices))
    for corner in range(4):
        for neighbour in (corner - 1, (corner + 1) % 4):
            np.add.at(sums, quads[:, corner], vertices[quads[:, neighbour]])
            np.add.at(counts, quads[:, corner], 1.0)
    return sums / counts[:, None]


def triangles(vertices, quads):
    """Each quad cut along its shorter diagonal."""
    def length(a, b):
        return np.linalg.norm(vertices[quads[:, a]] - vertices[quads[:, b]], axis=-1)

    turned = np.where((length(0, 2) <= length(1, 3))[:, None], quads, np.roll(quads, -1, axis=1))
    return np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]])
