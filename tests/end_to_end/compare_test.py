"""compare: claims by name, their verdicts, and what a claim file must hold."""

import json
import os
import shutil
import tomllib

import kit

CLAIMS = os.path.join(kit.SOURCE, "tests", "claims")

# Claims whose figures are counts, the same on every machine, and that take seconds.
DETERMINISTIC = ("bisection_is_cheap", "screen_space_sampling")

SMALL = """
[claim]
source = "this test"
says = "rays are cheap"
finding = "confirmed"
if_refuted = "They are not."

[test]
id = "small"
about = "a ray of the DDA makes at most 1000 lookups"
scenes = ["m2"]
sizes = ["32x18"]
stages = ["dda"]

[[expect]]
metric = "mean_lookups"
max = 1000
refuted_above = 2000
"""


class CompareTest(kit.KitTest):
    def setUp(self):
        super().setUp()
        # A kit of its own, with claims of its own.
        os.makedirs(self.path("kit", "tests", "claims"))
        for folder in ("shaders", "scenes"):
            os.symlink(os.path.join(kit.SOURCE, folder), self.path("kit", folder))

    def compare(self, *arguments, **claims):
        for name, content in claims.items():
            self.write(f"kit/tests/claims/{name}.toml", content)
        return self.ssrkit("compare", "--out", "out", *arguments, env={"SSRKIT_ROOT": self.path("kit")})


class Claims(kit.KitTest):
    def test_every_claim_is_listed_with_its_source(self):
        result = self.ssrkit("compare", "--list")
        self.assert_exit(0, result)
        listed = {line.split()[0] for line in result.out.splitlines()}
        files = {name.removesuffix(".toml") for name in os.listdir(CLAIMS)}
        self.assertEqual(files, listed)
        self.assertIn("(Deliot, 2018)", result.out)

    def test_deterministic_claims_come_out_as_noted(self):
        arguments = [word for name in DETERMINISTIC for word in ("--claim", name)]
        result = self.ssrkit("compare", "--device", "gl-osmesa", "--json", *arguments)
        self.assert_exit(0, result)
        claims = json.loads(result.out)["claims"]
        self.assertEqual(list(DETERMINISTIC), [claim["name"] for claim in claims])
        for claim in claims:
            with open(os.path.join(CLAIMS, claim["name"] + ".toml"), "rb") as file:
                noted = tomllib.load(file)["claim"]["finding"]
            self.assertEqual(noted, claim["verdict"], claim["why"])


class Names(CompareTest):
    def test_unknown_claim_is_named_with_the_nearest(self):
        self.assert_refused(self.compare("--claim", "smal", small=SMALL), "there is no claim 'smal'",
                            "did you mean 'small'?")
        self.assert_refused(self.compare("--claim", "quite_another"), "quite_another", "the claims are small")
        self.assertFalse(os.path.exists(self.path("out")))

    def test_unknown_device(self):
        self.assert_refused(self.compare("--device", "gl-osmessa", small=SMALL), "gl-osmessa",
                            "did you mean 'gl-osmesa'?")
        self.assertFalse(os.path.exists(self.path("out")))


class Verdicts(CompareTest):
    def test_confirmed(self):
        result = self.compare(small=SMALL)
        self.assert_exit(0, result)
        self.assert_closing_line(result)
        self.assertIn("small: confirmed\n", result.out)
        self.assertIn("1 confirmed\n", result.out)
        self.assertNotIn("\x1b", result.out + result.err)
        for line in result.out.splitlines():
            self.assertLessEqual(len(line), 100, line)
        self.assertEqual("confirmed", kit.read_json(self.path("out/claims.json"))["claims"][0]["verdict"])

    def test_refuted_is_a_finding_and_no_failure(self):
        result = self.compare("--device", "gl-osmesa",
                              small=SMALL.replace("max = 1000", "max = 0.1").replace("above = 2000", "above = 0.2"))
        self.assert_exit(0, result)
        self.assertIn("small: refuted\n", result.out)
        self.assertIn("They are not.", result.out)
        self.assertIn("the claim's file says confirmed", result.out)
        self.assertIn("./ssrkit compare --claim small --device gl-osmesa", result.out)
        self.assertTrue(result.out.endswith("1 passed, 0 failed\n"), str(result))

    def test_between_the_bounds_is_inconclusive(self):
        result = self.compare("--device", "gl-osmesa", small=SMALL.replace("max = 1000", "max = 0.1"))
        self.assert_exit(4, result)
        self.assertIn("small: inconclusive\n", result.out)

    def test_a_timing_too_noisy_to_judge_is_measured_once_more(self):
        # Fewer than eight rounds never settle a ratio; twice four can.
        timed = SMALL.replace('stages = ["dda"]', 'stages = ["dda"]\nrounds = 4') \
            .replace('"mean_lookups"', '"pass_cpu_share"\npasses = ["trace"]\nover = ["trace"]') \
            .replace("max = 1000", "max = 1.5")
        result = self.compare("--device", "gl-osmesa", "--json", small=timed)
        self.assert_exit(0, result)
        self.assertIn("median of 8 interleaved rounds 1,", result.out)

    def test_a_worker_that_dies_leaves_it_unknown(self):
        self.write("kit/tests/claims/small.toml", SMALL)
        result = self.ssrkit("compare", "--out", "out", "--device", "gl-osmesa",
                             env={"SSRKIT_ROOT": self.path("kit"), "SSRKIT_FAULT": "crash:draw trace_dda"})
        self.assert_exit(1, result)
        self.assertIn("small: not measured\n", result.out)
        self.assertIn("draw trace_dda", result.out)
        self.assertTrue(result.out.endswith("0 passed, 1 failed\n"), str(result))

    def test_json_is_the_file(self):
        result = self.compare("--json", "--device", "gl-osmesa", small=SMALL)
        self.assert_exit(0, result)
        self.assertEqual(json.loads(result.out), kit.read_json(self.path("out/claims.json")))
        self.assert_whole_files(self.path("out"))


class BadFiles(CompareTest):
    def test_what_is_wrong_is_named_with_its_place(self):
        for change, words in (
                (("says =", "sayz ="), ("small.toml:4:1", "did you mean 'says'?")),
                (("finding = \"confirmed\"", "finding = \"true\""), ("small.toml:5:", "'true'", "confirmed")),
                (("mean_lookups", "mean_lockups"), ("small.toml:16:10", "did you mean 'mean_lookups'?")),
                (("refuted_above = 2000", "refuted_above = 5"), ("small.toml:18:", "could confirm and refute")),
                (("refuted_above = 2000", ""), ("nothing refutes",)),
                (("scenes = [\"m2\"]", "scenes = [\"m22\"]"), ("did you mean 'm2'?",)),
                (("id = \"small\"", "id = \"large\""), ("large", "another name", "large.toml")),
                (("[claim]", "[claim"), ("small.toml:2:",)),
                (("[claim]", ""), ("small.toml",))):
            with self.subTest(change):
                self.assertIn(change[0], SMALL)
                self.assert_refused(self.compare(small=SMALL.replace(*change)), *words)
                self.assertFalse(os.path.exists(self.path("out")))

    def test_no_claims_at_all(self):
        self.assert_refused(self.compare(), "no .toml file", os.path.join("tests", "claims"))
        shutil.rmtree(self.path("kit/tests"))
        self.assert_refused(self.compare(), os.path.join("tests", "claims"))


if __name__ == "__main__":
    kit.main()
