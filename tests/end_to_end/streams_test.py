"""What is printed goes where it is to go, or the program says that it did not."""

import os
import subprocess

import kit

SHADER = "shaders/full_screen.vert"


class Output(kit.KitTest):
    def run_into(self, stdout, *arguments, **options):
        return subprocess.run([kit.PROGRAM, *arguments], stdin=subprocess.DEVNULL, stdout=stdout, cwd=self.folder,
                              env=kit.environment(), timeout=kit.PATIENCE_S, **options)

    def into_full_disk(self, *arguments):
        with open("/dev/full", "wb") as full:
            done = self.run_into(full, *arguments, stderr=subprocess.PIPE)
        return kit.Result(done.returncode, "", done.stderr.decode())

    def test_a_full_disk_is_told(self):
        shader = os.path.join(kit.SOURCE, SHADER)
        for arguments in (["compile", shader], ["compile", shader, "--json"], ["test", "--list", "--only", "expect"],
                          ["--help"]):
            with self.subTest(arguments):
                result = self.into_full_disk(*arguments)
                self.assert_exit(3, result)
                self.assertIn("No space left", result.err)
                self.assertEqual(1, result.err.count("ssrkit: "), str(result))

    def test_a_reader_that_goes_away_is_no_failure(self):
        ours, theirs = os.pipe()
        os.close(ours)
        with os.fdopen(theirs, "wb") as pipe:
            done = self.run_into(pipe, "compile", os.path.join(kit.SOURCE, SHADER), stderr=subprocess.PIPE)
        self.assertEqual((0, b""), (done.returncode, done.stderr))

    def test_the_closing_line_comes_after_every_error(self):
        self.write("bad.gltf", "{}")
        done = self.run_into(subprocess.PIPE, "run", "--scene", "bad.gltf", "--scene", "m2", "--stage", "dda",
                             "--device", "gl-osmesa", "--size", "32x18", stderr=subprocess.STDOUT)
        text = done.stdout.decode()
        self.assertIn("ssrkit: ", text)
        self.assertRegex(text.splitlines()[-1], kit.CLOSING_LINE)


if __name__ == "__main__":
    kit.main()
