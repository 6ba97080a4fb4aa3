"""Writes the shaders of one mutant into a folder, to be drawn with `run --replace`:

    python3 tests/mutants/write_shader.py hiz_never_climbs out/mutant
    ./ssrkit run --scene clutter --stage hiz --replace hiz=out/mutant/trace_hiz.frag

All shaders and their includes come to lie beside each other, for an include is looked for beside the file that
names it first. What is wrong with them is not said: it stands in tests/mutants/NAME.toml."""

import pathlib
import shutil
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
MUTANTS = ROOT / "tests" / "mutants"


def write_shaders(name, folder):
    """Fails with one sentence where there is no mutant of that name, or it is not one of a shader."""
    description = MUTANTS / f"{name}.toml"
    if not description.is_file():
        sys.exit(f"write_shader.py: there is no mutant '{name}': ./ssrkit mutate --list names them")
    mutant = tomllib.loads(description.read_text())
    changed = ROOT / mutant.get("file", f"shaders/{mutant.get('pass')}.frag")
    if ROOT / "shaders" not in changed.parents:
        sys.exit(f"write_shader.py: '{name}' changes {mutant['file']}, which is no shader")
    folder.mkdir(parents=True, exist_ok=True)
    for file in [*ROOT.glob("shaders/*.frag"), *ROOT.glob("shaders/*.vert"), *ROOT.glob("shaders/include/*.glsl")]:
        shutil.copyfile(file, folder / file.name)
    target = folder / changed.name
    if "pass" in mutant:
        shutil.copyfile(MUTANTS / f"{name}.frag", target)
    else:
        target.write_text(changed.read_text().replace(mutant["replace"], mutant.get("with", "")))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python3 tests/mutants/write_shader.py MUTANT FOLDER")
    write_shaders(sys.argv[1], pathlib.Path(sys.argv[2]))
