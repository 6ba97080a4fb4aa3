"""gloss: surfaces of growing roughness side by side."""

import math

from .colours import GREEN, INK, ORANGE, PAPER, RED, SILVER, SLATE, STONE, YELLOW
from .gltf import Gltf, pitch, yaw
from .png import palette_png
from .shapes import box, cylinder, quad, sphere

LANE_WIDTH = 1.5
ROUGHNESSES = [0, 0.1, 0.2, 0.3, 0.45, 0.7]


def lanes(scene):
    """A floor of metal strips that run away from the camera, from a mirror on the left to matt on the right."""
    half = len(ROUGHNESSES) * LANE_WIDTH / 2
    for number, roughness in enumerate(ROUGHNESSES):
        metal = scene.material(f"floor {roughness}", SILVER, metallic=1, roughness=roughness, traced=True)
        left, right = number * LANE_WIDTH - half, (number + 1) * LANE_WIDTH - half
        scene.add(f"lane {roughness}", quad((left, 0, 6), (right, 0, 6), (right, 0, -5), (left, 0, -5)), metal)
        yield (left + right) / 2


def gloss():
    """The same things on six floors, each rougher than the one before."""
    scene = Gltf("gloss")
    scene.camera("front", math.radians(48), 0.1, 60, (0, 1.5, 5.4), pitch(-2.5))
    middles = list(lanes(scene))
    ground = scene.material("ground", STONE)
    for side in (-1, 1):
        edge, far = side * len(ROUGHNESSES) * LANE_WIDTH / 2, side * 14
        left, right = min(edge, far), max(edge, far)
        scene.add("ground", quad((left, 0, 6), (right, 0, 6), (right, 0, -5), (left, 0, -5)), ground)
    board = scene.texture(palette_png(32, 32, [PAPER, SLATE], lambda x, y: (x // 16 + y // 16) % 2))
    wall = quad((-14, 0, -5), (14, 0, -5), (14, 6, -5), (-14, 6, -5), (14, 3))
    scene.add("wall", wall, scene.material("wall", texture=board))
    cube, pole, ball = box(), cylinder(), sphere()
    post, tile, matt = scene.material("post", ORANGE), scene.material("tile", RED), scene.material("ball", GREEN)
    lamp = scene.material("lamp", INK, emissive=YELLOW)
    copper = scene.material("sphere copper", (226, 150, 112), metallic=1, roughness=0.25, traced=True)
    for middle in middles:
        # A post of one width from its foot up: how its reflection widens is the surface's doing alone.
        scene.add("post", pole, post, (middle - 0.45, 0, -1.4), None, (0.07, 1.5, 0.07))
        scene.add("tile", cube, tile, (middle + 0.15, 0.4, -2.6), yaw(20), (0.5, 0.8, 0.3))
        scene.add("ball", ball, matt, (middle + 0.3, 0.22, -0.6), None, (0.22,) * 3)
        scene.add("lamp", ball, lamp, (middle - 0.1, 1.25, -3.4), None, (0.12,) * 3)
        scene.add("copper ball", ball, copper, (middle - 0.05, 0.17, 0.1), None, (0.17,) * 3)
    scene.sun(48, 32)
    return scene
