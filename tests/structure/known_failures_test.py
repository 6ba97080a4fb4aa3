"""Every known failure of tests/known_failures.toml has its bug described in docs/driver-bugs.md."""

import os
import re
import tomllib
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGE = "docs/driver-bugs.md"


def anchors(page):
    """The names by which links reach the headings of a page, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", page, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


def undescribed(baseline, page):
    """The bugs that entries name and that no heading of the page describes."""
    bugs = [entry["bug"] for entry in tomllib.loads(baseline).get("expected_failure", [])]
    return [bug for bug in bugs if bug.removeprefix(PAGE + "#") not in anchors(page) or not bug.startswith(PAGE + "#")]


def read(name):
    path = os.path.join(SOURCE, name)
    if not os.path.exists(path):
        return ""
    with open(path) as file:
        return file.read()


class KnownFailures(unittest.TestCase):
    def test_every_bug_is_described(self):
        self.assertTrue(os.path.exists(os.path.join(SOURCE, "tests/known_failures.toml")))
        self.assertEqual([], undescribed(read("tests/known_failures.toml"), read(PAGE)))

    def test_bugs_that_are_not_described_are_found(self):
        page = "# Driver bugs\n\n## Loops end after 65,535 steps\n"
        entry = '[[expected_failure]]\nbug = "{}"\n'
        self.assertEqual([], undescribed(entry.format(PAGE + "#loops-end-after-65535-steps"), page))
        for bug in (PAGE + "#loops-end", PAGE, "docs/other.md#loops-end-after-65535-steps"):
            self.assertEqual([bug], undescribed(entry.format(bug), page))


if __name__ == "__main__":
    unittest.main()
