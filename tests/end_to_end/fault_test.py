"""A driver that crashes costs its own cell and no other."""

import os
import signal

import kit


class Crash(kit.KitTest):
    def run_two_scenes(self, fault):
        return self.ssrkit("run", "--scene", "m2", "--scene", "m4", "--stage", "dda", "--size", "32x18", "--out", "out",
                           env={"SSRKIT_FAULT": fault})

    def outcomes(self):
        """The worst of each cell, by scene and device."""
        checks = kit.read_json(self.path("out/results.json"))["checks"]
        cells = {}
        for check in checks:
            cells.setdefault((check["scene"], check["device"]), set()).add(check["outcome"])
        return cells

    def test_one_device_in_one_scene(self):
        result = self.run_two_scenes("crash:gl-osmesa m2 32x18: draw trace_dda")
        self.assert_exit(1, result)
        self.assert_closing_line(result)
        self.assertIn(f"signal {int(signal.SIGSEGV)}", result.out)
        self.assertIn("draw trace_dda", result.out)
        self.assertEqual({("m2", "gl-osmesa"): {"crash"}, ("m2", "vk-lavapipe"): {"pass"},
                          ("m4", "gl-osmesa"): {"pass"}, ("m4", "vk-lavapipe"): {"pass"}}, self.outcomes())
        self.assert_whole_files(self.path("out"))
        self.assertFalse(os.path.exists(self.path("out/m2/gl-osmesa")))

    def test_every_cell_of_one_device(self):
        result = self.run_two_scenes("crash:vk-lavapipe m")
        self.assert_exit(1, result)
        self.assertEqual({("m2", "gl-osmesa"): {"pass"}, ("m2", "vk-lavapipe"): {"crash"},
                          ("m4", "gl-osmesa"): {"pass"}, ("m4", "vk-lavapipe"): {"crash"}}, self.outcomes())

    def test_every_cell(self):
        result = self.run_two_scenes("crash:draw")
        self.assert_exit(1, result)
        self.assertEqual({"crash"}, set.union(*self.outcomes().values()))
        self.assertIn("0 passed, 4 failed", result.out)

    def test_fault_that_nobody_knows(self):
        self.assert_refused(self.run_two_scenes("nonsense"), "SSRKIT_FAULT", code=2)


if __name__ == "__main__":
    kit.main()
