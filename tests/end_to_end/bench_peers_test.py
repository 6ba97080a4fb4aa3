"""bench --peer: somebody else's shaders, right and wrong."""

import os

import bench_runs
import kit


class PeerTest(bench_runs.BenchTest):
    def peer(self, name, *change, shader_change=None):
        """A copy of one of the kit's peers, with a text changed in its file or in its shader."""
        source = os.path.join(kit.SOURCE, "tests", "peers")
        with open(os.path.join(source, name + ".toml")) as file:
            toml = file.read()
        shader = next(word for word in toml.split('"') if word.endswith((".frag", ".hlsl")))
        with open(os.path.join(source, shader)) as file:
            code = file.read()
        for old, new in (change,) if change else ():
            self.assertIn(old, toml)
            toml = toml.replace(old, new)
        for old, new in (shader_change,) if shader_change else ():
            self.assertIn(old, code)
            code = code.replace(old, new)
        self.write(f"peers/{shader}", code)
        return self.write(f"peers/{name}.toml", toml)

    def answers(self, *peers, device="gl-osmesa"):
        arguments = [word for peer in peers for word in ("--peer", peer)]
        result = self.bench(*arguments, "--param", "thickness_m=0.3", "--param", "max_distance_m=20", scene="clutter",
                            size="160x90", rounds=1, device=device)
        self.assert_exit(0, result)
        for line in result.out.splitlines():
            self.assertLessEqual(len(line), 100, line)
        return {answer["stage"]: answer for answer in self.report()["answers"]}


def same(answer):
    return (answer["verdicts"]["SAME"] + answer["verdicts"]["AMBIGUOUS"]) / answer["rays"]


class Peers(PeerTest):
    def test_a_right_march_is_right_in_either_language_and_convention_on_either_api(self):
        for device in kit.DEVICES:
            answers = self.answers(self.peer("texel_march"), self.peer("texel_march_hlsl"), device=device)
            self.assertEqual({"walk", "texel_march", "texel_march_hlsl"}, set(answers))
            self.assertEqual(1.0, same(answers["walk"]))
            for name in ("texel_march", "texel_march_hlsl"):
                self.assertGreater(same(answers[name]), 0.99, answers[name])
                # It looks where the walk looks.
                self.assertAlmostEqual(1.0, answers[name]["lookups"]["mean"] / answers["walk"]["lookups"]["mean"],
                                       delta=0.02)

    def test_a_march_through_the_mips_of_its_depth_is_right_in_fewer_lookups(self):
        for device in kit.DEVICES:
            answers = self.answers(self.peer("cell_march"), device=device)
            self.assertGreater(same(answers["cell_march"]), 0.999, answers["cell_march"])
            self.assertLess(answers["cell_march"]["lookups"]["mean"], 0.5 * answers["walk"]["lookups"]["mean"])
            passes = {series["pass"] for series in self.report()["series"] if series["stage"] == "cell_march"}
            self.assertIn("peer_mips", passes)

    def test_mips_of_the_wrong_kind_or_none_are_seen(self):
        for change in (('"nearest"', '"farthest"'), ('mips = "nearest"\n', "")):
            answers = self.answers(self.peer("cell_march", *change))
            self.assertLess(same(answers["cell_march"]), 0.7, change)

    def test_a_thickness_of_the_wrong_sign_is_seen(self):
        for name, sign in (("texel_march", ("surface + thickness", "surface - thickness")),
                           ("texel_march_hlsl", ("surface + Thickness", "surface - Thickness"))):
            answers = self.answers(self.peer(name, shader_change=sign))
            self.assertLess(same(answers[name]), 0.9, answers[name])
            self.assertGreater(answers[name]["mask_errors"], 0.02 * answers[name]["rays"])

    def test_a_wrong_convention_is_seen(self):
        for change in (("uv_upwards", "uv"), ("window_reversed", "window"), ('"unsigned"', '"signed"')):
            answers = self.answers(self.peer("texel_march", change[0], change[1]))
            self.assertLess(same(answers["texel_march"]), 0.9, change)

    def test_a_mask_is_judged_as_one(self):
        answers = self.answers(self.peer("texel_march", "uv_upwards", "mask"))
        self.assertLess(answers["texel_march"]["mask_errors"], 0.01 * answers["texel_march"]["rays"])


class BadPeers(PeerTest):
    def test_what_is_wrong_with_its_file_is_named_with_its_place(self):
        for change, words in ((("[reads]", "[reeds]"), ("texel_march.toml:6:", "reeds", "reads")),
                              (("window_reversed", "reversed"), (".toml:7:9", "'reversed'", "window_reversed")),
                              (('depth = "window_reversed"', 'mips = "least"'), (".toml:7:8", "'least'", "nearest")),
                              (('depthTex = "depth"', 'depthTex = "deepth"'), ("did you mean 'depth'?",)),
                              (('hit = "w"', 'hit = "q"'), ("'q'", "x")),
                              (('hit = "w"', ""), ("hit",)),
                              (('name = "texel_march"', 'name = "hiz"'), ("kit's own stages",)),
                              (('reach = "max_distance_m"', "reach = true"), ("reach", "a number")),
                              (('reach = "max_distance_m"', "reach = 4294967296"), (".toml:", "'reach'", "2147483647")),
                              (("[peer]", "[peer"), ("texel_march.toml:1",))):
            with self.subTest(change):
                self.assert_refused(self.bench("--peer", self.peer("texel_march", *change)), *words)
        self.assert_refused(self.bench("--peer", "absent.toml"), "absent.toml")

    def refused_later(self, peer, *words):
        self.assert_refused(self.bench("--peer", peer, rounds=1), *words)

    def test_what_is_wrong_with_its_shader_is_a_sentence(self):
        self.refused_later(self.peer("texel_march", "depthTex =", "depthMap ="), "no sampler called 'depthMap'",
                           "did you mean 'depthTex'?")
        self.refused_later(self.peer("texel_march", '"near_m"', '"near_mm"'), "no value called 'near_mm'",
                           "did you mean 'near_m'?")
        self.refused_later(self.peer("texel_march", shader_change=("float len", "flout len")), "texel_march.frag:38")
        self.refused_later(self.peer("texel_march_hlsl", shader_change=("float len", "flout len")),
                           "texel_march_hlsl.hlsl:29")


if __name__ == "__main__":
    kit.main()
