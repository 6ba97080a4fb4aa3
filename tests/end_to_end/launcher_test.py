"""./ssrkit from anywhere: relative paths are the caller's, and a symbolic link does as well."""

import os
import shutil
import subprocess

import kit

LAUNCHER = os.path.join(kit.SOURCE, "ssrkit")


class Launcher(kit.KitTest):
    """In a tree of its own whose build has nothing to do: only the launcher's own words are tried."""

    def setUp(self):
        super().setUp()
        tree = self.path("tree")
        os.makedirs(tree + "/build/release/bin")
        os.makedirs(self.path("tools"))
        os.makedirs(self.path("elsewhere"))
        shutil.copy(LAUNCHER, tree)
        self.write("tree/packages.txt", "# none\n")
        self.write("tree/build/packages-installed", "")
        os.utime(tree + "/packages.txt", (0, 0))
        self.write("tree/build/release/build.ninja", "")
        os.symlink(kit.PROGRAM, tree + "/build/release/bin/ssrkit")
        self.write("tools/ninja", "#!/bin/sh\necho 'ninja: no work to do.'\n")
        os.chmod(self.path("tools/ninja"), 0o755)
        self.launcher = tree + "/ssrkit"

    def launch(self, *arguments, launcher=None):
        path = self.path("tools") + os.pathsep + os.environ.get("PATH", "")
        done = subprocess.run([launcher or self.launcher, *arguments], cwd=self.path("elsewhere"), capture_output=True,
                              env=kit.environment(PATH=path), timeout=kit.PATIENCE_S)
        return kit.Result(done.returncode, done.stdout.decode(), done.stderr.decode())

    def check_paths(self, launcher=None):
        self.write("elsewhere/mine.gltf", "")
        result = self.launch("run", "--scene", "mine.gltf", "--scene", "m2", "--stage", "dda", "--size", "16x9",
                             "--device", "gl-osmesa", "--out", "there", launcher=launcher)
        self.assert_exit(2, result)
        self.assertIn("the file is empty", result.out + result.err)
        self.assertTrue(os.path.exists(self.path("elsewhere/there/m2/camera.json")), str(result))

    def test_relative_paths_are_the_callers(self):
        self.check_paths()

    def test_through_a_symbolic_link(self):
        os.symlink("../tree/ssrkit", self.path("tools/kit"))
        os.symlink("kit", self.path("tools/kit2"))
        self.check_paths(launcher=self.path("tools/kit2"))

    def test_words_with_blanks_and_stars_arrive_whole(self):
        result = self.launch("run", "--scene", "a  b *.gltf")
        self.assert_refused(result, "'a  b *.gltf'")

    def test_exit_code_is_the_programs(self):
        self.assert_exit(0, self.launch("--version"))
        self.assert_exit(2, self.launch("run", "--size", "0x0"))

    def test_failing_build_is_told(self):
        self.write("tools/ninja", "#!/bin/sh\n[ \"$3\" = -n ] || { echo 'a.cpp:1:2: error: no'; exit 1; }\necho work\n")
        result = self.launch("devices")
        self.assert_exit(3, result)
        self.assertIn("a.cpp:1:2: error: no", result.err)
        self.assertIn("the build failed", result.err)


if __name__ == "__main__":
    kit.main()
