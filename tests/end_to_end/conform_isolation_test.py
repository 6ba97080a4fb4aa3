"""Whatever kills, stops or withholds a driver costs its own cells, and the rest of the run is complete."""

import glob
import os
import shutil
import signal
import subprocess
import time

import kit
from conform_kit import CELL, TWO, ConformTest

# Ends at once where loops are cut, and then changes nothing.
ENDLESS = """
  float x = load_dist_view(floor(gl_FragCoord.xy));
  uint turns = 0u;
  while (x > -1.0) {
    x = x * 0.5 + 1.0;
    turns += 1u;
  }
  hit.steps += turns == 0u ? 1 : 0;
"""


class Kills(ConformTest):
    FILTERS = ("trace.bits/m2/33x17", "trace.bits/m4/33x17")

    def kill_hanging(self, times):
        """Runs four cells, one of which hangs, and kills its worker so many times."""
        marker = self.path("hangs")
        fault = f"hang:vk-lavapipe trace.bits m2 33x17: draw trace_dda;once={marker}"
        line = [kit.PROGRAM, "conform", *TWO, "--jobs", "1", "--out", "out"]
        line += [word for pattern in self.FILTERS for word in ("--filter", pattern)]
        process = subprocess.Popen(line, cwd=self.folder, env=kit.environment(SSRKIT_FAULT=fault),
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + kit.PATIENCE_S
        for times_left in reversed(range(times)):
            while not os.path.exists(marker):
                self.assertLess(time.monotonic(), deadline)
                self.assertIsNone(process.poll(), "it ended before its worker could be killed")
                time.sleep(0.01)
            hanging = [pid for pid in kit.processes_with(f"once={marker}") if self.is_worker(pid, "vk-lavapipe")]
            self.assertEqual(1, len(hanging), hanging)
            if times_left:
                os.remove(marker)  # so that it hangs again
            os.kill(hanging[0], signal.SIGKILL)
        out = process.communicate(timeout=kit.PATIENCE_S)[0].decode()
        return kit.Result(process.returncode, out, "")

    @staticmethod
    def is_worker(pid, device):
        with open(f"/proc/{pid}/cmdline") as file:
            return file.read().split("\0")[1:3] == ["__worker", device]

    def test_a_worker_that_is_killed_once_costs_a_flake(self):
        result = self.kill_hanging(1)
        self.assert_exit(4, result)
        self.assertEqual(self.cells("pass", "flake", "pass", "pass"), self.outcomes())
        self.assertIn("was crash once", result.out)

    def test_a_worker_that_is_killed_again_alone_costs_its_cell(self):
        result = self.kill_hanging(2)
        self.assert_exit(1, result)
        self.assertEqual(self.cells("pass", "crash", "pass", "pass"), self.outcomes())
        self.assertIn("died of signal 9 while it was at: draw trace_dda", result.out)


class Hangs(ConformTest):
    def test_a_loop_that_ends_on_mesa_alone_is_a_timeout_of_the_other_driver(self):
        with open(f"{kit.SOURCE}/shaders/trace_dda.frag") as file:
            text = file.read().replace("  trace_end(hit);", ENDLESS + "  trace_end(hit);")
        devices = ("gl-osmesa", "vk-lavapipe", "vk-swiftshader")
        cells = (CELL, "trace.mips/clutter/63x35")
        line = [word for device in devices for word in ("--device", device)]
        line += [word for cell in cells for word in ("--filter", cell)]
        result = self.conform(*line, "--jobs", "1", "--run-limit", "3", env=self.kit_with("trace_dda.frag", text))
        self.assert_exit(1, result)
        expected = {f"{cell}/{device}": "pass" for cell in cells for device in devices}
        expected[f"{CELL}/vk-swiftshader"] = "timeout"
        self.assertEqual(expected, self.outcomes())
        self.assertIn("timeout(run)", result.out)
        self.assertIn("draw trace_dda", result.out)
        record = kit.read_json(self.record(f"{CELL}/vk-swiftshader"))
        self.assertEqual(2, record["attempts"], "it was run again alone")


class AbsentDrivers(ConformTest):
    """Runs in a file system of their own, in which a driver's manifest is not there."""

    DRIVER = "vk_swiftshader_icd.json"

    def without_driver(self, *arguments, out="out", before=(), stderr=subprocess.PIPE):
        found = glob.glob(f"/usr/lib/chromium/{self.DRIVER}")
        if not found:
            self.skipTest(f"there is no {self.DRIVER} to take away")
        empty = self.path("empty")
        os.makedirs(empty, exist_ok=True)
        script = f'mount --bind "{empty}" "{os.path.dirname(found[0])}" && exec "$0" "$@"'
        inside = ["unshare", "--mount", "sh", "-c", script]
        if not shutil.which("unshare") or subprocess.run([*inside, "true"], capture_output=True).returncode != 0:
            self.skipTest("no file system of one's own can be had here")
        line = [*inside, *before, kit.PROGRAM, "conform", "--device", "gl-osmesa", "--filter", CELL, "--jobs", "1",
                "--out", out]
        done = subprocess.run([*line, *arguments], cwd=self.folder, env=kit.environment(), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=stderr, timeout=kit.PATIENCE_S)
        return kit.Result(done.returncode, done.stdout.decode(), (done.stderr or b"").decode())

    def test_one_that_must_be_there_fails_and_the_others_go_on(self):
        result = self.without_driver("--device", "vk-swiftshader")
        self.assert_refused(result, "vk-swiftshader", "vk_swiftshader_icd*.json", "chromium-common", code=3)
        self.assert_closing_line(result)
        self.assertEqual({f"{CELL}/gl-osmesa": "pass", f"{CELL}/vk-swiftshader": "error"}, self.outcomes())
        self.assertIn(" 1 failed", result.out.splitlines()[-1])
        self.assert_exit(1, self.ssrkit("conform", "merge", "out", "--out", "merged"))
        self.assertEqual(self.outcomes(), self.outcomes("merged"))
        # As a terminal shows it: each line when it is printed.
        both = self.without_driver("--device", "vk-swiftshader", before=("stdbuf", "-oL"), stderr=subprocess.STDOUT)
        self.assertIn("ssrkit: could not use the device", both.out)
        self.assert_closing_line(both)
        # Where it is there again, what was not run is.
        self.assert_exit(0, self.conform("--device", "gl-osmesa", "--device", "vk-swiftshader", "--filter", CELL,
                                         "--resume"))

    def test_an_optional_one_is_skipped_with_the_reason(self):
        result = self.without_driver("--optional", "vk-swiftshader")
        self.assert_exit(0, result)
        self.assertIn("absent: vk-swiftshader: ", result.out)
        self.assertIn("vk_swiftshader_icd*.json", result.out)
        self.assertEqual({f"{CELL}/gl-osmesa": "pass", f"{CELL}/vk-swiftshader": "skip"}, self.outcomes())
        self.assert_exit(0, self.ssrkit("conform", "merge", "out", "--out", "merged"))
        self.assertEqual(self.outcomes(), self.outcomes("merged"))


if __name__ == "__main__":
    kit.main()
