"""Runs the program as its users do, and says what every run must hold."""

import csv
import json
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import tomllib
import unittest
import xml.etree.ElementTree
import zlib

import exr

PROGRAM = os.environ.get("SSRKIT_PROGRAM", "")
SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DEVICES = ("gl-osmesa", "vk-lavapipe")
ALL_SKIPPED = 77
PATIENCE_S = 240  # for one command on a busy machine; more is a hang
CLOSING_LINE = re.compile(r"^\d+ passed, \d+ failed(, \d+ skipped)?$")


class Result:
    def __init__(self, code, out, err):
        self.code = code
        self.out = out
        self.err = err

    def __str__(self):
        return f"exit code {self.code}\n--- stdout\n{self.out}\n--- stderr\n{self.err}"


def environment(**changes):
    variables = {k: v for k, v in os.environ.items() if k not in ("SSRKIT_FAULT", "SSRKIT_PRESET", "NO_COLOR")}
    variables.update(changes)
    return variables


class KitTest(unittest.TestCase):
    """A temporary folder for each test, in which commands run."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="ssrkit-end-to-end-")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def write(self, name, content):
        path = self.path(name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb" if isinstance(content, bytes) else "w") as file:
            file.write(content)
        return path

    def ssrkit(self, *arguments, env=None, cwd=None, before=None):
        done = subprocess.run([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                              cwd=cwd or self.folder, env=environment(**(env or {})), timeout=PATIENCE_S,
                              preexec_fn=before)
        return Result(done.returncode, done.stdout.decode(), done.stderr.decode())  # strict: text is UTF-8

    def trace(self, *arguments, scene="m2", stage="dda", device="gl-osmesa", size="32x18", out="out", **options):
        """A run as small as one gets, with `arguments` added; None leaves an option out."""
        line = ["run"]
        for name, value in (("scene", scene), ("stage", stage), ("device", device), ("size", size), ("out", out)):
            line += [] if value is None else [f"--{name}", value]
        return self.ssrkit(*line, *arguments, **options)

    def assert_exit(self, code, result):
        self.assertEqual(code, result.code, str(result))

    def assert_refused(self, result, *words, code=2):
        """One sentence on stderr that holds every one of `words`."""
        self.assert_exit(code, result)
        lines = result.err.splitlines()
        self.assertTrue(lines, str(result))
        self.assertTrue(lines[0].startswith("ssrkit: ") and "could not " in lines[0], str(result))
        own = [line for line in lines if line.startswith("ssrkit: ")]
        self.assertEqual(1, len(own), "more than one sentence\n" + str(result))
        for word in words:
            self.assertIn(word, result.err, str(result))
        for noise in ("terminate called", "Traceback", "basic_string", "std::"):
            self.assertNotIn(noise, result.err + result.out, str(result))

    def assert_closing_line(self, result):
        lines = result.out.splitlines()
        self.assertTrue(lines and CLOSING_LINE.match(lines[-1]), str(result))

    def assert_whole_files(self, folder):
        """No temporary file is left, and every file under a final name can be read. Returns their names."""
        names = []
        for parent, _, files in os.walk(folder):
            for name in files:
                path = os.path.join(parent, name)
                self.assertNotIn(".tmp", name, path)
                check_whole(path)
                names.append(os.path.relpath(path, folder))
        return sorted(names)


def read_json(path):
    with open(path) as file:
        return json.load(file)


def check_whole(path):
    """Raises unless the file is a whole EXR, PNG, JSON, TOML, XML, CSV or HTML file."""
    if path.endswith(".exr"):
        exr.read(path)
    elif path.endswith(".json"):
        read_json(path)
    elif path.endswith(".toml"):
        with open(path, "rb") as file:
            tomllib.load(file)
    elif path.endswith(".xml"):
        xml.etree.ElementTree.parse(path)
    elif path.endswith(".csv"):
        with open(path, newline="") as file:
            if len({len(row) for row in csv.reader(file, strict=True)}) != 1:
                raise ValueError(f"{path}: its rows are not equally long")
    elif path.endswith(".html"):
        with open(path) as file:
            if not file.read().endswith("</html>\n"):
                raise ValueError(f"{path}: its end is missing")
    elif path.endswith(".png"):
        check_png(path)
    else:
        raise ValueError(f"{path}: a kind of file that is not expected")


def check_png(path):
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path}: no PNG file")
    at = 8
    kind = b""
    while at < len(data):
        (size,) = struct.unpack_from(">I", data, at)
        kind = data[at + 4:at + 8]
        (stored,) = struct.unpack_from(">I", data, at + 8 + size)
        if zlib.crc32(data[at + 4:at + 8 + size]) != stored:
            raise ValueError(f"{path}: a chunk is damaged")
        at += 12 + size
    if kind != b"IEND":
        raise ValueError(f"{path}: its end is missing")


def processes_with(marker):
    """The ids of living processes that have `marker` in their environment."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/environ", "rb") as file:
                has_marker = marker.encode() in file.read()
            with open(f"/proc/{entry}/stat") as file:
                is_alive = file.read().rpartition(")")[2].split()[0] != "Z"
        except OSError:
            continue
        if has_marker and is_alive:
            found.append(int(entry))
    return found


def main():
    """Runs the tests named on the command line; skipping all of them is told apart from passing."""
    if not PROGRAM:
        sys.exit("set SSRKIT_PROGRAM to the program under test")
    signal.signal(signal.SIGINT, signal.default_int_handler)
    result = unittest.main(exit=False, verbosity=2).result
    if not result.wasSuccessful() or result.testsRun == 0:
        sys.exit(1)
    sys.exit(ALL_SKIPPED if len(result.skipped) == result.testsRun else 0)
