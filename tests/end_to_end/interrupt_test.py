"""Ctrl-C at any time: the workers end, no temporary file is left, what has a final name is whole."""

import os
import signal
import subprocess
import time

import kit

SOON_S = 20  # generous: machines are shared


class Interrupt(kit.KitTest):
    def start(self, *arguments, **variables):
        self.marker = f"SSRKIT_END_TO_END={os.getpid()}-{self.id()}-{time.monotonic_ns()}"
        name, value = self.marker.split("=")
        self.process = subprocess.Popen([kit.PROGRAM, "run", "--out", "out", *arguments], cwd=self.folder,
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


if __name__ == "__main__":
    kit.main()
