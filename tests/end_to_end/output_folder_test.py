"""Where nothing can be written the run ends with the reason, and leaves no half file."""

import os
import resource
import shutil
import subprocess

import kit


class WhereNothingCanBe(kit.KitTest):
    def test_under_a_file(self):
        self.write("file", "mine")
        self.assert_refused(self.trace(out="file/out"), "file/out", "--out", code=3)
        self.assert_refused(self.trace(out="file"), "file", "--out", code=3)
        with open(self.path("file")) as file:
            self.assertEqual("mine", file.read())

    def test_under_a_device_and_in_proc(self):
        self.assert_refused(self.trace(out="/dev/null/out"), "/dev/null/out", code=3)
        self.assert_refused(self.trace(out="/proc/ssrkit-out"), "/proc/ssrkit-out", code=3)

    def test_empty_name(self):
        self.assert_refused(self.trace(out=""), "--out", code=3)

    def test_name_that_is_too_long(self):
        self.assert_refused(self.trace(out="x" * 300), "--out", code=3)

    def test_folder_without_permission(self):
        os.mkdir(self.path("locked"), mode=0o555)
        if os.access(self.path("locked"), os.W_OK):
            self.skipTest("this user may write anywhere")
        self.assert_refused(self.trace(out="locked"), "locked", "--out", code=3)

    def test_a_folder_stands_where_a_file_belongs(self):
        os.makedirs(self.path("out/results.json"))
        self.assert_refused(self.trace(), "results.json", code=3)
        self.assert_whole_files(self.path("out"))


class Limits(kit.KitTest):
    def test_limit_on_file_sizes(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        result = self.trace(size="160x90", before=limit)
        self.assert_refused(result, code=3)
        self.assert_whole_files(self.path("out"))

    def test_limit_on_open_files(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_NOFILE, (24, 24))
        result = self.trace(before=limit)
        self.assertIn(result.code, (0, 1, 3), str(result))
        self.assertNotIn("terminate called", result.err)


class FullDisk(kit.KitTest):
    def setUp(self):
        super().setUp()
        self.disk = self.path("disk")
        os.mkdir(self.disk)
        mount = shutil.which("mount")
        command = [mount or "mount", "-t", "tmpfs", "-o", "size=256k", "tmpfs", self.disk]
        if not mount or subprocess.run(command, capture_output=True).returncode != 0:
            self.skipTest("a small file system cannot be mounted here")
        self.addCleanup(subprocess.run, ["umount", self.disk], check=True)

    def test_full_disk_is_named_and_nothing_is_half_written(self):
        result = self.trace(size="160x90", out=self.disk + "/out")
        self.assert_refused(result, "No space left", code=3)
        self.assert_whole_files(self.disk)
        self.assertFalse(os.path.exists(self.disk + "/out/results.json"))

    def test_read_only_disk(self):
        if subprocess.run(["mount", "-o", "remount,ro", self.disk], capture_output=True).returncode != 0:
            self.skipTest("a file system cannot be made read-only here")
        self.assert_refused(self.trace(out=self.disk), "Read-only", "--out", code=3)


class Overwriting(kit.KitTest):
    def test_a_second_run_replaces_the_first_and_spares_what_is_not_its_own(self):
        self.assert_exit(0, self.trace())
        self.write("out/mine.json", "{}")
        self.assert_exit(0, self.trace())
        self.assertIn("mine.json", self.assert_whole_files(self.path("out")))


if __name__ == "__main__":
    kit.main()
