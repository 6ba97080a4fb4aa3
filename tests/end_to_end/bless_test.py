"""bless: goldens are made by hand alone, and a buffer that drifts from its golden fails."""

import json
import os
import shutil
import subprocess

import kit

SMALL = """
[test]
id = "small"
about = "what is drawn stays what it was"
scenes = ["m2"]
sizes = ["32x18"]
devices = ["gl-osmesa"]
stages = ["dda"]

[[case]]
name = "mirror"
technique = "mirror"

[[expect]]
metric = "mean_lookups"
max = 1000

[[expect]]
name = "lit"
metric = "absolute_error"
buffer = "lit"
truth = "golden"
max = 0.01

[[expect]]
name = "composite_bits"
metric = "identical"
buffer = "composite"
truth = "golden"
stages = ["dda"]

[[expect]]
name = "hit"
metric = "different_rays"
truth = "golden"
"""


class BlessTest(kit.KitTest):
    """A kit of its own, with shaders, one test and goldens of its own."""

    def setUp(self):
        super().setUp()
        os.makedirs(self.path("kit"))
        shutil.copytree(os.path.join(kit.SOURCE, "shaders"), self.path("kit/shaders"))
        os.symlink(os.path.join(kit.SOURCE, "scenes"), self.path("kit/scenes"))
        self.write("kit/tests/expect/small.toml", SMALL)

    def bless(self, *arguments, why="it is the first", who="A Tester", **env):
        words = ["--why", why] if why is not None else []
        words += ["--who", who] if who is not None else []
        return self.ssrkit("bless", "small", *words, *arguments,
                           env={"SSRKIT_ROOT": self.path("kit"), "CI": "", **env})

    def judge(self):
        result = self.ssrkit("test", "--only", "expect", "--filter", "small", "--out", "out",
                             env={"SSRKIT_ROOT": self.path("kit")})
        checks = kit.read_json(self.path("out/results.json"))["checks"]
        return result, {check["id"]: check["outcome"] for check in checks}

    def goldens(self):
        found = []
        for parent, _, files in os.walk(self.path("kit/tests/goldens")):
            found += [os.path.relpath(os.path.join(parent, name), self.path("kit/tests/goldens")) for name in files]
        return sorted(found)

    def move_hits(self):
        """Changes the tracer: every hit is one texel aside."""
        path = self.path("kit/shaders/trace_dda.frag")
        with open(path) as file:
            text = file.read()
        end = "  trace_end(hit);"
        self.assertIn(end, text)
        with open(path, "w") as file:
            file.write(text.replace(end, "  if (hit.texel.x >= 0) hit.texel.x ^= 1;\n" + end))


class Goldens(BlessTest):
    def test_missing_ones_fail_and_are_not_made_on_the_way(self):
        result, outcomes = self.judge()
        self.assert_exit(1, result)
        self.assertEqual({"small.mean_lookups": "pass", "small.lit": "missing", "small.composite_bits": "missing",
                          "small.hit": "missing"}, outcomes)
        self.assertIn("./ssrkit bless small --scene m2 --device gl-osmesa --why", result.out)
        self.assertEqual([], self.goldens())

    def test_json_names_what_was_blessed(self):
        result = self.bless("--json")
        self.assert_exit(0, result)
        report = json.loads(result.out)
        self.assertEqual(("ssrkit-bless", 1, "small"), (report["schema"], report["schema_version"], report["test"]))
        self.assertEqual(["lit", "composite", "hit"], [golden["buffer"] for golden in report["goldens"]])
        for golden in report["goldens"]:
            self.assertEqual(("m2", [32, 18], "A Tester"), (golden["scene"], golden["size"], golden["who"]))
            self.assertTrue(os.path.isfile(self.path("kit", golden["file"])), golden)

    def test_blessed_ones_pass_until_something_drifts(self):
        result = self.bless()
        self.assert_exit(0, result)
        self.assertEqual(3, result.out.count("new"), str(result))
        self.assertIn("3 goldens blessed by A Tester", result.out)
        self.assertEqual(6, len(self.goldens()))
        self.assert_whole_files(self.path("kit/tests/goldens"))
        (sidecar,) = [name for name in self.goldens() if ".composite." in name and name.endswith(".json")]
        note = kit.read_json(self.path("kit/tests/goldens", sidecar))
        self.assertEqual(("A Tester", "it is the first", "llvmpipe"),
                         (note["who"], note["why"], note["key"]["rasteriser"]))
        self.assertIn("small.mean_lookups", note["metrics"])
        self.assertEqual({"parameters", "scene", "spirv"}, set(note["hashes"]))
        result, outcomes = self.judge()
        self.assert_exit(0, result)
        self.assertEqual({"pass"}, set(outcomes.values()))
        self.move_hits()  # what is lit stays as it was
        result, outcomes = self.judge()
        self.assert_exit(1, result)
        self.assertEqual(("pass", "fail", "fail"), tuple(outcomes["small." + name] for name in
                                                         ("lit", "composite_bits", "hit")))

    def test_shows_what_changes_before_it_is_written(self):
        self.assert_exit(0, self.bless())
        result = self.bless(why="nothing has changed")
        self.assert_exit(0, result)
        self.assertEqual(3, result.out.count("the same as before"), str(result))
        self.move_hits()
        result = self.bless(why="the mirror is another one now")
        self.assert_exit(0, result)
        self.assertEqual(1, result.out.count("the same as before"), str(result))
        self.assertRegex(result.out, r"dda mirror composite .*: \d+ of 576 texels change, by at most [\d.]+, at \(")
        self.assertEqual(6, len(self.goldens()))
        result, outcomes = self.judge()
        self.assertEqual({"pass"}, set(outcomes.values()), str(result))

    def test_another_devices_golden_serves_within_a_tolerance_and_not_for_bits(self):
        self.assert_exit(0, self.bless())
        self.write("kit/tests/expect/small.toml", SMALL.replace("gl-osmesa", "vk-lavapipe"))
        _, outcomes = self.judge()
        self.assertEqual(("pass", "missing"), (outcomes["small.lit"], outcomes["small.composite_bits"]))

    def test_a_damaged_golden_is_an_error(self):
        self.assert_exit(0, self.bless())
        (image,) = [name for name in self.goldens() if name.split("/")[-1].startswith("lit.") and ".exr" in name]
        with open(self.path("kit/tests/goldens", image), "r+b") as file:
            file.seek(-1, os.SEEK_END)
            file.write(b"x")
        result, outcomes = self.judge()
        self.assert_exit(1, result)
        self.assertEqual("error", outcomes["small.goldens"])
        self.assertIn("not the one that was blessed", result.out)


class Refusals(BlessTest):
    def assert_nothing_written(self):
        self.assertEqual([], self.goldens())

    def test_without_a_reason(self):
        self.assert_refused(self.bless(why=None), "--why")
        self.assert_refused(self.bless(why="  "), "there is no reason")
        self.assert_nothing_written()

    def test_in_ci(self):
        self.assert_refused(self.bless(CI="true"), "CI is set")
        self.assert_nothing_written()

    def test_without_a_name(self):
        self.assert_refused(self.bless(who=None, HOME=self.folder, GIT_CONFIG_NOSYSTEM="1", GIT_AUTHOR_NAME="",
                                       EMAIL="", XDG_CONFIG_HOME=self.folder), "--who")
        self.assert_nothing_written()

    def test_what_another_truth_calls_wrong(self):
        self.write("kit/tests/expect/small.toml", SMALL.replace("max = 1000", "max = 0.01"))
        self.assert_refused(self.bless(), "small.mean_lookups", "what is drawn is wrong")
        self.assert_nothing_written()

    def test_tests_without_goldens_and_scenes_of_other_tests(self):
        self.assert_refused(self.ssrkit("bless", "smal", "--why", "x", env={"SSRKIT_ROOT": self.path("kit")}),
                            "'smal'", "those that do are small")
        self.assert_refused(self.bless("--scene", "m1"), "no scene 'm1'", "m2")
        self.assert_nothing_written()

    def test_images_that_are_not_small(self):
        self.write("kit/tests/expect/small.toml", SMALL.replace("32x18", "161x90"))
        self.assert_refused(self.bless(), "161x90", "160x90")
        self.assert_nothing_written()

    def test_shaders_that_are_not_committed(self):
        git = shutil.which("git")
        if not git:
            self.skipTest("git is not installed")
        for words in (("init", "-q"), ("add", "."),
                      ("-c", "user.name=T", "-c", "user.email=t@localhost", "commit", "-q", "-m", "all")):
            subprocess.run([git, *words], cwd=self.path("kit"), check=True)
        self.move_hits()
        self.assert_refused(self.bless(), "shaders/trace_dda.frag", "not committed")
        self.assert_nothing_written()
        subprocess.run([git, "checkout", "-q", "."], cwd=self.path("kit"), check=True)
        self.assert_exit(0, self.bless())


if __name__ == "__main__":
    kit.main()
