"""`ssrkit devices`: who is there."""

import json
import resource
import time

import kit

CPU_S = 1.0  # of all its processes; 0.15 s here. The time on the wall is the machine's other users' too.


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
        costs = []
        for _ in range(3):
            start, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
            self.assert_exit(0, self.ssrkit("devices"))
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            cpu_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            costs.append((cpu_s, time.monotonic() - start))
        print(f"ssrkit devices took {min(costs)[0]:.2f} s of CPU and {min(costs)[1]:.2f} s")
        self.assertLess(min(costs)[0], CPU_S)

    def test_a_device_that_does_not_start_is_an_error_and_the_other_is_shown(self):
        broken = {"SSRKIT_FAULT": "crash:vk-lavapipe start"}
        listed = self.ssrkit("devices", env=broken)
        self.assert_exit(3, listed)
        self.assertIn("absent: could not start the device 'vk-lavapipe'", listed.out)
        self.assertIn("OpenGL 4.5", listed.out)
        devices = json.loads(self.ssrkit("devices", "--json", env=broken).out)
        self.assertEqual([("gl-osmesa", True), ("vk-lavapipe", False)],
                         [(device["id"], device["present"]) for device in devices])
        traced = self.trace(device="vk-lavapipe", env=broken)
        self.assert_exit(3, traced)
        self.assertIn("could not start the device 'vk-lavapipe'", traced.err)


if __name__ == "__main__":
    kit.main()
