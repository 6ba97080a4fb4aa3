"""What is printed: a table for people that fits 100 columns, JSON for programs, escape codes for terminals alone."""

import json
import os
import pty
import select
import subprocess

import kit

ESCAPE = "\x1b"


class Table(kit.KitTest):
    def test_fits_100_columns_and_ends_with_the_count(self):
        result = self.ssrkit("run", "--scene", "m2", "--scene", "corridor", "--size", "32x18", "--out", "out")
        self.assertIn(result.code, (0, 1), str(result))
        self.assert_closing_line(result)
        rows = [line for line in result.out.splitlines() if any(device in line for device in kit.DEVICES)]
        self.assertGreaterEqual(len(rows), 16)
        for line in result.out.split("\nfail:")[0].splitlines():
            self.assertLessEqual(len(line), 100, line)

    def test_no_escape_codes_in_a_pipe(self):
        result = self.trace()
        self.assertNotIn(ESCAPE, result.out + result.err)


class Terminal(kit.KitTest):
    def in_terminal(self, **variables):
        """What a terminal is sent by a run."""
        ours, theirs = pty.openpty()
        process = subprocess.Popen([kit.PROGRAM, "run", "--scene", "m2", "--stage", "dda", "--size", "32x18"],
                                   stdin=theirs, stdout=theirs, stderr=theirs, cwd=self.folder,
                                   env=kit.environment(**{"TERM": "xterm", **variables}))
        os.close(theirs)
        text = b""
        while select.select([ours], [], [], kit.PATIENCE_S)[0]:
            try:
                part = os.read(ours, 65536)
            except OSError:  # Linux reports the last writer's end so
                break
            if not part:
                break
            text += part
        os.close(ours)
        self.assertEqual(0, process.wait())
        return text.decode()

    def test_outcomes_are_coloured(self):
        self.assertIn(ESCAPE + "[32m", self.in_terminal())

    def test_no_color_has_no_colours(self):
        self.assertNotIn(ESCAPE + "[3", self.in_terminal(NO_COLOR="1"))

    def test_dumb_terminal_has_no_colours(self):
        self.assertNotIn(ESCAPE + "[3", self.in_terminal(TERM="dumb"))


class Json(kit.KitTest):
    def test_run_prints_json_alone_and_writes_the_same(self):
        result = self.trace("--json", device=None)
        self.assertIn(result.code, (0, 1), str(result))
        self.assertEqual(kit.read_json(self.path("out/results.json")), json.loads(result.out))

    def test_a_bad_scene_is_told_in_json_too(self):
        self.write("bad.gltf", "")
        result = self.trace("--json", scene="bad.gltf")
        self.assert_refused(result, "bad.gltf", "empty")
        checks = json.loads(result.out)["checks"]
        self.assertEqual(["error"], [check["outcome"] for check in checks])

    def test_results_hold_what_their_description_says(self):
        self.trace(device=None)
        results = kit.read_json(self.path("out/results.json"))
        self.assertEqual("ssrkit-results", results["schema"])
        self.assertIsInstance(results["schema_version"], int)
        self.assertRegex(results["started"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertEqual(set(kit.DEVICES), {device["id"] for device in results["devices"]})
        for device in results["devices"]:
            self.assertLessEqual({"api", "driver", "version", "cpu", "cpu_features", "traits"}, set(device))
        self.assertEqual(2, len(results["traces"]))
        for trace in results["traces"]:
            self.assertEqual(("m2", "dda", [32, 18]), (trace["scene"], trace["stage"], trace["size"]))
            self.assertEqual(32 * 18, sum(trace["classes"].values()))
            self.assertLessEqual({"mean", "p50", "p95", "max"}, set(trace["lookups"]))
            self.assertEqual("inf", trace["parameters"]["thickness_m"])
        for check in results["checks"]:
            self.assertLessEqual({"id", "scene", "device", "stage", "size", "case", "parameters", "outcome", "metric",
                                  "value", "bound", "unit", "message", "repro"}, set(check))
        outcomes = [check["outcome"] for check in results["checks"]]
        self.assertEqual({name: outcomes.count(name) for name in set(outcomes)}, results["summary"]["outcomes"])

    def test_files_of_a_run(self):
        self.trace("--stage", "hiz", device=None)
        names = self.assert_whole_files(self.path("out"))
        wanted = ["results.json", "checks.csv", "junit.xml", "m2/camera.json", "m2/oracle/hit.exr"]
        for device in kit.DEVICES:
            wanted += [f"m2/{device}/lit.exr", f"m2/{device}/contact_sheet.png"]
            wanted += [f"m2/{device}/gbuffer/{image}.exr" for image in
                       ("albedo", "normal_view", "material", "depth_window", "dist_view")]
            wanted += [f"m2/{device}/{stage}/{file}" for stage in ("dda", "hiz") for file in ("hit.exr", "color.exr")]
        self.assertEqual([], sorted(set(wanted) - set(names)))


if __name__ == "__main__":
    kit.main()
