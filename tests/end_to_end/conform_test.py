"""The conformance matrix: selection, shards, resuming, and what one bad driver costs."""

import json
import os
import re
import shutil
import signal
import subprocess
import time

import kit

TWO = ["--device", "gl-osmesa", "--device", "vk-lavapipe"]
CELL = "trace.bits/m2/33x17"  # and a device


class ConformTest(kit.KitTest):
    def conform(self, *arguments, out="out", **options):
        return self.ssrkit("conform", *arguments, "--out", out, **options)

    def few(self, *arguments, filters=("trace.bits/m2/33x17", "trace.bits/m4/33x17"), **options):
        """Four cells on two devices, in order and one after another."""
        line = [word for pattern in filters for word in ("--filter", pattern)]
        return self.conform(*TWO, *line, "--jobs", "1", *arguments, **options)

    def listed(self, *arguments):
        result = self.ssrkit("conform", "--list", *TWO, *arguments)
        self.assert_exit(0, result)
        return result.out.splitlines()

    def results(self, out="out"):
        return kit.read_json(self.path(out, "results.json"))

    def outcomes(self, out="out"):
        """The gravest outcome of each cell."""
        return {cell["id"]: cell["outcome"] for cell in self.results(out)["cells"]}

    def cells(self, *outcomes, scenes=("m2", "m4")):
        ids = [f"trace.bits/{scene}/33x17/{device}" for scene in scenes for device in ("gl-osmesa", "vk-lavapipe")]
        return dict(zip(ids, outcomes))

    def record(self, cell, out="out"):
        return self.path(out, "cells", cell + ".json")


class Selection(ConformTest):
    def test_list_shows_the_ids_of_the_whole_matrix(self):
        ids = self.listed()
        self.assertGreater(len(ids), 100)
        self.assertEqual(len(ids), len(set(ids)))
        for cell in ids:
            self.assertRegex(cell, r"^[a-z0-9._-]+/[a-z0-9._-]+/\d+x\d+/[a-z0-9._-]+$")
        result = self.ssrkit("conform", "--list", "--json", *TWO)
        self.assertEqual(ids, json.loads(result.out))
        self.assertFalse(os.path.exists(self.path("out")))

    def test_filters_and_excludes(self):
        ids = self.listed("--filter", "trace.bits/m2", "--exclude", "*/vk-lavapipe", "--exclude", "*/64x36")
        self.assertTrue(ids)
        for cell in ids:
            self.assertRegex(cell, r"^trace\.bits/m2/.*/gl-osmesa$")
        self.assertEqual(self.listed("--filter", "trace.bits/m2"),
                         self.listed("--filter", "trace.bits", "--scene", "m2"))

    def test_what_matches_nothing_is_an_error(self):
        for arguments in (["--filter", "trace.bit"], ["--exclude", "nothing*"], ["--filter", "*", "--filter", "x"]):
            self.assert_refused(self.ssrkit("conform", "--list", *TWO, *arguments), "no cell matches", arguments[0])
        self.assert_refused(self.ssrkit("conform", "--list", "--filter", "trace.bit"), "did you mean 'trace.bits'?")
        self.assert_refused(self.ssrkit("conform", *TWO, "--exclude", "*"), "no cell is left")
        self.assertFalse(os.path.exists(self.path("out")))

    def test_names_that_nobody_knows(self):
        self.assert_refused(self.ssrkit("conform", "--device", "gl-osmess"), "did you mean 'gl-osmesa'?")
        self.assert_refused(self.ssrkit("conform", "--optional", "x"), "the devices are")
        self.assert_refused(self.ssrkit("conform", "--scene", "m9"), "did you mean")
        self.assert_refused(self.ssrkit("conform", "--shard", "4/3"), "--shard")
        self.assert_refused(self.ssrkit("conform", "--rerun-failed", "nowhere"), "nowhere")
        self.assert_refused(self.ssrkit("conform", "--filtre", "x"), "did you mean '--filter'?")

    def test_a_seed_is_an_order(self):
        plain = self.listed()
        once, again, other = (self.listed("--shuffle", seed) for seed in (1, 1, 2))
        self.assertEqual(once, again)
        self.assertNotEqual(once, other)
        self.assertEqual(sorted(plain), sorted(other))

    def test_shards_are_disjoint_and_together_the_whole(self):
        parts = [self.listed("--shard", f"{index}/3") for index in (1, 2, 3)]
        for part in parts:
            self.assertGreater(len(part), 10)
        self.assertEqual(sorted(self.listed()), sorted(sum(parts, [])))


class Running(ConformTest):
    def test_two_devices(self):
        result = self.few()
        self.assert_exit(0, result)
        self.assert_closing_line(result)
        self.assertEqual(self.cells("pass", "pass", "pass", "pass"), self.outcomes())
        self.assertNotIn("\033", result.out)
        for line in result.out.splitlines():
            if not line.startswith("4 cells, written to"):
                self.assertLessEqual(len(line), 100, line)
        results = self.results()
        self.assertEqual({"gl-osmesa", "vk-lavapipe"}, {device["id"] for device in results["devices"]})
        crossed = [check for check in results["checks"] if check["id"] == "trace.bits.identical"]
        self.assertEqual({"vk-lavapipe"}, {check["device"] for check in crossed})
        self.assertEqual(sum(cell["checks"] for cell in results["cells"]), len(results["checks"]))
        names = self.assert_whole_files(self.path("out"))
        for name in ("cells/" + CELL + "/gl-osmesa.json", "junit.xml", "checks.csv", "report.html"):
            self.assertIn(name, names)
        rays = [entry for entry in results["ledger"] if entry["buffer"] == "hit" and entry["input"]]
        self.assertEqual({("gl-osmesa", "vk-lavapipe")}, {(entry["device"], entry["other"]) for entry in rays})
        for entry in rays:
            self.assertEqual((0, entry["compared"]), (entry["flips"], entry["identical"]))

    def test_the_reference_is_drawn_for_a_device_by_itself(self):
        result = self.conform("--device", "vk-lavapipe", "--filter", CELL, "--json")
        self.assert_exit(0, result)
        checks = json.loads(result.out)["checks"]
        self.assertEqual({"vk-lavapipe"}, {check["device"] for check in checks})
        self.assertIn("trace.bits.identical", {check["id"] for check in checks})

    def test_repeating(self):
        result = self.few("--repeat", "3", filters=[CELL])
        self.assert_exit(0, result)
        self.assertEqual({3}, {cell["attempts"] for cell in self.results()["cells"]})

    def test_an_absent_device_ends_the_run_unless_it_is_optional(self):
        absent = "vk-gpu"
        if absent not in self.ssrkit("devices").out:
            self.skipTest("the kit has no device for real drivers")
        required = self.conform("--device", "gl-osmesa", "--device", absent, "--filter", CELL)
        if required.code == 0:
            self.skipTest("this machine has a GPU")
        self.assert_refused(required, absent, code=3)
        result = self.conform("--device", "gl-osmesa", "--optional", absent, "--filter", CELL)
        self.assert_exit(0, result)
        self.assertIn(f"skipped: {absent}", result.out)
        self.assertEqual({f"{CELL}/gl-osmesa": "pass", f"{CELL}/{absent}": "skip"}, self.outcomes())

    def test_where_nothing_can_be_written(self):
        self.write("file", "mine")
        self.assert_refused(self.few(out="file"), "--out", code=3)


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


class Resuming(ConformTest):
    def test_only_what_is_missing_or_changed_is_run(self):
        self.assert_exit(0, self.few())
        whole = self.results()["checks"]
        kept, removed, damaged = (f"trace.bits/{name}" for name in
                                  ("m2/33x17/gl-osmesa", "m2/33x17/vk-lavapipe", "m4/33x17/gl-osmesa"))
        before = os.stat(self.record(kept)).st_mtime_ns
        os.remove(self.record(removed))
        self.write(self.record(damaged), '{"schema": "ssrkit-cell", "id": ')
        self.assert_exit(0, self.few("--resume"))
        self.assertEqual(before, os.stat(self.record(kept)).st_mtime_ns)
        self.assertEqual(whole, self.results()["checks"])
        # Without it everything is run again.
        self.assert_exit(0, self.few())
        self.assertNotEqual(before, os.stat(self.record(kept)).st_mtime_ns)

    def test_a_run_that_was_killed_goes_on(self):
        filters = ["*/33x17"]
        whole = self.few(filters=filters, out="whole")
        line = [kit.PROGRAM, "conform", *TWO, "--filter", "*/33x17", "--jobs", "1", "--out", "out"]
        process = subprocess.Popen(line, cwd=self.folder, env=kit.environment(), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + kit.PATIENCE_S
        finished = []
        while len(finished) < 3:
            finished = [name for _, _, names in os.walk(self.path("out/cells")) for name in names
                        if name.endswith(".json") and ".tmp" not in name]
            self.assertLess(time.monotonic(), deadline)
            self.assertIsNone(process.poll(), "it ended before it could be killed")
            time.sleep(0.01)
        process.kill()
        process.wait()
        self.assertFalse(os.path.exists(self.path("out/results.json")))
        records = {os.path.join(parent, name): os.stat(os.path.join(parent, name)).st_mtime_ns
                   for parent, _, names in os.walk(self.path("out/cells")) for name in names if ".tmp" not in name}
        result = self.few("--resume", filters=filters)
        self.assertEqual(whole.code, result.code, str(result))
        self.assertEqual(self.results("whole")["checks"], self.results()["checks"])
        for path, changed in records.items():
            self.assertEqual(changed, os.stat(path).st_mtime_ns, path)

    def test_failed_cells_are_run_again(self):
        self.assert_exit(1, self.few(env={"SSRKIT_FAULT": "wrong:vk-lavapipe trace.bits m2 33x17"}))
        result = self.conform(*TWO, "--rerun-failed", "out", out="again")
        self.assert_exit(0, result)
        self.assertEqual({f"{CELL}/vk-lavapipe": "pass"}, self.outcomes("again"))
        self.assert_refused(self.conform("--rerun-failed", "again", out="third"), "no cell of it failed")


class FullDisk(ConformTest):
    def setUp(self):
        super().setUp()
        self.disk = self.path("disk")
        os.mkdir(self.disk)
        mount = shutil.which("mount")
        command = [mount or "mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", self.disk]
        if not mount or subprocess.run(command, capture_output=True).returncode != 0:
            self.skipTest("a small file system cannot be mounted here")
        self.addCleanup(subprocess.run, ["umount", self.disk], check=True)

    def test_what_was_finished_stays_and_the_run_goes_on_where_there_is_room(self):
        filters = ["trace.bits"]
        out = self.disk + "/out"
        self.assert_refused(self.few(filters=filters, out=out), "No space left", code=3)
        finished = [os.path.join(out, name) for name in self.assert_whole_files(out) if name.startswith("cells/")]
        self.assertTrue(finished)
        self.assertFalse(os.path.exists(out + "/results.json"))
        changed = [os.stat(path).st_mtime_ns for path in finished]
        subprocess.run(["mount", "-o", "remount,size=64m", self.disk], check=True)
        self.assert_exit(0, self.few("--resume", filters=filters, out=out))
        self.assertEqual(changed, [os.stat(path).st_mtime_ns for path in finished])


class Merging(ConformTest):
    SHARDS = ("*/33x17",)

    def shards(self):
        whole = self.few(filters=self.SHARDS, out="whole")
        for index in (1, 2):
            self.few("--shard", f"{index}/2", filters=self.SHARDS, out=f"shard-{index}")
        return whole

    def test_two_shards_are_one_run(self):
        whole = self.shards()
        merged = self.ssrkit("conform", "merge", "shard-2", "shard-1", "--out", "merged")
        self.assertEqual(whole.code, merged.code, str(merged))
        self.assertEqual(whole.out.splitlines()[-1], merged.out.splitlines()[-1])
        self.assertEqual(self.results("whole")["checks"], self.results("merged")["checks"])
        self.assertEqual(self.outcomes("whole"), self.outcomes("merged"))
        self.assertTrue(self.results("whole")["ledger"])
        self.assertEqual(self.results("whole")["ledger"], self.results("merged")["ledger"])
        table = [line for line in whole.out.splitlines() if "written to" not in line]
        self.assertEqual(table, [line for line in merged.out.splitlines() if "written to" not in line])
        self.assert_whole_files(self.path("merged"))
        self.assert_missing_and_doubled_shards()

    def assert_missing_and_doubled_shards(self):
        alone = self.ssrkit("conform", "merge", "shard-1", "--out", "part")
        self.assert_exit(1, alone)
        self.assertIn("shard 2/2 is missing", alone.out)
        self.assertIn("missing", set(self.outcomes("part").values()))
        self.assert_refused(self.ssrkit("conform", "merge", "shard-1", "shard-1", "--out", "twice"),
                            "shard 1/2 comes twice")
        self.assert_refused(self.ssrkit("conform", "merge", "shard-1", "whole", "--out", "mixed"),
                            "another run")
        self.assert_refused(self.ssrkit("conform", "merge", "nowhere", "--out", "none"), "nowhere")
        one = sorted(name for name in os.listdir(self.path("shard-2", "cells", "trace.bits")))[0]
        os.remove(self.path("shard-2", "cells", "trace.bits", one, "33x17", "gl-osmesa.json"))
        hole = self.ssrkit("conform", "merge", "shard-1", "shard-2", "--out", "hole")
        self.assert_exit(1, hole)
        self.assertIn("shard 2/2 in shard-2 is not finished: 1 of its", hole.out)
        self.assertEqual("missing", self.outcomes("hole")[f"trace.bits/{one}/33x17/gl-osmesa"])


if __name__ == "__main__":
    kit.main()
