"""A conformance run as small as one gets, for the tests of `conform`."""

import os
import shutil

import kit

TWO = ["--device", "gl-osmesa", "--device", "vk-lavapipe"]
CELL = "trace.bits/m2/33x17"  # and a device


class ConformTest(kit.KitTest):
    def conform(self, *arguments, out="out", **options):
        return self.ssrkit("conform", *arguments, "--out", out, **options)

    def few(self, *arguments, filters=("trace.bits/m2/33x17", "trace.bits/m4/33x17"), **options):
        """Four cells on two devices, in order and one after another."""
        line = [word for pattern in filters for word in ("--filter", pattern)]
        return self.conform(*TWO, *line, "--jobs", "1", *arguments, **options)

    def listed(self, *arguments):
        result = self.ssrkit("conform", "--list", *TWO, *arguments)
        self.assert_exit(0, result)
        return result.out.splitlines()

    def results(self, out="out"):
        return kit.read_json(self.path(out, "results.json"))

    def outcomes(self, out="out"):
        """The gravest outcome of each cell."""
        return {cell["id"]: cell["outcome"] for cell in self.results(out)["cells"]}

    def cells(self, *outcomes, scenes=("m2", "m4")):
        ids = [f"trace.bits/{scene}/33x17/{device}" for scene in scenes for device in ("gl-osmesa", "vk-lavapipe")]
        return dict(zip(ids, outcomes))

    def record(self, cell, out="out"):
        return self.path(out, "cells", cell + ".json")

    def kit_with(self, shader, text):
        """The environment of a copy of the kit's data in which one shader is `text`."""
        root = self.path("kit")
        os.makedirs(root)
        for folder in ("scenes", "tests"):
            os.symlink(os.path.join(kit.SOURCE, folder), os.path.join(root, folder))
        shutil.copytree(os.path.join(kit.SOURCE, "shaders"), os.path.join(root, "shaders"))
        self.write(os.path.join(root, "shaders", shader), text)
        return {"SSRKIT_ROOT": root}
