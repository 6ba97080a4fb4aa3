"""bench: figures on tiny sizes, what moved against a baseline, gates of one's own, and what is refused."""

import csv
import json
import os

import kit

GATE = """
[test]
id = "tiny"
about = "the walk makes more lookups than the pyramid's tracer"
scenes = ["m2"]
sizes = ["64x36"]
stages = ["hiz", "walk"]
rounds = 8

[[expect]]
metric = "mean_lookups"
stages = ["walk"]
max = 10000
"""

# The exact walk, done over and over.
SLOW = """#version 450
#include "trace_entry.glsl"
#include "ssr_march_walk.glsl"

void main() {
  Ray ray;
  RayHit hit;
  if (trace_begin(ray, hit)) {
    for (int i = 0; i < 30; ++i) {
      hit = march_walk(ray, trace_parameters());
      ray.s_end += float(hit.lookups) * 1e-30;
    }
  }
  trace_end(hit);
}
"""


class BenchTest(kit.KitTest):
    def bench(self, *arguments, scene="m2", stage="walk", device="gl-osmesa", size="64x36", rounds=9, out="out",
              **options):
        line = ["bench", "--out", out]
        for name, value in (("scene", scene), ("stage", stage), ("device", device), ("size", size),
                            ("rounds", rounds)):
            line += [] if value is None else [f"--{name}", value]
        return self.ssrkit(*line, *arguments, **options)

    def report(self, out="out"):
        return kit.read_json(self.path(out, "bench.json"))


class Figures(BenchTest):
    def test_every_pass_of_every_stage_and_device_is_timed(self):
        result = self.bench("--stage", "hiz", "--device", "vk-lavapipe", "--rooflines")
        self.assert_exit(0, result)
        self.assert_closing_line(result)
        for line in result.out.splitlines():
            self.assertLessEqual(len(line), 100, line)
        report = self.report()
        self.assertEqual(("ssrkit-bench", 1), (report["schema"], report["schema_version"]))
        for device in kit.DEVICES:
            passes = {(s["stage"], s["pass"]) for s in report["series"] if s["device"] == device}
            self.assertLessEqual({("", "gbuffer"), ("walk", "trace"), ("hiz", "trace"), ("hiz", "pyramid"),
                                  ("hiz", "bench_dependent_fetch"), ("hiz", "bench_write")}, passes)
        for series in report["series"]:
            self.assertEqual(9, len(series["steady"]), series["pass"])
            self.assertLessEqual(series["cpu_ms"]["low"], series["cpu_ms"]["median"])
            self.assertLessEqual(series["cpu_ms"]["median"], series["cpu_ms"]["high"])
            if series["pass"] == "trace":
                self.assertGreater(series["rays"], 0)
                self.assertGreater(series["lookups"], series["rays"] / 2)
                self.assertGreater(series["roofline_multiple"]["median"], 0)

    def test_cold_and_warm_starts_are_told_apart(self):
        self.assert_exit(0, self.bench())
        starts = {start["has_caches"]: start for start in self.report()["starts"]}
        self.assertEqual({False, True}, set(starts))
        self.assertGreater(starts[False]["compile_ns"], 3 * starts[True]["compile_ns"])
        self.assertGreater(starts[False]["create_ns"], 0)

    def test_csv_has_the_figures_of_the_json(self):
        self.assert_exit(0, self.bench())
        with open(self.path("out", "bench.csv"), newline="") as file:
            rows = list(csv.DictReader(file))
        report = self.report()
        self.assertEqual([s["pass"] for s in report["series"]], [row["pass"] for row in rows])
        for series, row in zip(report["series"], rows):
            self.assertAlmostEqual(series["cpu_ms"]["median"], float(row["cpu_ms"]), delta=1e-4 * float(row["cpu_ms"]))

    def test_json_is_the_file(self):
        result = self.bench("--json")
        self.assert_exit(0, result)
        self.assertEqual(json.loads(result.out), self.report())

    def test_a_dead_worker_fails(self):
        result = self.bench(env={"SSRKIT_FAULT": "crash:draw trace_walk"})
        self.assert_exit(1, result)
        self.assertIn("draw trace_walk", result.out)


class Scaling(BenchTest):
    def test_the_walks_lookups_grow_with_the_resolution(self):
        result = self.bench("--scaling", "resolution", "--scaling", "ray_length", rounds=2)
        self.assert_exit(0, result)
        scaling = {one["axis"]: one for one in self.report()["scaling"]}
        self.assertEqual(["32x18", "45x25", "64x36", "90x50", "128x72"],
                         [point["label"] for point in scaling["resolution"]["points"]])
        # The walk visits every texel that a ray crosses.
        self.assertAlmostEqual(1.0, scaling["resolution"]["lookups"]["exponent"], delta=0.1)
        lookups = [point["lookups_per_ray"] for point in scaling["ray_length"]["points"]]
        self.assertEqual(sorted(lookups), lookups)

    def test_threads_are_the_devices_own(self):
        result = self.bench("--scaling", "threads", rounds=1)
        self.assert_exit(0, result)
        (scaling,) = self.report()["scaling"]
        self.assertEqual(("wall", "gl-osmesa"), (scaling["clock"], scaling["device"]))
        self.assertEqual(["1 threads", "2 threads"], [point["label"] for point in scaling["points"]][:2])


class Baseline(BenchTest):
    def test_a_planted_slow_shader_is_named_and_the_other_passes_are_not(self):
        self.assert_exit(0, self.bench("--stage", "dda", size="160x90", rounds=15, out="before"))
        slow = self.write("slow.frag", SLOW)
        result = self.bench("--stage", "dda", "--replace", f"walk={slow}", "--baseline",
                            self.path("before", "bench.json"), size="160x90", rounds=15)
        self.assert_exit(1, result)
        moves = {(change["stage"], change["pass"]): change for change in self.report()["changes"]}
        self.assertEqual("slower", moves["walk", "trace"]["move"])
        self.assertGreater(moves["walk", "trace"]["ratio"]["low"], 2)
        self.assertIn("slower", result.out)
        dda = moves["dda", "trace"]
        self.assertLess(dda["ratio"]["median"], 2, dda)

    def test_another_machine_is_refused(self):
        self.assert_exit(0, self.bench(out="before", rounds=1))
        path = self.path("before", "bench.json")
        for change in ({"cpu": "a CPU of 1971"}, {"core_count": 1971}):
            report = kit.read_json(path)
            report["machine"].update(change)
            other = self.write("other.json", json.dumps(report))
            self.assert_refused(self.bench("--baseline", other, rounds=1), "1971", "other.json",
                                "measure a baseline on this machine")

    def test_what_is_no_baseline_is_refused(self):
        for content, words in (("no json", "no bench.json"), ("{}", "no bench.json"),
                               ('{"schema": "ssrkit-bench", "schema_version": 99}', "schema_version"),
                               ('{"schema": "ssrkit-bench", "schema_version": 1}', "missing"),
                               ('{"schema": "ssrkit-bench", "schema_version": 1, "machine": {"cpu": "", '
                                '"core_count": 1}, "series": [{"scene": 3}]}', "another kind")):
            with self.subTest(content):
                self.write("bad.json", content)
                self.assert_refused(self.bench("--baseline", "bad.json"), "bad.json", words)
        self.assert_refused(self.bench("--baseline", "absent.json"), "absent.json")
        self.assertFalse(os.path.exists(self.path("out")))


class Gates(BenchTest):
    def gates(self, content):
        os.makedirs(self.path("kit", "tests", "gates"), exist_ok=True)
        for folder in ("shaders", "scenes"):
            if not os.path.exists(self.path("kit", folder)):
                os.symlink(os.path.join(kit.SOURCE, folder), self.path("kit", folder))
        if not os.path.exists(self.path("kit", "tests", "expect")):
            os.symlink(os.path.join(kit.SOURCE, "tests", "expect"), self.path("kit", "tests", "expect"))
        self.write("kit/tests/gates/tiny.toml", content)
        return self.ssrkit("bench", "--gates", "--device", "gl-osmesa", "--out", "out",
                           env={"SSRKIT_ROOT": self.path("kit")})

    def test_what_holds_passes(self):
        result = self.gates(GATE)
        self.assert_exit(0, result)
        self.assertIn("tiny.mean_lookups", result.out)
        self.assertTrue(result.out.endswith("1 passed, 0 failed\n"), str(result))
        (gate,) = self.report()["gates"]
        self.assertEqual(("pass", 10000), (gate["outcome"], gate["bound"]["max"]))

    def test_what_falls_short_exits_1(self):
        result = self.gates(GATE.replace("max = 10000", "max = 0.5"))
        self.assert_exit(1, result)
        self.assertTrue(result.out.endswith("0 passed, 1 failed\n"), str(result))

    def test_noise_alone_exits_4(self):
        noisy = GATE + '\n[[expect]]\nmetric = "cpu_ratio"\nstages = ["hiz"]\ntruth = "stage:walk"\nmax = 1e-6\n'
        result = self.gates(noisy.replace("rounds = 8", "rounds = 7"))  # twice as many, 14, still never accuse
        self.assert_exit(4, result)
        self.assertIn("1 inconclusive", result.out)

    def test_what_is_wrong_with_a_file_is_named_with_its_place(self):
        for change, words in ((("mean_lookups", "mean_lockups"), ("tiny.toml:11:10", "did you mean 'mean_lookups'?")),
                              (("max = 10000", "maxi = 10000"), ("tiny.toml:13:1", "maxi")),
                              (("rounds = 8", 'devices = ["vk-lavapipe@3"]'), ("tiny.toml:", "vk-lavapipe@3"))):
            with self.subTest(change):
                self.assertIn(change[0], GATE)
                self.assert_refused(self.gates(GATE.replace(*change)), *words)

    def test_whole_runs_are_held_to_time_and_memory(self):
        run = ('[process]\nid = "small"\nabout = "a small run"\narguments = ["run", "--scene", "m2", "--stage", "dda", '
               '"--device", "gl-osmesa", "--size", "32x18"]\nruns = 8\n')
        for bounds, code, outcomes in (("max_wall_s = 1000\nmax_memory_mib = 100000\n", 0, ["pass", "pass"]),
                                       ("max_memory_mib = 1\n", 1, ["fail"])):
            self.write("kit/tests/gates/process/small.toml", run + bounds)
            self.assert_exit(code, self.gates(GATE))
            gates = [gate for gate in self.report()["gates"] if gate["id"] == "small"]
            self.assertEqual(outcomes, [gate["outcome"] for gate in gates])
            self.assertGreater(gates[-1]["value"], 20)  # two processes with a driver and a compiler
        self.write("kit/tests/gates/process/small.toml", run)
        self.assert_refused(self.gates(GATE), "small.toml", "bounds nothing")
        self.write("kit/tests/gates/process/small.toml", run + "max_wal_s = 1\n")
        self.assert_refused(self.gates(GATE), "small.toml:6:1", "did you mean 'max_wall_s'?")

    def test_the_kits_own_files_are_read(self):
        self.assertGreaterEqual(len(os.listdir(os.path.join(kit.SOURCE, "tests", "gates"))), 4)


class PeerTest(BenchTest):
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
                              (('depthTex = "depth"', 'depthTex = "deepth"'), ("did you mean 'depth'?",)),
                              (('hit = "w"', 'hit = "q"'), ("'q'", "x")),
                              (('hit = "w"', ""), ("hit",)),
                              (('name = "texel_march"', 'name = "hiz"'), ("kit's own stages",)),
                              (('reach = "max_distance_m"', "reach = true"), ("reach", "a number")),
                              (("[peer]", "[peer"), ("texel_march.toml:1",))):
            with self.subTest(change):
                self.assert_refused(self.bench("--peer", self.peer("texel_march", *change)), *words)
        self.assert_refused(self.bench("--peer", "absent.toml"), "absent.toml")
        self.assert_refused(self.bench("--gates", "--peer", self.peer("texel_march")), "--peer")

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


class Refusals(BenchTest):
    def test_names_are_checked_before_anything_is_timed(self):
        for arguments, words in ((("--scaling", "resolutoin"), ("did you mean 'resolution'?",)),
                                 (("--stage", "hizz"), ("did you mean 'hiz'?",)),
                                 (("--device", "gl-osmesa@0"), ("gl-osmesa@0", "threads from 1 to 64")),
                                 (("--device", "gl-osmesa@two"), ("gl-osmesa@two",)),
                                 (("--device", "gl-osmessa@2"), ("did you mean 'gl-osmesa'?",)),
                                 (("--rounds", "0"), ("0",)),
                                 (("--param", "thickness=1"), ("did you mean 'thickness_m'?",))):
            with self.subTest(arguments):
                without = {"rounds": None} if "--rounds" in arguments else {}
                self.assert_refused(self.bench(*arguments, **without), *words)
                self.assertFalse(os.path.exists(self.path("out")))


if __name__ == "__main__":
    kit.main()
