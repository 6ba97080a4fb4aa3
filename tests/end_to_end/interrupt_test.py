"""Ctrl-C at any time: every child ends, no temporary file is left, what has a final name is whole."""

import os
import signal
import subprocess
import time

import kit

SOON_S = 20  # generous: machines are shared

BATTERY = """
[test]
id = "small"
about = "the walk finds the wall of m1, in its row"
scenes = ["m1"]
sizes = ["32x32"]
stages = ["walk"]

[[expect]]
name = "formula"
metric = "closed_form"
"""

MUTANT = """
about = "no ray hits"
signature = "no hit"
killed_by = "small.formula"
file = "shaders/include/ssr_march_walk.glsl"
replace = "is_hit = column_overlaps("
with = "is_hit = false && column_overlaps("
"""

WHEAT = """
about = "the same sum"
file = "shaders/include/ssr_march_walk.glsl"
replace = "vec2 direction = 2.0 * far_edge - 1.0;"
with = "vec2 direction = far_edge + far_edge - 1.0;"
"""


class Started(kit.KitTest):
    def start(self, *arguments, command="run", **variables):
        self.marker = f"SSRKIT_END_TO_END={os.getpid()}-{self.id()}-{time.monotonic_ns()}"
        name, value = self.marker.split("=")
        self.process = subprocess.Popen([kit.PROGRAM, command, "--out", "out", *arguments], cwd=self.folder,
                                        env=kit.environment(**{name: value}, **variables), stdin=subprocess.DEVNULL,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
        self.addCleanup(self.process.stdout.close)
        self.addCleanup(self.process.stderr.close)
        self.addCleanup(self.process.kill)

    def wait_until(self, is_so, what):
        deadline = time.monotonic() + kit.PATIENCE_S
        while not is_so():
            self.assertLess(time.monotonic(), deadline, f"{what} never came")
            self.assertIsNone(self.process.poll(), f"the run ended before {what}")
            time.sleep(0.005)

    def files(self):
        return [os.path.join(parent, name) for parent, _, names in os.walk(self.path("out")) for name in names]

    def end_with(self, number):
        self.process.send_signal(number)
        out, err = self.process.communicate(timeout=SOON_S)
        self.assertEqual(128 + number, self.process.returncode, err.decode())
        self.assertIn("interrupted", err.decode())
        deadline = time.monotonic() + SOON_S
        while kit.processes_with(self.marker) and time.monotonic() < deadline:
            time.sleep(0.05)  # killed processes take a moment to go
        self.assertEqual([], kit.processes_with(self.marker), "processes are left")
        self.assert_whole_files(self.path("out"))


class Interrupt(Started):
    def test_while_workers_start(self):
        self.start("--size", "64x36")
        self.wait_until(lambda: len(kit.processes_with(self.marker)) > 1, "a worker")
        self.end_with(signal.SIGINT)

    def test_while_a_worker_is_at_a_job(self):
        self.start("--size", "64x36", "--scene", "m2", SSRKIT_FAULT="hang:draw trace")
        self.wait_until(lambda: os.path.isdir(self.path("out")), "the folder")
        time.sleep(1.0)
        self.end_with(signal.SIGINT)

    def test_while_a_worker_spins(self):
        self.start("--size", "64x36", "--scene", "m2", SSRKIT_FAULT="spin:draw gbuffer")
        self.wait_until(lambda: len(kit.processes_with(self.marker)) > 1, "a worker")
        time.sleep(1.0)
        self.end_with(signal.SIGTERM)

    def test_while_files_are_written(self):
        self.start("--size", "160x90")
        self.wait_until(lambda: any(".tmp" in name for name in self.files()), "a file being written")
        self.end_with(signal.SIGINT)

    def test_after_some_files_are_written(self):
        self.start("--size", "64x36")
        self.wait_until(lambda: len([name for name in self.files() if ".tmp" not in name]) > 8, "a file")
        self.end_with(signal.SIGHUP)
        self.assertFalse(os.path.exists(self.path("out/results.json")))

    def test_killed_outright_leaves_no_worker(self):
        self.start("--size", "64x36", "--scene", "m2", SSRKIT_FAULT="hang:draw gbuffer")
        self.wait_until(lambda: len(kit.processes_with(self.marker)) > 2, "two workers")
        self.process.kill()
        self.process.wait()
        deadline = time.monotonic() + SOON_S
        while kit.processes_with(self.marker) and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertEqual([], kit.processes_with(self.marker), "workers outlive their supervisor")


# In the place of CTest: it starts a program that never ends, and waits for it.
CTEST = """#!/bin/sh
sleep 1000 &
sleep 1000
"""

# It fails, and its report knows of no failure.
BROKEN_CTEST = """#!/bin/sh
while [ "$1" != --output-junit ]; do shift; done
echo '<testsuite name="x" tests="1" failures="0" disabled="0" skipped="0">' > "$2"
exit 7
"""


def with_ctest(test, text):
    """The PATH in which `text` is CTest."""
    os.chmod(test.write("bin/ctest", text), 0o755)
    return test.path("bin") + ":" + os.environ["PATH"]


class Children(Started):
    def test_what_a_child_has_started_ends_too(self):
        self.start("--only", "unit", command="test", PATH=with_ctest(self, CTEST))
        self.wait_until(lambda: len(kit.processes_with(self.marker)) >= 4, "the child's own children")
        self.end_with(signal.SIGTERM)

    def scratch(self):
        return os.listdir(self.path("tmp"))

    def start_mutate(self):
        os.makedirs(self.path("tmp"))
        os.makedirs(self.path("kit", "tests"))
        for folder in ("shaders", "scenes", "harness"):
            os.symlink(os.path.join(kit.SOURCE, folder), self.path("kit", folder))
        self.write("kit/tests/mutants/battery/small.toml", BATTERY)
        self.write("kit/tests/mutants/blind.toml", MUTANT)
        self.write("kit/tests/wheats/same.toml", WHEAT)
        self.start(command="mutate", SSRKIT_ROOT=self.path("kit"), TMPDIR=self.path("tmp"),
                   SSRKIT_FAULT="hang:draw trace")
        self.wait_until(lambda: any(os.listdir(self.path("tmp", name)) for name in self.scratch()), "a scratch folder")

    def assert_no_scratch(self):
        deadline = time.monotonic() + SOON_S
        while self.scratch() and time.monotonic() < deadline:
            time.sleep(0.05)
        self.assertEqual([], self.scratch())

    def test_scratch_folders_go(self):
        self.start_mutate()
        self.end_with(signal.SIGINT)
        self.assert_no_scratch()

    def test_scratch_folders_go_when_it_is_killed_outright(self):
        self.start_mutate()
        self.process.kill()
        self.process.wait()
        self.assert_no_scratch()


class IgnoredChildren(kit.KitTest):
    """Whoever starts the program may ignore SIGCHLD; then the system keeps no exit code for it."""

    def ignoring(self, *arguments, **variables):
        return self.ssrkit(*arguments, env=variables, before=lambda: signal.signal(signal.SIGCHLD, signal.SIG_IGN))

    def test_a_child_that_fails_is_no_success(self):
        result = self.ignoring("test", "--only", "unit", PATH=with_ctest(self, BROKEN_CTEST))
        self.assert_refused(result, "ctest ended with 7", code=3)

    def test_shaders_compile(self):
        self.assert_exit(0, self.ignoring("compile", os.path.join(kit.SOURCE, "shaders/full_screen.vert"),
                                          XDG_CACHE_HOME=self.path("cache")))


if __name__ == "__main__":
    kit.main()
