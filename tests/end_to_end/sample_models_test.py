"""Every glTF file of Debian's assimp-testmodels: traced or refused in a sentence, never a crash.

SSRKIT_ALL_SAMPLE_MODELS=1 tries all of them and SSRKIT_SAMPLE_MODELS_TABLE=FILE keeps the table of what came of each.
"""

import math
import os
import re
import shutil

import exr
import kit

MODELS = "/usr/share/assimp/models"
SAMPLE_COUNT = 40


def models():
    found = []
    for parent, _, names in os.walk(MODELS):
        found += [os.path.join(parent, name) for name in names if name.endswith((".gltf", ".glb"))]
    return sorted(found)


def spread(files):
    """All of them if the environment says so, else a few from everywhere."""
    count = len(files) if os.environ.get("SSRKIT_ALL_SAMPLE_MODELS") else min(SAMPLE_COUNT, len(files))
    return [files[i * len(files) // count] for i in range(count)]


class FullFrame(kit.KitTest):
    """The whole frame of everybody's models is drawn on both devices, and to the same picture."""

    # Two rasterisers may put an edge's texel on either side, and a ray that starts there hits something else.
    TOLERANCE = 0.02  # of the larger value, or absolute below 1
    DIFFERENT_SHARE = 0.02

    def colours(self, device):
        root = self.path("out")
        scene = next(name for name in os.listdir(root) if os.path.isdir(os.path.join(root, name)))
        image = exr.read(os.path.join(root, scene, device, "hiz", "color.exr"))
        return [image.channels[name] for name in "RGB"]

    def different_share(self, pictures):
        one, other = pictures
        different = [False] * len(one[0])
        for a_channel, b_channel in zip(one, other):
            for i, (a, b) in enumerate(zip(a_channel, b_channel)):
                self.assertTrue(math.isfinite(a) and math.isfinite(b), f"texel {i}: {a} and {b}")
                different[i] |= abs(a - b) > self.TOLERANCE * max(1.0, abs(a), abs(b))
        return sum(different) / len(different)

    def test_both_devices_draw_the_same_picture(self):
        files = spread(models())
        if not files:
            self.skipTest("assimp-testmodels is not installed")
        drawn = 0
        for file in files:
            with self.subTest(os.path.relpath(file, MODELS)):
                line = ["run", "--frame", "full", "--stage", "hiz", "--size", "96x54", "--scene", file]
                result = self.ssrkit(*line, "--out", self.path("out"))
                if result.code != 2:  # what no frame can be made of is the other test's
                    self.assertIn(result.code, (0, 1), str(result))
                    self.assertNotRegex(result.out, r"(?m)^(crash|timeout|limiter): ")
                    share = self.different_share([self.colours(device) for device in kit.DEVICES])
                    self.assertLessEqual(share, self.DIFFERENT_SHARE)
                    drawn += 1
                shutil.rmtree(self.path("out"), ignore_errors=True)
        self.assertGreater(drawn, len(files) // 3)  # half of the models are broken on purpose


class SampleModels(kit.KitTest):
    def try_all(self, files):
        rows = []
        for file in files:
            shown = os.path.relpath(file, MODELS)
            with self.subTest(shown):
                result = self.trace(scene=file, size="64x36", out="out")
                rows.append(f"{result.code}\t{shown}\t{self.first_word(result)}")
                self.assertIn(result.code, (0, 1, 2), str(result))
                self.assert_closing_line(result)
                self.assertNotRegex(result.out, r"(?m)^(crash|timeout|limiter): ")
                if result.code == 2:
                    self.assert_refused(result, os.path.basename(file))
        self.keep(rows)

    @staticmethod
    def first_word(result):
        lines = result.err.splitlines() if result.code == 2 else re.findall(r"(?m)^fail: (.*)", result.out)
        return "; ".join(lines)

    @staticmethod
    def keep(rows):
        table = os.environ.get("SSRKIT_SAMPLE_MODELS_TABLE")
        if table:
            with open(table, "w") as file:
                file.write("\n".join(rows) + "\n")

    def test_sample(self):
        files = models()
        if not files:
            self.skipTest("assimp-testmodels is not installed")
        self.try_all(spread(files))


if __name__ == "__main__":
    kit.main()
