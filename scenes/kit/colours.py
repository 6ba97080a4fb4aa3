"""Colours that stay apart for every kind of colour vision (Okabe and Ito), as sRGB bytes and as linear factors."""

ORANGE = (230, 159, 0)
SKY = (86, 180, 233)
GREEN = (0, 158, 115)
YELLOW = (240, 228, 66)
BLUE = (0, 114, 178)
RED = (213, 94, 0)
PINK = (204, 121, 167)
PALETTE = [ORANGE, SKY, GREEN, YELLOW, BLUE, RED, PINK]

PAPER = (236, 232, 222)
STONE = (176, 172, 164)
SLATE = (92, 98, 108)
INK = (44, 48, 58)
SILVER = (238, 240, 244)


def linear(colour):
    """sRGB bytes -> linear 0..1, four decimals."""

    def one(value):
        fraction = value / 255
        return fraction / 12.92 if fraction <= 0.04045 else ((fraction + 0.055) / 1.055) ** 2.4

    return [round(one(value), 4) for value in colour]
