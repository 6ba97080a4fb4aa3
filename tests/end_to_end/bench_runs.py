"""Runs of `bench`, for its tests."""

import kit


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
