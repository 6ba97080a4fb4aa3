"""`ssrkit devices`: who is there."""

import json
import resource
import time

import kit

CPU_S = 1.0  # of all its processes; 0.15 s here. The time on the wall is the machine's other users' too.


SOFTWARE = ("gl-osmesa", "vk-lavapipe", "gl-egl", "gl-zink", "gl-glsl", "gl-softpipe", "vk-swiftshader")
HARDWARE = ("gl-gpu", "vk-gpu")
MESA_CUTS_LOOPS = SOFTWARE[:5]  # those on llvmpipe


class Devices(kit.KitTest):
    def listed(self, *arguments, code=0, env=None):
        result = self.ssrkit("devices", "--json", *arguments, env=env)
        self.assert_exit(code, result)
        return {device["id"]: device for device in json.loads(result.out)}

    def test_every_software_device_is_there(self):
        result = self.ssrkit("devices")
        self.assert_exit(0, result)
        self.assertEqual("", result.err)
        for device in SOFTWARE + HARDWARE:
            self.assertIn(device, result.out)
        self.assertNotIn("\x1b", result.out)
        self.assertLessEqual(result.out.count("absent"), len(HARDWARE), result.out)

    def test_json(self):
        devices = self.listed()
        self.assertEqual(SOFTWARE + HARDWARE, tuple(devices))
        for name in SOFTWARE:
            device = devices[name]
            self.assertTrue(device["present"], device)
            self.assertEqual(name in MESA_CUTS_LOOPS, device["traits"]["loop_cap"] > 0, device)
            expected = {"gl-glsl": "GLSL 450", "gl-softpipe": "GLSL 330"}.get(name, "SPIR-V")
            self.assertEqual(expected, device["traits"]["shader_input"])
        for pair in (("gl-osmesa", "gl-egl"), ("vk-lavapipe", "gl-zink")):
            self.assertEqual(1, len({devices[name]["pipeline"] for name in pair}))

    def test_absent_hardware_says_why_and_what_to_install(self):
        for name, device in self.listed().items():
            if not device["present"]:
                self.assertIn(name, HARDWARE)
                self.assertIn("Debian", device["why_absent"])
                refused = self.trace(device=name)
                self.assert_refused(refused, "could not", "Debian", code=3)
                self.assert_exit(3, self.ssrkit("devices", "--device", name))

    def test_names_choose(self):
        self.assertEqual(["vk-lavapipe"], list(self.listed("--device", "vk-lavapipe")))
        self.assert_refused(self.ssrkit("devices", "--device", "gl-ogl"), "gl-ogl", "the devices are")

    @staticmethod
    def default_devices():
        return [word for name in kit.DEVICES for word in ("--device", name)]

    def test_takes_no_time(self):
        costs = []
        for _ in range(3):
            start, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
            self.assert_exit(0, self.ssrkit("devices", *self.default_devices()))
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            cpu_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            costs.append((cpu_s, time.monotonic() - start))
        print(f"ssrkit devices took {min(costs)[0]:.2f} s of CPU and {min(costs)[1]:.2f} s")
        self.assertLess(min(costs)[0], CPU_S)

    def test_a_device_that_does_not_start_is_absent_and_an_error_where_it_is_named(self):
        broken = {"SSRKIT_FAULT": "crash:vk-lavapipe start"}
        listed = self.ssrkit("devices", env=broken)
        self.assert_exit(0, listed)
        self.assertIn("absent: could not start the device 'vk-lavapipe'", listed.out)
        self.assertIn("OpenGL 4.5", listed.out)
        devices = self.listed(*self.default_devices(), code=3, env=broken)
        self.assertEqual({"gl-osmesa": True, "vk-lavapipe": False},
                         {name: device["present"] for name, device in devices.items()})
        traced = self.trace(device="vk-lavapipe", env=broken)
        self.assert_exit(3, traced)
        self.assertIn("could not start the device 'vk-lavapipe'", traced.err)


if __name__ == "__main__":
    kit.main()
