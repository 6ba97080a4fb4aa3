"""G-buffers made by others: what cannot be traced is refused by file and texel."""

import json
import math
import os

import exr
import kit

WIDTH, HEIGHT = 6, 4


def camera():
    """60 degrees high, near plane 0.1 m, far plane 100 m, at the world's origin."""
    near, far = 0.1, 100.0
    scale = 1.0 / math.tan(math.radians(30))
    unit = [[1.0 if row == column else 0.0 for column in range(4)] for row in range(4)]
    return {"schema": "ssrkit.camera", "version": 1, "size": [WIDTH, HEIGHT],
            "clip_from_view": [[scale * HEIGHT / WIDTH, 0, 0, 0], [0, scale, 0, 0],
                               [0, 0, far / (near - far), near * far / (near - far)], [0, 0, -1, 0]],
            "view_from_world": unit, "near_m": near, "far_m": far}


class GbufferTest(kit.KitTest):
    """A wall two metres away whose texels all face the camera; each test spoils one thing."""

    def setUp(self):
        super().setUp()
        os.mkdir(self.path("view"))
        self.write_camera(camera())
        self.write_dist_view({"Z": 2.0})
        self.write_normal_view({"R": 0.0, "G": 0.0, "B": 1.0})

    def write_camera(self, content):
        text = content if isinstance(content, (str, bytes)) else json.dumps(content)
        return self.write("view/camera.json", text)

    def write_dist_view(self, channels, width=WIDTH, height=HEIGHT):
        exr.write(self.path("view", "dist_view.exr"), width, height, channels)

    def write_normal_view(self, channels, width=WIDTH, height=HEIGHT):
        exr.write(self.path("view", "normal_view.exr"), width, height, channels)

    def spoiled(self, value):
        """Depths of two metres with one other value, at texel (3, 2)."""
        depths = [2.0] * (WIDTH * HEIGHT)
        depths[2 * WIDTH + 3] = value
        return {"Z": depths}

    def run_it(self, *more):
        return self.ssrkit("run", "--gbuffer", "view", "--stage", "dda", "--device", "gl-osmesa", "--out", "out", *more)

    def assert_refused_early(self, *words):
        self.assert_refused(self.run_it(), *words)
        self.assertFalse(os.path.exists(self.path("out")), "something was written")


class GoodGbuffers(GbufferTest):
    def test_two_images_and_a_camera_are_enough(self):
        result = self.run_it()
        self.assert_exit(0, result)
        hit = exr.read(self.path("out/view/gl-osmesa/dda/hit.exr"))
        self.assertEqual((WIDTH, HEIGHT), (hit.width, hit.height))

    def test_blender_channel_names_are_taken(self):
        self.write_dist_view({"V": 2.0})
        self.write_normal_view({"X": 0.0, "Y": 0.0, "Z": 1.0})
        self.assert_exit(0, self.run_it())

    def test_background_is_infinite_and_needs_no_normal(self):
        self.write_dist_view(self.spoiled(math.inf))
        normals = {"R": [0.0] * 24, "G": [0.0] * 24, "B": [1.0] * 24}
        normals["B"][15] = 0.0
        self.write_normal_view(normals)
        self.assert_exit(0, self.run_it())

    def test_images_may_lie_in_a_folder_named_gbuffer(self):
        os.mkdir(self.path("view/gbuffer"))
        for name in ("dist_view.exr", "normal_view.exr"):
            os.rename(self.path("view", name), self.path("view/gbuffer", name))
        self.assert_exit(0, self.run_it())


class MissingParts(GbufferTest):
    def test_folder(self):
        self.assert_refused(self.ssrkit("run", "--gbuffer", "nosuch"), "nosuch", "no such folder")

    def test_empty_name(self):
        self.assert_refused(self.ssrkit("run", "--gbuffer", "", "--size", "8x8", "--stage", "dda"), "--gbuffer")

    def test_camera(self):
        os.remove(self.path("view/camera.json"))
        self.assert_refused_early("camera.json is missing", "docs/formats.md")

    def test_depth(self):
        os.remove(self.path("view/dist_view.exr"))
        self.assert_refused_early("dist_view.exr is missing")

    def test_normals(self):
        os.remove(self.path("view/normal_view.exr"))
        self.assert_refused_early("normal_view.exr is missing")

    def test_scene_and_gbuffer_together(self):
        self.assert_refused(self.run_it("--scene", "m1"), "--gbuffer and --scene")
        for option, value in (("--size", "64x36"), ("--camera", "front"), ("--mirror", "floor")):
            with self.subTest(option):
                self.assert_refused(self.run_it(option, value), "--gbuffer", option, "leave one of the two out")


class BadCameras(GbufferTest):
    def spoil(self, key, value):
        content = camera()
        content[key] = value
        self.write_camera(content)

    def test_not_json(self):
        self.write_camera("{ this is no JSON")
        self.assert_refused_early("camera.json", "line 1")

    def test_empty_file(self):
        self.write_camera("")
        self.assert_refused_early("camera.json")

    def test_json_of_another_shape(self):
        for text in ("[]", "3", "null", '{"schema": 5}', '"text"'):
            with self.subTest(text):
                self.write_camera(text)
                self.assert_refused_early("camera.json")

    def test_bytes_that_are_no_text(self):
        self.write_camera(b"\xff\xfe{\x00\x80\xf0")
        self.assert_refused_early("camera.json")

    def test_brackets_without_end(self):
        self.write_camera("[" * 200000)
        self.assert_refused_early("camera.json")

    def test_orthographic_matrix(self):
        content = camera()
        content["clip_from_view"][3] = [0, 0, 0, 1]
        self.write_camera(content)
        self.assert_refused_early("camera.json")

    def test_values_that_no_camera_has(self):
        for key, value in (("size", [0, 4]), ("size", [-6, 4]), ("size", [6]), ("size", "6x4"), ("size", [1e99, 4]),
                           ("near_m", 0), ("near_m", -1), ("near_m", "x"), ("far_m", 0.05),
                           ("clip_from_view", [[0] * 4] * 4), ("clip_from_view", [[1] * 4] * 3),
                           ("view_from_world", [[0] * 4] * 4), ("view_from_world", None)):
            with self.subTest(key=key, value=value):
                self.spoil(key, value)
                self.assert_refused_early("camera.json")

    def test_number_out_of_range(self):
        self.write_camera(json.dumps(camera()).replace("100.0", "1e999"))
        self.assert_refused_early("camera.json")

    def test_size_unlike_the_images(self):
        self.spoil("size", [12, 8])
        self.assert_refused_early("dist_view.exr", "6 x 4", "12 x 8")


class BadDepths(GbufferTest):
    def test_nan_zero_and_negative_are_named_by_texel(self):
        for value in (math.nan, 0.0, -0.0, -2.0, -math.inf):
            with self.subTest(value=value):
                self.write_dist_view(self.spoiled(value))
                self.assert_refused_early("dist_view.exr", "texel (3, 2)")

    def test_denormal_and_huge_depths_do_not_crash(self):
        for value in (1e-42, 3e38):
            with self.subTest(value=value):
                self.write_dist_view(self.spoiled(value))
                self.assertIn(self.run_it().code, (0, 1, 2))

    def test_wrong_channels(self):
        self.write_dist_view({"depth": 2.0})
        self.assert_refused_early("dist_view.exr", "depth", "Z")

    def test_wrong_size(self):
        self.write_dist_view({"Z": 2.0}, width=5)
        self.assert_refused_early("dist_view.exr", "5 x 4", "6 x 4")

    def test_cut_short_anywhere(self):
        whole = exr.encode(WIDTH, HEIGHT, {"Z": 2.0})
        for length in (0, 3, 8, 60, len(whole) // 2, len(whole) - 1):
            with self.subTest(length=length):
                self.write("view/dist_view.exr", whole[:length])
                self.assert_refused_early("dist_view.exr")

    def test_not_an_image(self):
        self.write("view/dist_view.exr", "hello" * 100)
        self.assert_refused_early("dist_view.exr", "not an EXR file")

    def test_a_size_that_would_fill_the_memory(self):
        huge = exr.encode(1, 1, {"Z": 2.0}).replace(b"\0" * 16, b"\0" * 8 + b"\xff\xff\xff\x7f" * 2)
        self.write("view/dist_view.exr", huge)
        self.assert_refused_early("dist_view.exr")


class BadNormals(GbufferTest):
    def test_zero_length_is_named_by_texel(self):
        normals = {"R": [0.0] * 24, "G": [0.0] * 24, "B": [1.0] * 24}
        normals["B"][7] = 0.0
        self.write_normal_view(normals)
        self.assert_refused_early("normal_view.exr", "length 0", "texel (1, 1)")

    def test_nan(self):
        self.write_normal_view({"R": math.nan, "G": 0.0, "B": 1.0})
        self.assert_refused_early("normal_view.exr", "nan")

    def test_infinite(self):
        self.write_normal_view({"R": math.inf, "G": 0.0, "B": 1.0})
        self.assert_refused_early("normal_view.exr")

    def test_one_channel_only(self):
        self.write_normal_view({"R": 1.0})
        self.assert_refused_early("normal_view.exr", "channels")


class BadOptionalImages(GbufferTest):
    def test_wrong_size_is_refused_though_it_could_be_left_out(self):
        exr.write(self.path("view/albedo.exr"), 2, 2, {"R": 0.5, "G": 0.5, "B": 0.5})
        self.assert_refused_early("albedo.exr", "2 x 2")

    def test_nan_in_colours_does_not_crash(self):
        for name in ("albedo", "material", "emission", "lit"):
            with self.subTest(name):
                exr.write(self.path(f"view/{name}.exr"), WIDTH, HEIGHT, {"R": math.nan, "G": math.inf, "B": -1.0})
                self.assertIn(self.run_it().code, (0, 1, 2))


if __name__ == "__main__":
    kit.main()
