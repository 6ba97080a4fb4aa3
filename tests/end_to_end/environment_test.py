"""What lights the full frame from outside: said on the command line or beside the scene, refused in a sentence."""

import math

import exr
import kit


def sky(width=16, height=8, **channels):
    return exr.encode(width, height, channels or {"R": 0.25, "G": 0.5, "B": 1.0})


class Environments(kit.KitTest):
    def assert_environment_refused(self, content, *words):
        name = self.write("sky.exr", content)
        self.assert_refused(self.trace("--frame", "full", "--environment", name), "sky.exr", "read the environment",
                            *words)

    def test_background_shows_the_file(self):
        name = self.write("sky.exr", sky())
        self.assert_exit(0, self.trace("--frame", "full", "--environment", name, scene="outdoor"))
        lit = exr.read(self.path("out/outdoor/gl-osmesa/lit.exr"))
        self.assertEqual([0.25, 0.5, 1.0], [lit.channels[channel][0] for channel in "RGB"])

    def test_background_shows_the_constant(self):
        self.assert_exit(0, self.trace("--frame", "full", "--environment", "constant:0.5,2,0", scene="outdoor"))
        lit = exr.read(self.path("out/outdoor/gl-osmesa/lit.exr"))
        self.assertEqual([0.5, 2.0, 0.0], [lit.channels[channel][0] for channel in "RGB"])

    def test_missing_file(self):
        self.assert_refused(self.trace("--frame", "full", "--environment", "none.exr"), "none.exr", "no such file")

    def test_what_is_no_exr(self):
        self.assert_environment_refused("a picture", "not an EXR")

    def test_cut_short(self):
        self.assert_environment_refused(sky()[:-40], "sky.exr")

    def test_not_twice_as_wide_as_high(self):
        self.assert_environment_refused(sky(8, 8), "8 x 8 texels", "twice as wide as high")

    def test_without_colours(self):
        self.assert_environment_refused(sky(Y=1.0), "the channel 'R' is missing")

    def test_radiance_that_is_none(self):
        for value, word in ((math.nan, "nan"), (-1.0, "-1"), (math.inf, "inf"), (1e6, "65504")):
            with self.subTest(word):
                green = [0.5] * 128
                green[37] = value
                self.assert_environment_refused(sky(R=0.5, G=green, B=0.5), "G at texel (5, 2)", word)

    def test_constant_that_is_no_colour(self):
        for text in ("constant:", "constant:1,2", "constant:1,2,-3", "constant:a,b,c", "constant:1,2,nan"):
            with self.subTest(text):
                self.assert_refused(self.trace("--frame", "full", "--environment", text), text, "--environment")

    def test_frame_that_has_none(self):
        self.assert_refused(self.trace("--environment", "constant:1,1,1"), "'basic'", "--frame full")


if __name__ == "__main__":
    kit.main()
