"""bench --gates: files of one's own, whole runs, native peers."""

import os

import bench_runs
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


class GatesTest(bench_runs.BenchTest):
    def gates(self, content, **variables):
        os.makedirs(self.path("kit", "tests", "gates"), exist_ok=True)
        for folder in ("shaders", "scenes"):
            if not os.path.exists(self.path("kit", folder)):
                os.symlink(os.path.join(kit.SOURCE, folder), self.path("kit", folder))
        if not os.path.exists(self.path("kit", "tests", "expect")):
            os.symlink(os.path.join(kit.SOURCE, "tests", "expect"), self.path("kit", "tests", "expect"))
        self.write("kit/tests/gates/tiny.toml", content)
        return self.ssrkit("bench", "--gates", "--device", "gl-osmesa", "--out", "out",
                           env={"SSRKIT_ROOT": self.path("kit"), **variables})


class Gates(GatesTest):
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

    def test_options_that_the_files_decide_are_refused(self):
        for option in (("--scene", "m2"), ("--stage", "hiz"), ("--size", "64x36"), ("--param", "thickness_m=1"),
                       ("--rooflines",), ("--scaling", "resolution"), ("--peer", "mine.toml")):
            with self.subTest(option):
                result = self.ssrkit("bench", "--gates", *option, "--out", "out")
                self.assert_refused(result, "--gates", option[0], "leave one of the two out")

    def test_what_is_not_timed_is_drawn_once(self):
        fault = {"SSRKIT_FAULT": "crash:draw gbuffer;after=read back"}  # when the job is drawn again
        once = self.gates(GATE.replace("rounds = 8\n", ""), **fault)
        self.assert_exit(0, once)
        again = self.gates(GATE, **fault)
        self.assert_exit(1, again)
        self.assertIn("draw gbuffer", again.out)

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

    def test_whole_runs_are_held_to_what_a_second_core_gains(self):
        for name, bound in (("held", 0.01), ("missed", 2.0)):  # two cores never halve a run that has a start
            run = (f'[process]\nid = "{name}"\nabout = "a small run"\narguments = ["run", "--scene", "m2", "--stage", "dda", '
                   f'"--device", "gl-osmesa", "--size", "32x18"]\nruns = 8\nmin_speedup_on_2_cores = {bound}\n')
            self.write(f"kit/tests/gates/process/{name}.toml", run)
        result = self.gates(GATE)
        gates = {gate["id"]: gate for gate in self.report()["gates"]}
        if len(os.sched_getaffinity(0)) < 2:
            self.assertEqual(("skip", "skip"), (gates["held"]["outcome"], gates["missed"]["outcome"]))
            return
        self.assertEqual(("pass", "speedup_on_2_cores"), (gates["held"]["outcome"], gates["held"]["metric"]))
        self.assertGreater(gates["held"]["value"], 0.1)
        # Eight rounds may acquit and never accuse.
        self.assertEqual("inconclusive", gates["missed"]["outcome"])
        self.assert_exit(4, result)

    def test_the_kits_own_files_are_read(self):
        self.assertGreaterEqual(len(os.listdir(os.path.join(kit.SOURCE, "tests", "gates"))), 4)


NATIVE = """
[test]
id = "native"
about = "the shaders' bits, by the CPU's own vectors"
scenes = ["m2"]
sizes = ["64x36"]
devices = ["vk-lavapipe", "native-avx512", "native-avx2", "native-baseline"]
stages = ["hiz"]
rounds = 8

[[case]]
name = "far"

[[case]]
name = "near"
max_distance_m = 1.0

"""


def against(peer, metric, bound=""):
    return f'[[expect]]\nname = "{metric}_{peer}"\nmetric = "{metric}"\ntruth = "cross:{peer}"\n{bound}\n\n'


class NativePeers(GatesTest):
    PEERS = ("native-avx512", "native-avx2", "native-baseline")

    def test_hold_the_shaders_to_their_bits_and_times(self):
        checks = "".join(against(peer, "identical") + against(peer, "cpu_ratio", "max = 1e6") for peer in self.PEERS)
        self.assert_exit(0, self.gates(NATIVE + checks))
        outcomes = {gate["id"]: gate["outcome"] for gate in self.report()["gates"]}
        self.assertEqual({f"native.{metric}_{peer}" for metric in ("identical", "cpu_ratio") for peer in self.PEERS},
                         set(outcomes))
        # Every CPU runs the last; what it has no instructions for is told as skipped.
        self.assertEqual("pass", outcomes["native.identical_native-baseline"])
        self.assertLessEqual(set(outcomes.values()), {"pass", "skip"})

    def test_another_record_is_seen(self):
        spoiled = self.gates(NATIVE + against("native-baseline", "identical"), SSRKIT_FAULT="wrong:vk-lavapipe m2")
        self.assert_exit(1, spoiled)
        self.assertEqual(["fail", "fail"], [gate["outcome"] for gate in self.report()["gates"]])

    def test_their_name_is_checked(self):
        self.assert_refused(self.gates(NATIVE.replace('"native-avx2"', '"native-avx3"')), "native-avx3",
                            "did you mean 'native-avx2'?")


if __name__ == "__main__":
    kit.main()
