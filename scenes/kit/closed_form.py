"""m1 to m4: scenes of a few planes whose reflections have closed forms (docs/spaces.md).

All have the camera in the origin, unpitched, looking along -z, with f = 1 / tan(fov_y / 2) = 2, and a floor one metre
below it: h = 1. Every coordinate that a closed form uses is exact in 32 bits."""

import math

from .colours import BLUE, GREEN, ORANGE, PAPER, PINK, RED, SKY, SLATE, STONE, YELLOW
from .gltf import Gltf
from .png import palette_png
from .shapes import quad

FOV_Y = 2 * math.atan(0.5)
HALF_WIDTH = 12  # fills 21:9 with room to spare
CLAMP = 33071

# The letter F, 5 wide and 7 high: no mirror image and no turn of it looks like itself.
LETTER = ["#####", "#....", "#....", "####.", "#....", "#....", "#...."]


def chequer_png(columns, rows, texels, letter_at, letter_colour, background=(PAPER, STONE)):
    """A board of columns x rows squares with a coloured stripe in every fourth column and one letter F, whose lower
    left corner is on the square `letter_at` (counted from the lower left) and whose dots are half a square."""
    stripes = [ORANGE, SKY, GREEN, PINK, BLUE, YELLOW]
    palette = [*background, letter_colour, *stripes]
    dot = texels // 2
    left = letter_at[0] * texels
    top = (rows - letter_at[1]) * texels - dot * len(LETTER)

    def index(x, y):
        column, row = (x - left) // dot, (y - top) // dot
        if 0 <= column < 5 and 0 <= row < 7 and LETTER[row][column] == "#":
            return 2
        if (x // texels) % 4 == 3 and (y // texels) % 2 == 1:
            return 3 + (x // texels // 4) % len(stripes)
        return (x // texels + y // texels) % 2

    return palette_png(columns * texels, rows * texels, palette, index)


def start(name):
    scene = Gltf(name)
    scene.camera("front", FOV_Y, 0.1, 100)
    return scene


def floor(scene, material, z_near, z_far, repeat=(1, 1), half_width=HALF_WIDTH):
    scene.add("floor", quad((-half_width, -1, z_near), (half_width, -1, z_near), (half_width, -1, z_far),
                            (-half_width, -1, z_far), repeat), material)


def floor_and_wall(name):
    """A mirror floor that reaches a wall at D = 8: the wall's foot is on Y = -h f / D = -1/4."""
    scene = start(name)
    board = scene.texture(chequer_png(24, 8, 16, (13, 1), RED), CLAMP)
    floor(scene, scene.mirror("floor mirror"), 2, -8)
    scene.add("wall", quad((-HALF_WIDTH, -1, -8), (HALF_WIDTH, -1, -8), (HALF_WIDTH, 7, -8), (-HALF_WIDTH, 7, -8)),
              scene.material("wall", texture=board))
    scene.sun(35, 25)
    return scene


def m1():
    return floor_and_wall("m1")


def m2():
    """A mirror wall at D = 4 across the view: its rays come back towards the camera, to the floor."""
    scene = start("m2")
    board = scene.texture(chequer_png(24, 16, 16, (13, 9), RED, (PAPER, SLATE)), CLAMP)
    floor(scene, scene.material("floor", texture=board), 12, -4)
    scene.add("mirror wall", quad((-HALF_WIDTH, -1, -4), (HALF_WIDTH, -1, -4), (HALF_WIDTH, 3, -4), (-HALF_WIDTH, 3, -4)),
              scene.mirror("wall mirror"))
    scene.sun(55, 160)
    return scene


def m3():
    """m1 with a floating quad at D_q = 4, between the rows Y = -0.1 and Y = 0.3."""
    scene = floor_and_wall("m3")
    scene.add("floating quad", quad((-1, -0.2, -4), (1, -0.2, -4), (1, 0.6, -4), (-1, 0.6, -4)),
              scene.material("floating quad", BLUE, double_sided=True))
    return scene


def m4():
    """A mirror at 45 degrees in (0, 0, -4): rays along the view turn to +x and meet the side wall at x = 1."""
    scene = start("m4")
    floor(scene, scene.material("floor", PAPER), 2, -10)
    board = scene.texture(chequer_png(8, 4, 16, (3, 1), RED, (PAPER, SKY)), CLAMP)
    scene.add("side wall", quad((1, -1, -10), (1, -1, -2), (1, 3, -2), (1, 3, -10)), scene.material("side wall", texture=board))
    scene.add("slanted mirror", quad((-1, -1, -3), (0.75, -1, -4.75), (0.75, 1, -4.75), (-1, 1, -3)),
              scene.mirror("slanted mirror"))
    scene.add("back wall", quad((-HALF_WIDTH, -1, -10), (HALF_WIDTH, -1, -10), (HALF_WIDTH, 5, -10), (-HALF_WIDTH, 5, -10)),
              scene.material("back wall", SLATE))
    scene.sun(45, -40)
    return scene
