"""moving: what needs more than one frame. Everything starts at 0 s and stands still again at 4 s."""

import math

from .colours import BLUE, PAPER, SLATE, STONE
from .gltf import Gltf, pitch, yaw
from .png import palette_png
from .rooms import ground, paint
from .shapes import box, quad, sphere


def moving():
    """A camera that walks past a turning, sliding box and a bouncing ball on a mirror floor before a chequered wall."""
    scene = Gltf("moving")
    scene.camera("walking", math.radians(60), 0.1, 60, (-1.2, 1.5, 4.2), pitch(-9))
    scene.animate("translation", [0, 4], [(-1.2, 1.5, 4.2), (1.2, 1.5, 4.2)])
    ground(scene, scene.mirror("floor mirror"), 12, 6, -4)
    board = scene.texture(palette_png(32, 32, [PAPER, STONE], lambda x, y: (x // 16 + y // 16) % 2))
    scene.add("wall", quad((-12, 0, -4), (12, 0, -4), (12, 6, -4), (-12, 6, -4), (12, 3)),
              scene.material("wall", texture=board))
    colours = paint(scene)
    cube, ball = box(), sphere()
    sides = scene.texture(palette_png(32, 32, [BLUE, PAPER, SLATE],
                                      lambda x, y: 2 if min(x, y, 31 - x, 31 - y) < 3 else (x // 8 + y // 8) % 2))
    scene.add("box", cube, scene.material("box", texture=sides), (-1.6, 0.55, -0.8), None, (1.1, 1.1, 1.1))
    scene.animate("translation", [0, 4], [(-1.6, 0.55, -0.8), (1.6, 0.55, -0.8)])
    scene.animate("rotation", [0, 1, 2, 3, 4], [yaw(90 * quarter) for quarter in range(5)])
    scene.add("ball", ball, colours[0], (2.3, 0.35, -1.6), None, (0.35,) * 3)
    # A second up and down again, like a parabola: fast at the floor, at rest at the top.
    low, high, speed = (2.3, 0.35, -1.6), (2.3, 1.55, -1.6), 4.8
    keys = []
    for half in range(9):
        at_floor = half % 2 == 0
        keys += [(0, -speed if at_floor and half > 0 else 0, 0), low if at_floor else high,
                 (0, speed if at_floor and half < 8 else 0, 0)]
    scene.animate("translation", [half / 2 for half in range(9)], keys, "CUBICSPLINE")
    scene.add("post", cube, colours[5], (-2.9, 0.8, -2.4), yaw(20), (0.4, 1.6, 0.4))
    scene.add("low block", cube, colours[2], (0.7, 0.25, 0.9), yaw(-25), (0.6, 0.5, 0.6))
    scene.sun(46, 30)
    return scene
