"""Every mutant of tests/mutants is described, fits the file that it changes, and names a check that there is."""

import pathlib
import re
import sys
import tempfile
import tomllib
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "mutants"))
import write_shader

ROOT = pathlib.Path(__file__).resolve().parents[2]
MUTANTS = ROOT / "tests" / "mutants"
WHEATS = ROOT / "tests" / "wheats"
EDIT = {"about", "file", "replace"}  # and "with", unless something is only taken away
INCLUDE = re.compile(r'^#include "([\w.]+)"', re.MULTILINE)


def read(folder):
    return {path.stem: tomllib.loads(path.read_text()) for path in sorted(folder.glob("*.toml"))}


def unit_tests():
    """Source text by the "Suite.Name" of each unit test in it."""
    found = {}
    for path in (ROOT / "tests" / "unit").rglob("*_test.cpp"):
        text = path.read_text()
        for suite, name in re.findall(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", text, re.MULTILINE):
            found[f"{suite}.{name}"] = text
    return found


def battery_checks():
    checks = set()
    for test in read(MUTANTS / "battery").values():
        for expectation in test["expect"]:
            checks.add(f"{test['test']['id']}.{expectation.get('name', expectation['metric'])}")
    return checks


def made_of(entry):
    """An entry file with everything that it includes."""
    files, waiting = set(), [entry]
    while waiting:
        path = waiting.pop()
        if path not in files:
            files.add(path)
            waiting += [ROOT / "shaders" / "include" / name for name in INCLUDE.findall(path.read_text())]
    return files


def changed_file(mutant):
    return ROOT / (mutant["file"] if "file" in mutant else f"shaders/{mutant['pass']}.frag")


class Mutants(unittest.TestCase):
    def setUp(self):
        self.mutants = read(MUTANTS)
        self.wheats = read(WHEATS)

    def test_there_are_enough(self):
        self.assertGreaterEqual(len(self.mutants), 60)
        self.assertGreaterEqual(len(self.wheats), 12)

    def test_each_says_what_it_is(self):
        for name, mutant in self.mutants.items():
            with self.subTest(name):
                form = {"about", "pass"} if "pass" in mutant else EDIT
                self.assertEqual(form | {"signature", "killed_by"}, set(mutant) - {"with"})
        for name, wheat in self.wheats.items():
            with self.subTest(name):
                self.assertEqual(EDIT, set(wheat) - {"with"})

    def test_whole_shaders_and_their_descriptions_come_in_pairs(self):
        whole = {name for name, mutant in self.mutants.items() if "pass" in mutant}
        self.assertEqual({path.stem for path in MUTANTS.glob("*.frag")}, whole)
        for name in whole:
            with self.subTest(name):
                self.assertNotEqual(changed_file(self.mutants[name]).read_text(), (MUTANTS / f"{name}.frag").read_text())

    def test_each_edit_fits_its_file_once(self):
        for name, mutant in (self.mutants | self.wheats).items():
            with self.subTest(name):
                if "pass" not in mutant:
                    self.assertEqual(1, changed_file(mutant).read_text().count(mutant["replace"]))
                    self.assertNotEqual(mutant["replace"], mutant.get("with", ""))

    def test_the_checks_that_are_to_kill_them_exist(self):
        tests, battery = unit_tests(), battery_checks()
        for name, mutant in self.mutants.items():
            with self.subTest(name):
                killer = mutant["killed_by"]
                self.assertTrue(killer in tests or killer in battery, killer)
                if "pass" in mutant:  # its own unit test draws it
                    self.assertIn(f'"{name}"', tests[killer])

    def test_every_pass_and_the_comparison_code_are_changed_by_one(self):
        changed = {changed_file(mutant) for mutant in self.mutants.values()}
        entries = [*(ROOT / "shaders").glob("*.frag"), *(ROOT / "shaders").glob("*.vert")]
        for entry in sorted(path for path in entries if "void main() {}" not in path.read_text()):
            with self.subTest(entry.name):
                self.assertTrue(made_of(entry) & changed)
        rooms = {path.relative_to(ROOT).parts[1] for path in changed if path.suffix == ".cpp"}
        self.assertLessEqual({"check", "oracle", "device", "spaces", "shader"}, rooms)

    def test_the_shaders_of_each_can_be_written_to_be_drawn(self):
        for name, mutant in self.mutants.items():
            changed = changed_file(mutant)
            if changed.suffix == ".cpp":
                continue
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                write_shader.write_shaders(name, pathlib.Path(folder))
                kit = {path.name: path.read_text() for path in
                       [*(ROOT / "shaders").glob("*.frag"), *(ROOT / "shaders").glob("*.vert"),
                        *(ROOT / "shaders" / "include").glob("*.glsl")]}
                written = {path.name: path.read_text() for path in pathlib.Path(folder).iterdir()}
                self.assertEqual({changed.name}, {name for name in kit if written.get(name) != kit[name]})


if __name__ == "__main__":
    unittest.main()
