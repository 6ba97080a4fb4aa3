"""`ssrkit devices`: who is there."""

import json
import time

import kit

NO_OP_S = 3.0  # 0.5 s on a machine of one's own


class Devices(kit.KitTest):
    def test_both_are_there(self):
        result = self.ssrkit("devices")
        self.assert_exit(0, result)
        self.assertEqual("", result.err)
        for device in kit.DEVICES:
            self.assertIn(device, result.out)
        self.assertNotIn("absent", result.out)
        self.assertNotIn("\x1b", result.out)

    def test_json(self):
        result = self.ssrkit("devices", "--json")
        self.assert_exit(0, result)
        devices = {device["id"]: device for device in json.loads(result.out)}
        for name in kit.DEVICES:
            self.assertTrue(devices[name]["present"])
            self.assertGreater(devices[name]["traits"]["loop_cap"], 0)  # Mesa cuts loops
            self.assertEqual("SPIR-V", devices[name]["traits"]["shader_input"])

    def test_takes_no_time(self):
        times = []
        for _ in range(3):
            start = time.monotonic()
            self.assert_exit(0, self.ssrkit("devices"))
            times.append(time.monotonic() - start)
        print(f"ssrkit devices took {min(times):.2f} s at best of {len(times)}")
        self.assertLess(min(times), NO_OP_S)

    def test_a_driver_that_is_not_there_is_an_error(self):
        missing = {"VK_ICD_FILENAMES": "/nonexistent/icd.json", "VK_DRIVER_FILES": "/nonexistent/icd.json"}
        listed = self.ssrkit("devices", env=missing)
        if listed.code == 0:
            self.skipTest("the kit chooses its Vulkan driver itself")
        self.assert_exit(3, listed)
        self.assertIn("absent: could not", listed.out)
        self.assert_refused(self.trace(device="vk-lavapipe", env=missing), "vk-lavapipe", code=3)


if __name__ == "__main__":
    kit.main()
