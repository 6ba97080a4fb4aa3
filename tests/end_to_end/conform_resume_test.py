"""Conformance runs that were stopped go on."""

import os
import shutil
import subprocess
import time

import kit
from conform_kit import CELL, TWO, ConformTest

GOLDEN = """
[test]
id = "small"
about = "what is drawn stays what it was"
scenes = ["m2"]
sizes = ["32x18"]
devices = ["gl-osmesa"]
stages = ["dda"]

[[expect]]
metric = "mean_lookups"
max = 1000

[[expect]]
name = "hit"
metric = "different_rays"
truth = "golden"
"""


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

    def test_a_golden_that_is_blessed_meanwhile_is_seen(self):
        for folder in ("scenes", "shaders"):
            os.makedirs(self.path("kit"), exist_ok=True)
            os.symlink(os.path.join(kit.SOURCE, folder), self.path("kit", folder))
        for folder in ("expect", "conform"):
            self.write(f"kit/tests/{folder}/small.toml", GOLDEN)
        self.write("kit/tests/known_failures.toml", "")
        root = {"SSRKIT_ROOT": self.path("kit"), "CI": ""}
        self.assert_exit(1, self.conform(*TWO[:2], env=root))
        self.assertEqual({"small/m2/32x18/gl-osmesa": "missing"}, self.outcomes())
        self.assert_exit(0, self.ssrkit("bless", "small", "--why", "it is the first", "--who", "A Tester", env=root))
        self.assert_exit(0, self.conform(*TWO[:2], "--resume", env=root))
        self.assertEqual({"small/m2/32x18/gl-osmesa": "pass"}, self.outcomes())

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


if __name__ == "__main__":
    kit.main()
