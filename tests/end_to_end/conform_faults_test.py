"""What one bad driver costs a conformance run, and what is known of it."""

import os
import re
import signal

import kit
from conform_kit import CELL, ConformTest


class Faults(ConformTest):
    def test_a_crash_costs_exactly_its_cell(self):
        result = self.few(env={"SSRKIT_FAULT": "crash:vk-lavapipe trace.bits m2 33x17"})
        self.assert_exit(1, result)
        self.assertEqual(self.cells("pass", "crash", "pass", "pass"), self.outcomes())
        self.assertIn(f"signal {int(signal.SIGSEGV)}", result.out)
        self.assertIn(f"./ssrkit conform --filter {CELL}/vk-lavapipe", result.out)
        record = kit.read_json(self.record(f"{CELL}/vk-lavapipe"))
        self.assertEqual(["trace.bits.runs"], [check["id"] for check in record["checks"]])
        self.assertEqual(2, record["attempts"], "it was run again alone")

    def test_a_crash_of_the_reference_is_counted_once(self):
        result = self.few(env={"SSRKIT_FAULT": "crash:gl-osmesa trace.bits m2 33x17"})
        self.assert_exit(1, result)
        self.assertEqual(self.cells("crash", "skip", "pass", "pass"), self.outcomes())
        self.assertIn(" passed, 1 failed, 1 skipped", result.out)

    def test_a_reference_that_nobody_reports_on_is_an_error(self):
        result = self.conform("--device", "vk-lavapipe", "--filter", CELL,
                              env={"SSRKIT_FAULT": "crash:gl-osmesa trace.bits"})
        self.assert_exit(1, result)
        self.assertEqual({f"{CELL}/vk-lavapipe": "error"}, self.outcomes())
        self.assertIn("gl-osmesa", result.out)

    def test_a_crash_that_does_not_come_again_is_a_flake(self):
        for device, before in (("vk-lavapipe", "a"), ("gl-osmesa", "b")):
            result = self.few(env={"SSRKIT_FAULT": f"crash:{device} trace.bits m2 33x17;once={self.path(before)}"})
            self.assert_exit(4, result)
            outcomes = self.cells("pass", "pass", "pass", "pass")
            outcomes[f"{CELL}/{device}"] = "flake"
            self.assertEqual(outcomes, self.outcomes())
            self.assertIn("was crash once", result.out)

    def test_a_wrong_answer_that_does_not_come_again_is_a_flake(self):
        result = self.few(env={"SSRKIT_FAULT": f"wrong:vk-lavapipe trace.bits m2 33x17;once={self.path('once')}"})
        self.assert_exit(4, result)
        self.assertEqual(self.cells("pass", "flake", "pass", "pass"), self.outcomes())
        self.assertIn("was fail once", result.out)

    def test_a_wrong_answer_fails_and_says_where_and_how_to_see_it_again(self):
        result = self.few(env={"SSRKIT_FAULT": "wrong:vk-lavapipe trace.bits m2 33x17"})
        self.assert_exit(1, result)
        self.assertEqual(self.cells("pass", "fail", "pass", "pass"), self.outcomes())
        for word in ("yours ", "expected ", "pixel", f"again     ./ssrkit conform --filter {CELL}/vk-lavapipe"):
            self.assertIn(word, result.out)
        again = re.search(r"again     \./ssrkit (conform .*)", result.out).group(1).split()
        self.assert_exit(0, self.ssrkit(*again, "--out", "again"))

    def pictures(self, out):
        """Those on the page of a run, PNG files in base64."""
        with open(self.path(out, "report.html")) as file:
            return set(re.findall(r"iVBORw0KGgo[A-Za-z0-9+/=]+", file.read()))

    def test_a_resumed_or_merged_run_still_shows_where_it_failed(self):
        fault = {"SSRKIT_FAULT": "wrong:vk-lavapipe trace.bits m2 33x17"}
        self.assert_exit(1, self.few(env=fault, filters=[CELL]))
        shown = self.pictures("out")
        self.assertGreaterEqual(len(shown), 2)
        self.assert_exit(1, self.ssrkit("conform", "merge", "out", "--out", "merged"))
        self.assertEqual(shown, self.pictures("merged"))
        self.assert_exit(1, self.few("--resume", filters=[CELL]))
        self.assertEqual(shown, self.pictures("out"))

    def test_a_repeated_run_finds_what_fails_now_and_then(self):
        result = self.few("--repeat", "3", filters=[CELL],
                          env={"SSRKIT_FAULT": f"wrong:vk-lavapipe trace.bits m2;once={self.path('once')}"})
        self.assert_exit(4, result)
        self.assertIn("failed in 1 of 3 runs", result.out)

    def test_what_fails_after_another_cell_is_a_failure_that_names_it(self):
        fault = "wrong:vk-lavapipe trace.bits m4 33x17;after=vk-lavapipe trace.bits m2 33x17"
        filters = [f"trace.bits/{scene}/33x17" for scene in ("m1", "m2", "m3", "m4")]
        result = self.few(filters=filters, env={"SSRKIT_FAULT": fault})
        self.assert_exit(1, result)
        self.assertIn(f"passes alone; fails after {CELL}/vk-lavapipe", result.out)
        failed = [cell for cell, outcome in self.outcomes().items() if outcome != "pass"]
        self.assertEqual(["trace.bits/m4/33x17/vk-lavapipe"], failed)
        in_order = re.search(r"in order  \./ssrkit (conform .*)", result.out).group(1).split()
        self.assert_exit(1, self.ssrkit(*in_order, "--out", "again", env={"SSRKIT_FAULT": fault}))
        self.assert_exit(0, self.few(filters=["trace.bits/m4/33x17"], env={"SSRKIT_FAULT": fault}, out="alone"))


class KnownFailures(ConformTest):
    FAULT = {"SSRKIT_FAULT": "wrong:vk-lavapipe trace.bits m2 33x17"}

    def known(self, expires="2999-12-31"):
        """A baseline that lists exactly what the fault makes wrong."""
        self.assert_exit(1, self.few(env=self.FAULT))
        failed = [check for check in self.results()["checks"] if check["outcome"] == "fail"]
        self.assertTrue(failed)
        text = ""
        for check in failed:
            text += "[[expected_failure]]\n"
            text += "".join(f'{key} = "{check[key]}"\n' for key in ("id", "device", "scene", "stage", "case")
                            if check[key])
            text += (f'driver = "llvmpipe"\noutcome = ["fail"]\nreason = "made wrong on purpose"\n'
                     f'expires = "{expires}"\nbug = "docs/driver-bugs.md#none"\n')
        return self.write("known.toml", text)

    def test_are_excused_with_their_reason(self):
        known = self.known()
        result = self.few("--baseline", known, env=self.FAULT)
        self.assert_exit(0, result)
        self.assertEqual(self.cells("pass", "xfail", "pass", "pass"), self.outcomes())
        excused = [check for check in self.results()["checks"] if check["outcome"] == "xfail"]
        for check in excused:
            self.assertIn("made wrong on purpose", check["message"])
        merged = self.ssrkit("conform", "merge", "out", "--baseline", known, "--out", "merged")
        self.assert_exit(0, merged)
        self.assertEqual(self.outcomes(), self.outcomes("merged"))

    def test_fail_when_they_pass(self):
        result = self.few("--baseline", self.known())
        self.assert_exit(1, result)
        self.assertEqual(self.cells("pass", "xpass", "pass", "pass"), self.outcomes())
        self.assertIn("take the entry out", result.out)

    def test_expire(self):
        result = self.few("--baseline", self.known(expires="2020-01-01"), env=self.FAULT)
        self.assert_exit(1, result)
        self.assertEqual(self.cells("pass", "fail", "pass", "pass") | {"known-failures": "error"}, self.outcomes())
        self.assertIn("has expired on 2020-01-01", result.out)

    def test_a_bad_file_is_refused_before_anything_runs(self):
        known = self.write("bad.toml", '[[expected_failure]]\nid = "x"\ndevice = "gl-osmesaa"\n')
        self.assert_refused(self.few("--baseline", known), "bad.toml:3:", "did you mean 'gl-osmesa'?")
        self.assert_refused(self.few("--baseline", "nowhere.toml"), "nowhere.toml")
        self.assertFalse(os.path.exists(self.path("out")))


if __name__ == "__main__":
    kit.main()
