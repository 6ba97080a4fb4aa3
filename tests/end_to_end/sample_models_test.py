"""Every glTF file of Debian's assimp-testmodels: traced or refused in a sentence, never a crash.

SSRKIT_ALL_SAMPLE_MODELS=1 tries all of them and SSRKIT_SAMPLE_MODELS_TABLE=FILE keeps the table of what came of each.
"""

import os
import re

import kit

MODELS = "/usr/share/assimp/models"
SAMPLE_COUNT = 40


def models():
    found = []
    for parent, _, names in os.walk(MODELS):
        found += [os.path.join(parent, name) for name in names if name.endswith((".gltf", ".glb"))]
    return sorted(found)


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
    def spread(files):
        count = min(SAMPLE_COUNT, len(files))
        return [files[i * len(files) // count] for i in range(count)]

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
        everything = bool(os.environ.get("SSRKIT_ALL_SAMPLE_MODELS"))
        self.try_all(files if everything else self.spread(files))


if __name__ == "__main__":
    kit.main()
