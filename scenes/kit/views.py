"""corridor and outdoor: long views."""

import math

from .colours import BLUE, INK, PAPER, RED, STONE
from .gltf import Gltf, pitch, roll, yaw
from .rooms import paint
from .shapes import box, cylinder, height_field, quad, sphere


def corridor():
    """A hall of 40 m, open to the sky, with a mirror floor and a mirror along the left wall: long grazing rays."""
    scene = Gltf("corridor")
    scene.camera("front", math.radians(60), 0.1, 80, (0.1, 1.6, 0), pitch(-4))
    near, far, side, height = 2, -40, 2.5, 3.6
    scene.add("floor", quad((-side, 0, near), (side, 0, near), (side, 0, far), (-side, 0, far)), scene.mirror("floor mirror"))
    wall = scene.material("wall", PAPER)
    scene.add("right wall", quad((side, 0, far), (side, 0, near), (side, height, near), (side, height, far)), wall)
    # The left wall has a gap that the mirror fills.
    mirror_near, mirror_far, low, high = -7, -25, 0.8, 2.6
    for name, z_near, z_far, y_low, y_high in [
        ("left wall near", near, mirror_near, 0, height), ("left wall far", mirror_far, far, 0, height),
        ("left wall below", mirror_near, mirror_far, 0, low), ("left wall above", mirror_near, mirror_far, high, height),
    ]:
        scene.add(name, quad((-side, y_low, z_near), (-side, y_low, z_far), (-side, y_high, z_far), (-side, y_high, z_near)), wall)
    scene.add("left mirror", quad((-side, low, mirror_near), (-side, low, mirror_far), (-side, high, mirror_far),
                                  (-side, high, mirror_near)), scene.mirror("wall mirror"))
    scene.add("end", quad((-side, 0, far), (side, 0, far), (side, height, far), (-side, height, far)),
              scene.material("end", BLUE))
    colours = paint(scene)
    cube, column = box(), cylinder(20)
    stone = scene.material("column", STONE)
    lamp = scene.material("lamp", PAPER, emissive=(255, 244, 214))
    for number in range(9):
        z = -3 - 4 * number
        scene.add(f"column {number}", column, stone, (2.05, 0, z), None, (0.22, height, 0.22))
        scene.add(f"panel {number}", cube, colours[number % 7], (side - 0.03, 1.7, z - 2), None, (0.06, 1.5, 1.5))
        scene.add(f"beam {number}", cube, stone, (0, height - 0.15, z - 2), None, (2 * side, 0.3, 0.3))
        scene.add(f"lamp {number}", cube, lamp, (0, height - 0.33, z - 2), None, (1.6, 0.06, 0.24))
    for number, (x, z, size, tall, colour) in enumerate([
        (-1.5, -5, 0.5, 0.9, 0), (-0.9, -11, 0.5, 1.4, 5), (1.0, -16, 0.6, 0.6, 3), (-1.3, -21, 0.6, 1.6, 2), (0.6, -30, 0.7, 1.8, 6),
    ]):
        scene.add(f"box {number}", cube, colours[colour], (x, tall / 2, z), yaw(19 * number), (size, tall, size))
    scene.sun(38, 20, intensity=2.6)
    return scene


def hills(left, right, near, far, height, waves):
    """A range of hills: a ridge across the view whose height follows a sum of waves, with its foot under the water."""

    def place(s, t):
        x = left + (right - left) * s
        ridge = 0.55 + sum(strength * math.sin(count * 2 * math.pi * s + phase) for count, phase, strength in waves)
        profile = math.sin(math.pi * min(max(t, 0), 1) / 2)
        return (x, -2 + height * max(ridge, 0.05) * profile, near + (far - near) * t)

    return height_field(64, 8, place)


def outdoor():
    """A lake from half a metre before the camera to hills two kilometres away, under the sky."""
    scene = Gltf("outdoor")
    scene.camera("front", math.radians(50), 0.1, 5000, (0, 1.1, 0), pitch(-3))
    scene.add("water", quad((-3000, 0, 20), (3000, 0, 20), (3000, 0, -2200), (-3000, 0, -2200)), scene.mirror("water"))
    for name, colour, shape in [
        ("far hills", (122, 150, 172), hills(-2600, 2600, -1500, -2100, 420, [(2, 0.5, 0.25), (5, 2.0, 0.12), (11, 1.0, 0.05)])),
        ("middle hills", (88, 128, 112), hills(-1400, 700, -650, -900, 130, [(1.5, 2.2, 0.3), (4, 0.3, 0.12), (9, 1.7, 0.05)])),
        ("near hills", (70, 110, 62), hills(60, 520, -180, -300, 46, [(1, 4.5, 0.3), (3, 0.9, 0.15), (8, 2.9, 0.05)])),
    ]:
        scene.add(name, shape, scene.material(name, colour))
    colours = paint(scene)
    cube, column, ball = box(), cylinder(12), sphere(32, 16)
    wood = scene.material("wood", (140, 106, 74))
    roof = scene.material("roof", RED)
    ink = scene.material("ink", INK)
    scene.add("reed", column, colours[2], (-0.33, -0.2, -0.75), roll(-4), (0.006, 1.45, 0.006))
    scene.add("reed behind", column, colours[2], (-0.42, -0.2, -0.95), roll(7), (0.006, 1.3, 0.006))
    for number in range(6):
        scene.add(f"jetty post {number}", column, wood, (1.6 + 0.9 * number, -0.5, -4.5 - 1.2 * number), None, (0.09, 1.3, 0.09))
    scene.add("buoy", ball, colours[5], (-1.5, 0.12, -5), None, (0.32, 0.32, 0.32))
    scene.add("far buoy", ball, colours[3], (-3.4, 0.15, -14), None, (0.45, 0.45, 0.45))
    for number, (x, z, size) in enumerate([(-16, -60, 5), (-27, -66, 6.5), (9, -85, 6)]):
        scene.add(f"house {number}", cube, colours[(0, 4, 6)[number]], (x, size * 0.35, z), yaw(25 * number - 20), (size * 1.4, size * 0.9, size))
        scene.add(f"roof {number}", cube, roof, (x, size * 0.85, z), yaw(25 * number - 20), (size * 1.5, size * 0.12, size * 1.1))
    for number in range(8):
        scene.add(f"mast {number}", column, ink, (-70 + 26 * number, -1, -120 - 22 * number), None, (0.35, 17, 0.35))
    scene.sun(40, 35)
    return scene
