"""Cells beside those of the tests: what a driver does that its answers do not tell."""

import os
import xml.etree.ElementTree as ElementTree

import kit
from conform_kit import TWO, ConformTest

OUTSIDE = """
  float list[4] = float[4](1.0, 2.0, 3.0, 4.0);
  int index = int(gl_FragCoord.x) * 50000000 - 100000000;
  list[index] = 7.0;
  hit.t_m += list[0] + list[1] + list[2] + list[3] - 10.0;
"""
EXTRA = ("safety.trace.bits/m2/33x17", "validate.core.trace.bits/m2/33x17", "validate.sync.trace.bits/m2/33x17")
ASK = ("--safety", "--validate", "sync,core")


class ExtraCells(ConformTest):
    def test_are_listed_where_they_are_asked_for(self):
        plain = self.listed()
        listed = self.listed("--safety", "--validate", "core,gpu")
        self.assertEqual(plain, listed[:len(plain)])
        extra = listed[len(plain):]
        kinds = {name.split("/")[0].removesuffix("trace.bits") for name in extra if "trace.bits/" in name}
        self.assertEqual({"safety.", "validate.core.", "validate.gpu."}, kinds)
        for name in extra:
            self.assertNotIn("variants.", name)
            if name.startswith("validate."):
                self.assertTrue(name.endswith("/vk-lavapipe"), name)
        self.assertFalse([name for name in plain if name.startswith(("safety.", "validate."))])
        self.assert_refused(self.ssrkit("conform", "--list", "--filter", EXTRA[0]), "no cell matches")

    def test_pass_and_are_cells_like_others(self):
        whole = self.few(*ASK, filters=EXTRA, out="whole")
        self.assert_exit(0, whole)
        expected = {f"{EXTRA[0]}/gl-osmesa": "pass"} | {f"{cell}/vk-lavapipe": "pass" for cell in EXTRA}
        self.assertEqual(expected, self.outcomes("whole"))
        found = {check["id"]: check for check in self.results("whole")["checks"]}
        self.assertEqual({"safety.trace.bits.out_of_bounds", "safety.trace.bits.counted_loops",
                          "validate.core.trace.bits.validation", "validate.sync.trace.bits.validation"}, set(found))
        self.assertEqual(0, found["safety.trace.bits.out_of_bounds"]["value"])
        self.assert_in_junit()
        self.assert_resumed(expected)
        self.assert_merged()

    def assert_in_junit(self):
        tree = ElementTree.parse(self.path("whole/junit.xml"))
        names = {case.get("classname") for case in tree.iter("testcase")}
        self.assertIn("vk-lavapipe.validate.sync.trace.bits.validation", names)
        for suite in tree.iter("testsuite"):
            self.assertGreater(float(suite.get("time")), 0.0)

    def assert_resumed(self, expected):
        removed = f"{EXTRA[0]}/gl-osmesa"
        kept = [cell for cell in expected if cell != removed]
        before = [os.stat(self.record(cell, "whole")).st_mtime_ns for cell in kept]
        os.remove(self.record(removed, "whole"))
        self.assert_exit(0, self.few(*ASK, "--resume", filters=EXTRA, out="whole"))
        self.assertEqual(before, [os.stat(self.record(cell, "whole")).st_mtime_ns for cell in kept])
        self.assertEqual(expected, self.outcomes("whole"))

    def assert_merged(self):
        for index in (1, 2):
            self.few(*ASK, "--shard", f"{index}/2", filters=EXTRA, out=f"shard-{index}")
        self.assert_exit(0, self.ssrkit("conform", "merge", "shard-1", "shard-2", "--out", "merged"))
        self.assertEqual(self.results("whole")["checks"], self.results("merged")["checks"])

    def test_no_device_that_can_be_validated(self):
        self.assert_refused(self.conform("--device", "gl-osmesa", "--validate", "core"), "Vulkan", "--validate")
        self.assert_refused(self.few("--validate", "speed"), "'speed'")


class Findings(ConformTest):
    def test_a_shader_that_leaves_its_array_costs_the_cells_that_draw_it(self):
        with open(f"{kit.SOURCE}/shaders/trace_dda.frag") as file:
            text = file.read().replace("  trace_end(hit);", OUTSIDE + "  trace_end(hit);")
        cells = ("safety.trace.bits/m2/33x17", "safety.trace.mips/clutter/63x35")
        result = self.few("--safety", filters=cells, env=self.kit_with("trace_dda.frag", text))
        self.assert_exit(1, result)
        outcomes = self.outcomes()
        for device in kit.DEVICES:
            self.assertEqual("fail", outcomes[f"{cells[0]}/{device}"])
            self.assertEqual("pass", outcomes[f"{cells[1]}/{device}"])
        self.assertIn("reads or writes outside", result.out)
        self.assertIn(f"./ssrkit conform --safety --filter {cells[0]}/gl-osmesa", result.out)

    def test_a_barrier_that_waits_for_nothing_is_a_hazard_and_no_wrong_picture(self):
        cells = ("trace.bits/m2/33x17", *EXTRA)
        result = self.few(*ASK, filters=cells, env={"SSRKIT_FAULT": "barrier:"})
        self.assert_exit(1, result)
        failed = [cell for cell, outcome in self.outcomes().items() if outcome != "pass"]
        self.assertEqual([f"{EXTRA[2]}/vk-lavapipe"], failed, str(result))
        self.assertIn("SYNC-HAZARD", result.out)
        again = self.conform(*TWO, "--rerun-failed", "out", out="again")
        self.assert_exit(0, again)
        self.assertEqual({f"{EXTRA[2]}/vk-lavapipe": "pass"}, self.outcomes("again"))


if __name__ == "__main__":
    kit.main()
