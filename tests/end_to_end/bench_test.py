"""bench: figures on tiny sizes, scaling, what moved against a baseline, and what is refused."""

import csv
import json
import os

import bench_runs
import kit

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


class Figures(bench_runs.BenchTest):
    def test_every_pass_of_every_stage_and_device_is_timed(self):
        result = self.bench("--stage", "hiz", "--device", "vk-lavapipe", "--rooflines")
        self.assert_exit(0, result)
        self.assert_closing_line(result)
        for line in result.out.splitlines():
            self.assertLessEqual(len(line), 100, line)
        report = self.report()
        self.assertEqual(("ssrkit-bench", 2), (report["schema"], report["schema_version"]))
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
                # Rooflines are passes of a device; the native peers have none.
                self.assertEqual(series["device"] in kit.DEVICES, series["roofline_multiple"] is not None)
                if series["roofline_multiple"]:
                    self.assertGreater(series["roofline_multiple"]["median"], 0)

    def test_the_cpus_own_vectors_trace_the_same_rays_beside_the_devices(self):
        result = self.bench("--stage", "hiz", "--device", "vk-lavapipe")
        self.assert_exit(0, result)
        report = self.report()
        traces = {s["device"]: s for s in report["series"] if (s["stage"], s["pass"]) == ("hiz", "trace")}
        natives = sorted(set(traces) - set(kit.DEVICES))
        self.assertIn("native-baseline", natives)
        for native in natives:
            self.assertEqual((9, traces["gl-osmesa"]["lookups"]), (len(traces[native]["steady"]),
                                                                  traces[native]["lookups"]))
            self.assertGreater(traces[native]["cpu_ms"]["median"], 0)
        # The walk has no native peer, and a peer none of its own.
        self.assertEqual({("hiz", device, native) for device in kit.DEVICES for native in natives},
                         {(over["stage"], over["device"], over["peer"]) for over in report["over_natives"]})
        for over in report["over_natives"]:
            self.assertGreater(over["ratio"]["median"], 0)
            self.assertIn(over["peer"], result.out)

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


class Scaling(bench_runs.BenchTest):
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


class Baseline(bench_runs.BenchTest):
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
        self.assertEqual([f"walk={slow}"], self.report()["replacements"])
        self.assertIn("shaders replaced then: none", result.out)
        self.assertEqual([], self.report()["uncompared"])

    def test_what_was_traced_otherwise_is_named_and_not_compared(self):
        self.assert_exit(0, self.bench("--stage", "dda", "--param", "thickness_m=0.3", rounds=1, out="before"))
        result = self.bench("--stage", "hiz", "--baseline", self.path("before", "bench.json"), rounds=1)
        report = self.report()
        self.assertEqual({""}, {change["stage"] for change in report["changes"]})
        reasons = {(one["stage"], one["device"]): one["why"] for one in report["uncompared"]}
        self.assertEqual("thickness_m is inf and was 0.3", reasons["walk", "gl-osmesa"])
        self.assertEqual("only in this run", reasons["hiz", "gl-osmesa"])
        self.assertEqual("only in the baseline", reasons["dda", "gl-osmesa"])
        for one in report["uncompared"]:
            self.assertIn(f"{one['device']} {one['stage']} {one['pass']}", result.out)
        self.assertIn(f"{len(report['uncompared'])} skipped", result.out)
        # The frame's passes are compared with one round each: never judged.
        self.assert_exit(4, result)
        nothing = self.bench("--baseline", self.path("before", "bench.json"), scene="m1", rounds=1)
        self.assert_refused(nothing, "no pass can be compared", "only in this run", "measured with")

    def test_a_baseline_of_an_earlier_version_is_refused_with_the_reason(self):
        self.assert_exit(0, self.bench(out="before", rounds=1))
        report = kit.read_json(self.path("before", "bench.json"))
        report["schema_version"] = 1
        self.assert_refused(self.bench("--baseline", self.write("old.json", json.dumps(report)), rounds=1),
                            "old.json", "schema_version is 1 and not 2", "parameters", "measure it again")

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
                               ('{"schema": "ssrkit-bench", "schema_version": 2}', "missing"),
                               ('{"schema": "ssrkit-bench", "schema_version": 2, "machine": {"cpu": "", '
                                '"core_count": 1}, "series": [{"scene": 3}]}', "another kind")):
            with self.subTest(content):
                self.write("bad.json", content)
                self.assert_refused(self.bench("--baseline", "bad.json"), "bad.json", words)
        self.assert_refused(self.bench("--baseline", "absent.json"), "absent.json")
        self.assertFalse(os.path.exists(self.path("out")))


class Refusals(bench_runs.BenchTest):
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
