"""What `run` wrote can be traced again, and gives the same bits."""

import exr
import kit

STAGES = ("naive", "refined", "dda", "hiz", "walk")


class RoundTrip(kit.KitTest):
    def hits(self, folder, device):
        return {stage: exr.read(self.path(folder, device, stage, "hit.exr")).bits() for stage in STAGES}

    def check_round_trip(self, scene, device, *more):
        stages = [word for stage in STAGES for word in ("--stage", stage)]
        first = self.ssrkit("run", "--scene", scene, *stages, "--device", device, "--size", "96x54", "--out", "first",
                            *more)
        self.assertIn(first.code, (0, 1), str(first))
        again = self.ssrkit("run", "--gbuffer", f"first/{scene}/{device}", *stages, "--device", device,
                            "--out", "again")
        self.assertEqual(first.code, again.code, str(again))
        before, after = self.hits(f"first/{scene}", device), self.hits(f"again/{device}", device)
        for stage in STAGES:
            self.assertEqual(before[stage], after[stage], f"{stage} found other hits")
        folders = (f"first/{scene}", f"again/{device}")
        images = [exr.read(self.path(folder, device, "lit.exr")).bits() for folder in folders]
        self.assertEqual(*images, "the light is another")

    def test_gl_in_a_scene_with_a_thickness_of_its_own(self):
        self.check_round_trip("clutter", "gl-osmesa")

    def test_vulkan_in_a_scene_with_an_origin_bias(self):
        self.check_round_trip("curved", "vk-lavapipe")

    def test_relative_thickness_and_background(self):
        self.check_round_trip("outdoor", "gl-osmesa")

    def test_parameters_of_the_command_line(self):
        self.check_round_trip("clutter", "vk-lavapipe", "--param", "thickness_m=0.05", "--param", "lookup_budget=40")

    def test_the_devices_agree_on_one_uploaded_gbuffer(self):
        self.assert_exit(0, self.trace(scene="thin", size="96x54", out="first"))
        result = self.ssrkit("run", "--gbuffer", "first/thin/gl-osmesa", "--stage", "hiz", "--stage", "dda",
                             "--out", "both")
        self.assertIn(result.code, (0, 1), str(result))
        for stage in ("hiz", "dda"):
            bits = [exr.read(self.path("both/gl-osmesa", device, stage, "hit.exr")).bits() for device in kit.DEVICES]
            self.assertEqual(*bits, stage)


class SameBytes(kit.KitTest):
    def test_two_runs_write_the_same_image_files(self):
        for folder in ("first", "second"):
            self.assert_exit(0, self.trace(out=folder))
        for name in self.assert_whole_files(self.path("first")):
            if name.endswith(".exr"):
                contents = [self.content(f"{folder}/{name}") for folder in ("first", "second")]
                self.assertEqual(*contents, name)

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()


if __name__ == "__main__":
    kit.main()
