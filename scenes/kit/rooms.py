"""clutter, thin, facing, curved: rooms with many things in them."""

import math

from .colours import INK, PALETTE, PAPER, SLATE, STONE
from .gltf import Gltf, pitch, roll, yaw
from .png import palette_png, rgb_png
from .shapes import box, cylinder, quad, sphere


def paint(scene):
    """One matt material for each colour of the palette."""
    names = ["orange", "sky", "green", "yellow", "blue", "red", "pink"]
    return [scene.material(name, colour) for name, colour in zip(names, PALETTE)]


def ground(scene, material, half_width, near, far, repeat=(1, 1)):
    scene.add("floor", quad((-half_width, 0, near), (half_width, 0, near), (half_width, 0, far), (-half_width, 0, far),
                            repeat), material)


def back_wall(scene, half_width, height, z, colour=PAPER, band=SLATE):
    """A wall with a darker band at its foot."""
    scene.add("wall foot", quad((-half_width, 0, z), (half_width, 0, z), (half_width, 1, z), (-half_width, 1, z)),
              scene.material("wall foot", band))
    scene.add("wall", quad((-half_width, 1, z), (half_width, 1, z), (half_width, height, z), (-half_width, height, z)),
              scene.material("wall", colour))


def chequered_floor(scene, half_width, near, far, light=PAPER, dark=STONE):
    """Squares of one metre."""
    board = scene.texture(palette_png(32, 32, [light, dark], lambda x, y: (x // 16 + y // 16) % 2))
    ground(scene, scene.material("floor", texture=board), half_width, near, far, (half_width, (near - far) / 2))


def clutter():
    """14 boxes and 10 spheres on a mirror floor before a wall."""
    scene = Gltf("clutter")
    scene.camera("front", math.radians(60), 0.1, 60, (0, 2.4, 5.6), pitch(-12))
    ground(scene, scene.mirror("floor mirror"), 14, 7, -6)
    back_wall(scene, 14, 7, -6)
    colours = paint(scene)
    cube, ball = box(), sphere()
    # x, z, width, height, depth, turn, colour
    boxes = [
        (-4.2, -3.6, 1.2, 2.6, 1.2, 12, 4), (-2.4, -4.4, 0.9, 1.5, 0.9, -20, 1), (-0.6, -4.7, 1.1, 3.2, 1.0, 5, 0),
        (1.5, -4.3, 1.4, 1.1, 1.0, 24, 2), (3.4, -4.0, 1.0, 2.1, 1.0, -14, 5), (5.6, -4.6, 1.3, 3.0, 1.3, 30, 4),
        (-6.4, -4.4, 1.5, 1.7, 1.2, -8, 3), (-3.2, -1.2, 0.8, 0.8, 0.8, 35, 0), (2.9, -1.4, 0.9, 1.3, 0.9, -28, 6),
        (-1.1, -1.9, 0.7, 1.0, 0.7, 15, 5), (4.7, -1.7, 0.7, 0.7, 0.7, 10, 1), (-5.2, -1.5, 0.8, 1.4, 0.8, -30, 2),
        (0.9, 0.5, 0.6, 0.6, 0.6, 40, 4), (-1.9, 1.3, 0.5, 0.9, 0.5, -15, 3),
    ]
    for number, (x, z, width, height, depth, turn, colour) in enumerate(boxes):
        scene.add(f"box {number}", cube, colours[colour], (x, height / 2, z), yaw(turn), (width, height, depth))
    # x, y of the foot, z, radius, colour
    balls = [
        (0.5, 0, -2.8, 0.75, 1), (-2.0, 0, -0.2, 0.45, 6), (2.0, 0, 0.3, 0.5, 0), (-3.9, 0, 0.4, 0.6, 2),
        (3.7, 0, 0.4, 0.55, 3), (-0.5, 0, 1.6, 0.3, 5), (1.5, 1.1, -4.3, 0.5, 5), (-2.4, 1.5, -4.4, 0.4, 3),
        (6.6, 0, -2.4, 0.8, 2), (-7.0, 0, -2.2, 0.7, 0),
    ]
    for number, (x, foot, z, radius, colour) in enumerate(balls):
        scene.add(f"sphere {number}", ball, colours[colour], (x, foot + radius, z), None, (radius,) * 3)
    scene.sun(48, 32)
    return scene


def thin():
    """Poles, a fence, wires: things about as wide as a texel, where tracers leak."""
    scene = Gltf("thin")
    scene.camera("front", math.radians(60), 0.1, 60, (0, 1.7, 4.5), pitch(-8))
    ground(scene, scene.mirror("floor mirror"), 13, 6, -6)
    back_wall(scene, 13, 6.5, -6)
    dark = scene.material("ink", INK)
    colours = paint(scene)
    cube, pole = box(), cylinder(12)
    for number in range(9):
        radius = 0.012 * 1.4 ** number
        scene.add(f"pole {number}", pole, colours[number % 7], (-4.4 + 1.1 * number, 0, -2.6), None, (radius, 2.6, radius))
    for number in range(25):
        scene.add(f"picket {number}", cube, dark, (-3.6 + 0.3 * number, 0.45, -0.9), None, (0.03, 0.9, 0.02))
    for number, height in enumerate((0.25, 0.7)):
        scene.add(f"rail {number}", cube, dark, (0, height, -0.91), None, (7.4, 0.04, 0.015))
    # A texel is 0.017 m wide here at 640x360.
    for number, angle in enumerate((12, 27, 45, 63, 78)):
        scene.add(f"wire {number}", cube, colours[(number + 3) % 7], (-3.2 + 1.6 * number, 1.2, -0.2), roll(angle),
                  (2.2, 0.017, 0.004))
    for number in range(7):
        turn = roll(45 if number % 2 else -45)
        scene.add(f"lattice {number}", cube, colours[4], (1.2 + 0.35 * number, 1.4, -4.6), turn, (2.4, 0.035, 0.01))
    scene.add("post", cube, colours[5], (-2.6, 0.55, 1.2), yaw(20), (0.05, 1.1, 0.05))
    scene.sun(42, 28)
    return scene


def framed_mirror(scene, name, mirror, frame, at, turn, width, height):
    """A flat mirror in a frame of four bars; `at` is the middle of its foot and it faces +z turned by `turn`."""
    half = width / 2
    panel = quad((-half, 0, 0), (half, 0, 0), (half, height, 0), (-half, height, 0))
    scene.add(name, panel, mirror, at, yaw(turn))
    angle = math.radians(turn)
    bars = [(-half - 0.04, height / 2, 0.08, height + 0.16), (half + 0.04, height / 2, 0.08, height + 0.16),
            (0, height + 0.04, width, 0.08), (0, -0.04, width, 0.08)]
    for number, (x, y, bar_width, bar_height) in enumerate(bars):
        place = (round(at[0] + x * math.cos(angle), 6), round(at[1] + y, 6), round(at[2] - x * math.sin(angle), 6))
        scene.add(f"{name} frame {number}", frame[1], frame[0], place, yaw(turn), (bar_width, bar_height, 0.08))


def facing():
    """Mirrors that look at the camera: their rays come back towards it."""
    scene = Gltf("facing")
    scene.camera("front", math.radians(60), 0.1, 60, (0, 1.6, 4.2), pitch(-6))
    chequered_floor(scene, 14, 6, -8)
    back_wall(scene, 14, 7, -8)
    colours = paint(scene)
    mirror = scene.mirror("mirror")
    cube, ball = box(), sphere()
    frame = (scene.material("frame", INK), cube)
    framed_mirror(scene, "mirror ahead", mirror, frame, (0, 0.2, -4), 0, 3, 2.4)
    framed_mirror(scene, "mirror left", mirror, frame, (-3.4, 0.2, -3), 25, 2.4, 2.4)
    framed_mirror(scene, "mirror right", mirror, frame, (3.4, 0.2, -3), -25, 2.4, 2.4)
    framed_mirror(scene, "mirror near", mirror, frame, (1.55, 0.9, 2.3), -68, 0.9, 1.1)
    for number, (x, z, width, height, colour) in enumerate([
        (-1.5, -2.1, 0.6, 0.9, 0), (0.9, -2.6, 0.5, 1.3, 4), (-3.0, -0.6, 0.7, 0.7, 2), (2.6, -1.1, 0.6, 1.1, 5),
        (-0.4, -0.4, 0.4, 0.4, 3), (-2.0, 1.0, 0.4, 0.8, 1),
    ]):
        scene.add(f"box {number}", cube, colours[colour], (x, height / 2, z), yaw(17 * number), (width, height, width))
    for number, (x, z, radius, colour) in enumerate([(0.2, -1.7, 0.4, 6), (-0.9, 0.6, 0.25, 5), (1.6, -0.2, 0.35, 1)]):
        scene.add(f"sphere {number}", ball, colours[colour], (x, radius, z), None, (radius,) * 3)
    scene.sun(52, 70)
    return scene


def ripple_png(size):
    """Tangent-space normals of three waves that meet themselves at the edges."""
    waves = [(3, 1, 0.16), (-2, 4, 0.10), (5, -3, 0.06)]

    def pixel(x, y):
        slope_u = slope_v = 0.0
        for a, b, strength in waves:
            wave = strength * math.cos(2 * math.pi * (a * (x + 0.5) + b * (y + 0.5)) / size)
            slope_u += wave * a / 5
            slope_v += wave * b / 5
        length = math.sqrt(slope_u**2 + slope_v**2 + 1)
        # Green points up in the image, against y.
        return tuple(round(127.5 + 127.5 * value / length) for value in (-slope_u, slope_v, 1.0))

    return rgb_png(size, size, pixel)


def curved():
    """Mirror spheres and a rippled mirror: neighbouring rays part."""
    scene = Gltf("curved")
    scene.camera("front", math.radians(55), 0.1, 60, (0, 1.8, 5.2), pitch(-11))
    chequered_floor(scene, 14, 6, -6)
    back_wall(scene, 14, 7, -6)
    colours = paint(scene)
    ball, cube = sphere(), box()
    mirror = scene.mirror("sphere mirror")
    for number, (x, z, radius) in enumerate([(-1.7, -1.0, 0.9), (0.5, -2.2, 1.2), (1.3, 0.9, 0.45), (-0.5, 1.3, 0.3)]):
        scene.add(f"mirror sphere {number}", ball, mirror, (x, radius, z), None, (radius,) * 3)
    ripples = scene.texture(ripple_png(128))
    panel = quad((-1.3, 0, 0), (1.3, 0, 0), (1.3, 2.2, 0), (-1.3, 2.2, 0))
    scene.add("rippled panel", panel, scene.mirror("rippled mirror", normal=ripples), (3.1, 0.1, -2.2), yaw(-30))
    for number, (x, z, size, height, colour) in enumerate([
        (-3.6, -0.4, 0.8, 1.5, 5), (-3.0, 1.4, 0.5, 0.5, 0), (-0.4, -0.2, 0.4, 0.7, 3), (2.4, -0.4, 0.6, 1.0, 4),
        (3.4, 0.8, 0.6, 0.6, 2), (-4.6, -3.4, 1.2, 2.4, 1), (0.3, 2.4, 0.25, 0.25, 6),
    ]):
        scene.add(f"box {number}", cube, colours[colour], (x, height / 2, z), yaw(23 * number), (size, height, size))
    scene.sun(46, 35)
    return scene
