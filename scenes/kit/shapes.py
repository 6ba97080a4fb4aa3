"""Shapes as plain arrays: counter-clockwise is outside, texture v grows downwards as in glTF."""

import math


class Shape:
    def __init__(self):
        self.positions = []
        self.normals = []
        self.uvs = []
        self.indices = []

    def add(self, positions, normals, uvs, indices):
        first = len(self.positions)
        self.positions += positions
        self.normals += normals
        self.uvs += uvs
        self.indices += [first + index for index in indices]
        return self


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def _minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def quad(lower_left, lower_right, upper_right, upper_left, repeat=(1, 1)):
    """A flat quad as seen from its outside."""
    normal = _unit(_cross(_minus(lower_right, lower_left), _minus(upper_left, lower_left)))
    u, v = repeat
    corners = [lower_left, lower_right, upper_right, upper_left]
    return Shape().add(corners, [normal] * 4, [(0, v), (u, v), (u, 0), (0, 0)], [0, 1, 2, 0, 2, 3])


def box():
    """The unit cube around the origin, without smoothing; each face shows the whole texture."""
    shape = Shape()
    for axis in range(3):
        for sign in (-1, 1):
            normal = tuple(sign if i == axis else 0 for i in range(3))
            right = (0, 0, -sign) if axis == 0 else (sign, 0, 0) if axis == 2 else (1, 0, 0)
            up = _cross(normal, right)
            corners = [
                tuple(0.5 * (normal[i] + a * right[i] + b * up[i]) for i in range(3))
                for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            ]
            shape.add(corners, [normal] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)], [0, 1, 2, 0, 2, 3])
    return shape


def sphere(around=48, down=24):
    """Radius 1, smooth, the poles on y."""
    shape = Shape()
    points = []
    uvs = []
    for j in range(down + 1):
        polar = math.pi * j / down
        for i in range(around + 1):
            turn = 2 * math.pi * (i % around) / around
            points.append((math.sin(polar) * math.cos(turn), math.cos(polar), -math.sin(polar) * math.sin(turn)))
            uvs.append((i / around, j / down))
    indices = []
    for j in range(down):
        for i in range(around):
            a = j * (around + 1) + i
            b = a + around + 1
            if j > 0:
                indices += [a, b + 1, a + 1]
            if j + 1 < down:
                indices += [a, b, b + 1]
    return shape.add(points, points, uvs, indices)


def cylinder(around=16):
    """Radius 1, from y = 0 to y = 1, smooth side, a flat top and no bottom."""
    shape = Shape()
    ring = [(math.cos(2 * math.pi * (i % around) / around), -math.sin(2 * math.pi * (i % around) / around))
            for i in range(around + 1)]
    side = [(x, y, z) for y in (0, 1) for x, z in ring]
    indices = []
    for i in range(around):
        indices += [i, i + 1, i + around + 2, i, i + around + 2, i + around + 1]
    shape.add(side, [(x, 0, z) for x, _, z in side],
              [(i / around, 1 - y) for y in (0, 1) for i in range(around + 1)], indices)
    top = [(x, 1, z) for x, z in ring[:-1]]
    fan = [index for i in range(1, around - 1) for index in (0, i, i + 1)]
    return shape.add(top, [(0, 1, 0)] * around, [(0.5 + 0.5 * x, 0.5 + 0.5 * z) for x, _, z in top], fan)


def height_field(columns, rows, place):
    """A smooth sheet: place(s, t) -> point for s, t in 0..1; s grows to the right and t away from its outside's
    foot, so that the outside is where right x away points."""
    shape = Shape()
    step = 1e-4
    points = []
    normals = []
    uvs = []
    for j in range(rows + 1):
        for i in range(columns + 1):
            s, t = i / columns, j / rows
            along_s = _minus(place(s + step, t), place(s - step, t))
            along_t = _minus(place(s, t + step), place(s, t - step))
            points.append(place(s, t))
            normals.append(_unit(_cross(along_s, along_t)))
            uvs.append((s, 1 - t))
    indices = []
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b = a + columns + 1
            indices += [a, a + 1, b + 1, a, b + 1, b]
    return shape.add(points, normals, uvs, indices)
