"""mutate: mistakes that are noticed, one that is not, changes that are none, and files that say nothing."""

import csv
import json
import os

import kit

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

[[expect]]
metric = "finite"
"""

SHARED = {"about": "for this test", "signature": "wrong rows", "killed_by": "small.formula"}
WALK = "shaders/include/ssr_march_walk.glsl"
NO_RAY_HITS = SHARED | {"file": WALK, "replace": "is_hit = column_overlaps(", "with": "is_hit = false && column_overlaps("}
ASTRAY = SHARED | {"file": WALK, "replace": "cell += s_edges.x <= s_edges.y ?", "with": "cell += s_edges.x > s_edges.y ?"}
SURVIVOR = SHARED | {"file": WALK, "replace": "vec2 direction = 2.0 * far_edge - 1.0;",
                     "with": "vec2 direction = far_edge + far_edge - 1.0;"}
RANK = {"about": "for this test", "signature": "one rank too low", "file": "harness/check/percentile.cpp",
        "killed_by": "HitPosition.TheLargestOrAPercentileOfTheDistance",
        "replace": "std::ceil(percentile / 100.0 * count)", "with": "std::floor(percentile / 100.0 * count)"}


def wheat_of(mutant):
    return {key: value for key, value in mutant.items() if key not in ("signature", "killed_by")}


class MutateTest(kit.KitTest):
    def setUp(self):
        super().setUp()
        # A kit of its own, with mutants of its own.
        os.makedirs(self.path("kit", "tests"))
        for folder in ("shaders", "scenes", "harness"):
            os.symlink(os.path.join(kit.SOURCE, folder), self.path("kit", folder))
        self.write("kit/tests/mutants/battery/small.toml", BATTERY)

    def mutate(self, *arguments, mutants, wheats):
        for kind, files in (("mutants", mutants), ("wheats", wheats)):
            for name, keys in files.items():
                text = "".join(f"{key} = {json.dumps(value)}\n" for key, value in keys.items())
                self.write(f"kit/tests/{kind}/{name}.toml", text)
        return self.ssrkit("mutate", "--out", "out", *arguments, env={"SSRKIT_ROOT": self.path("kit")})


class Scores(MutateTest):
    def test_mistakes_are_noticed_and_a_wheat_is_not(self):
        result = self.mutate(mutants={"blind": NO_RAY_HITS, "astray": ASTRAY}, wheats={"same": wheat_of(SURVIVOR)})
        self.assert_exit(0, result)
        self.assertIn("Score: 2 of 2 mutants killed (100.0 %), 0 of 1 wheats rejected", result.out)
        self.assertEqual("4 passed, 0 failed", result.out.splitlines()[-1])  # the kit itself is the fourth
        self.assertIn("Notice no mutant: small.finite", result.out)
        with open(self.path("out", "kill_matrix.csv"), newline="") as file:
            rows = {row["name"]: row for row in csv.DictReader(file)}
        self.assertEqual(("1", "0"), (rows["blind"]["small.formula"], rows["blind"]["small.finite"]))
        self.assertEqual("0", rows["same"]["small.formula"])
        self.assertTrue(os.path.getsize(self.path("out", "report.html")) > 1000)

    def test_a_survivor_is_named_and_fails(self):
        result = self.mutate(mutants={"blind": NO_RAY_HITS, "lives": SURVIVOR}, wheats={"same": wheat_of(SURVIVOR)})
        self.assert_exit(1, result)
        self.assertIn("SURVIVED lives", result.out)
        self.assertIn("Survivors: lives", result.out)
        self.assertEqual("3 passed, 1 failed", result.out.splitlines()[-1])

    def test_a_wheat_that_is_wrong_is_rejected_with_what_was_noticed(self):
        result = self.mutate("--json", mutants={"blind": NO_RAY_HITS}, wheats={"wrong": wheat_of(ASTRAY)})
        self.assert_exit(1, result)
        report = json.loads(result.out)
        self.assertEqual((1, 1, 1, 1),
                         (report["mutants"], report["killed"], report["wheats"], report["rejected"]))
        wrong = next(run for run in report["runs"] if run["name"] == "wrong")
        self.assertIn("pixels on m1 32x32 walk", wrong["complaints"]["small.formula"])

    def test_a_mistake_of_the_comparison_is_built_and_noticed_by_its_unit_test(self):
        result = self.mutate("--filter", "r*", mutants={"rank": RANK, "blind": NO_RAY_HITS},
                             wheats={"same": wheat_of(SURVIVOR)})
        self.assert_exit(0, result)
        self.assertIn("by HitPosition.TheLargestOrAPercentileOfTheDistance", result.out)
        self.assertNotIn("blind", result.out)


class BadFiles(MutateTest):
    def refused(self, changes, *words, filter="*"):
        mutant = {key: value for key, value in (NO_RAY_HITS | changes).items() if value is not None}
        result = self.mutate("--filter", filter, mutants={"blind": mutant}, wheats={"same": wheat_of(SURVIVOR)})
        self.assert_refused(result, *words)
        self.assertFalse(os.path.exists(self.path("out")))

    def test_an_edit_must_fit_once(self):
        self.refused({"replace": "no such text"}, "0 times", "blind.toml")
        self.refused({"replace": "ray"}, "times", "blind.toml")

    def test_the_check_foretold_must_exist(self):
        self.refused({"killed_by": "small.formla"}, "no check 'small.formla'", "small.formula")

    def test_keys_are_checked(self):
        self.refused({"signature": None}, "signature")
        self.refused({"kiled_by": "small.formula"}, "kiled_by")

    def test_a_filter_that_matches_nothing_is_an_error(self):
        self.refused({}, "no mutant or wheat matches 'x*'", filter="x*")


class TheKits(kit.KitTest):
    def test_every_mutant_and_wheat_is_listed(self):
        result = self.ssrkit("mutate", "--list")
        self.assert_exit(0, result)
        listed = {line.split()[1] for line in result.out.splitlines()}
        files = [name for kind in ("mutants", "wheats") for name in os.listdir(os.path.join(kit.SOURCE, "tests", kind))]
        self.assertEqual({name.removesuffix(".toml") for name in files if name.endswith(".toml")}, listed)

    def test_some_come_out_as_foretold(self):
        """One of each kind; all of them take minutes: ./ssrkit mutate."""
        for name in ("hiz_own_texel_tested", "upsample_nearest", "resolve_with_a_branch"):
            with self.subTest(name):
                result = self.ssrkit("mutate", "--filter", name, "--out", "out")
                self.assert_exit(0, result)
                self.assertEqual("2 passed, 0 failed", result.out.splitlines()[-1])


if __name__ == "__main__":
    kit.main()
