"""Includes run downwards: no room of harness/ includes a room that stands above it (docs/architecture.md)."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Each room and what it may include beside itself, from the ground up.
MAY_INCLUDE = {"base": set()}
MAY_INCLUDE["spaces"] = MAY_INCLUDE["image"] = MAY_INCLUDE["shader"] = {"base"}
MAY_INCLUDE["scene"] = {"base", "spaces", "image"}
MAY_INCLUDE["environment"] = {"base", "image"}
MAY_INCLUDE["device"] = {"base", "image", "shader"}
MAY_INCLUDE["frame"] = {"base", "spaces", "image", "shader", "scene", "environment", "device"}
MAY_INCLUDE["oracle"] = {"base", "spaces", "image", "scene"}  # written apart from shaders, devices and frames
MAY_INCLUDE["native"] = MAY_INCLUDE["oracle"] | {"oracle"}  # the oracle's input, and nothing that draws
MAY_INCLUDE["worker"] = MAY_INCLUDE["frame"] | {"frame"}
MAY_INCLUDE["check"] = {"base", "spaces", "image", "scene", "oracle"}
MAY_INCLUDE["mutation"] = {"base", "check"}
MAY_INCLUDE["report"] = MAY_INCLUDE["frame"] | {"frame", "oracle", "check", "mutation"}  # not worker: it runs nothing
MAY_INCLUDE["conform"] = MAY_INCLUDE["report"] | {"report"}  # plans and books; it runs nothing itself
MAY_INCLUDE["command"] = set(MAY_INCLUDE) - {"command"}

INCLUDE = re.compile(r'^#include "([a-z_]+)/', re.MULTILINE)


def wrong_includes(room, text):
    return sorted({other for other in INCLUDE.findall(text) if other != room and other not in MAY_INCLUDE[room]})


class IncludesRunDownwards(unittest.TestCase):
    def test_every_folder_is_a_known_room(self):
        rooms = {path.name for path in (ROOT / "harness").iterdir() if path.is_dir()}
        self.assertEqual(set(MAY_INCLUDE), rooms)

    def test_in_every_file(self):
        files = [path for pattern in ("*.h", "*.cpp") for path in (ROOT / "harness").rglob(pattern)]
        self.assertGreater(len(files), 100)
        for path in files:
            room = path.relative_to(ROOT / "harness").parts[0]
            with self.subTest(str(path.relative_to(ROOT))):
                self.assertEqual([], wrong_includes(room, path.read_text()))

    def test_reports_know_no_worker(self):
        for room in ("report", "conform"):
            self.assertEqual(["worker"], wrong_includes(room, '#include "worker/supervisor.h"\n'))

    def test_an_include_upwards_is_seen(self):
        self.assertEqual(["device"], wrong_includes("oracle", '#include "base/error.h"\n#include "device/device.h"\n'))


if __name__ == "__main__":
    unittest.main()
