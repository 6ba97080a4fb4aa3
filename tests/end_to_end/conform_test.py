"""The conformance matrix: selection, what a run gives, shards."""

import json
import os

import kit
from conform_kit import CELL, TWO, ConformTest


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

    def test_an_absent_device_fails_unless_it_is_optional(self):
        absent = "vk-gpu"
        if absent not in self.ssrkit("devices").out:
            self.skipTest("the kit has no device for real drivers")
        required = self.conform("--device", "gl-osmesa", "--device", absent, "--filter", CELL)
        if required.code == 0:
            self.skipTest("this machine has a GPU")
        self.assert_refused(required, absent, code=3)
        result = self.conform("--device", "gl-osmesa", "--optional", absent, "--filter", CELL)
        self.assert_exit(0, result)
        self.assertIn(f"absent: {absent}", result.out)
        self.assertEqual({f"{CELL}/gl-osmesa": "pass", f"{CELL}/{absent}": "skip"}, self.outcomes())

    def test_where_nothing_can_be_written(self):
        self.write("file", "mine")
        self.assert_refused(self.few(out="file"), "--out", code=3)


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
