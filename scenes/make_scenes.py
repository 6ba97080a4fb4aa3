#!/usr/bin/env python3
"""Makes the built-in scenes: NAME/NAME.gltf and NAME/NAME.bin for each.

    scenes/make_scenes.py            writes them beside this file
    scenes/make_scenes.py FOLDER     writes them into FOLDER
    scenes/make_scenes.py --check    makes them in a temporary folder and fails when a file here has other bytes
"""

import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True

from kit import closed_form, gloss, rooms, sequences, views  # noqa: E402

MAKERS = [closed_form.m1, closed_form.m2, closed_form.m3, closed_form.m4, rooms.clutter, rooms.thin, rooms.facing,
          rooms.curved, gloss.gloss, views.corridor, views.outdoor, sequences.moving]


def write_all(folder):
    for make in MAKERS:
        scene = make()
        scene.write(folder / scene.name)


def differences(made, kept):
    """The files of `made` that `kept` has not, or has with other bytes."""
    for path in sorted(made.rglob("*.*")):
        other = kept / path.relative_to(made)
        if not other.is_file():
            yield f"{other} is missing"
        elif other.read_bytes() != path.read_bytes():
            yield f"{other} is not what the script makes"


def main(arguments):
    here = pathlib.Path(__file__).resolve().parent
    if arguments != ["--check"]:
        write_all(pathlib.Path(arguments[0]) if arguments else here)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        write_all(pathlib.Path(folder))
        found = list(differences(pathlib.Path(folder), here))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
