"""Every mutant of tests/mutants is described, differs from the shader it stands for, and is run by the test that kills it."""

import pathlib
import re
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MUTANTS = ROOT / "tests" / "mutants"


def unit_tests():
    """Source text by the "Suite.Name" of each unit test in it."""
    found = {}
    for path in (ROOT / "tests" / "unit").rglob("*_test.cpp"):
        text = path.read_text()
        for suite, name in re.findall(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", text, re.MULTILINE):
            found[f"{suite}.{name}"] = text
    return found


class Mutants(unittest.TestCase):
    def test_shaders_and_descriptions_come_in_pairs(self):
        shaders = {path.stem for path in MUTANTS.glob("*.frag")}
        self.assertGreater(len(shaders), 10)
        self.assertEqual(shaders, {path.stem for path in MUTANTS.glob("*.toml")})
        self.assertEqual({".frag", ".toml"}, {path.suffix for path in MUTANTS.iterdir()})

    def test_each_differs_from_the_shader_of_its_pass(self):
        for path in MUTANTS.glob("*.toml"):
            with self.subTest(path.stem):
                about = tomllib.loads(path.read_text())
                self.assertEqual({"pass", "about", "killed_by"}, set(about))
                kit = ROOT / "shaders" / f"{about['pass']}.frag"
                self.assertTrue(kit.is_file(), f"no pass has the shader {kit.name}")
                self.assertNotEqual(kit.read_text(), path.with_suffix(".frag").read_text())

    def test_each_is_run_by_the_test_that_kills_it(self):
        tests = unit_tests()
        for path in MUTANTS.glob("*.toml"):
            with self.subTest(path.stem):
                killer = tomllib.loads(path.read_text())["killed_by"]
                self.assertIn(killer, tests)
                self.assertIn(f'"{path.stem}"', tests[killer])


if __name__ == "__main__":
    unittest.main()
