"""junit.xml, checks.csv and report.html: held against the rules of their formats, and against results.json."""

import csv
import json
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree

import kit

# What both Jenkins' junit-10.xsd and the schema of Ant's JUnit task accept: the children of each element in their
# order, the attributes that it must have, and those that it may have.
CHILDREN = {
    "testsuites": r"(testsuite )*",
    "testsuite": r"properties (testcase )*system-out system-err ",
    "properties": r"(property )*",
    "property": r"",
    "testcase": r"((skipped|error|failure) )?",
    "skipped": r"",
    "error": r"",
    "failure": r"",
    "system-out": r"",
    "system-err": r"",
}
REQUIRED = {
    "testsuite": {"name", "timestamp", "hostname", "tests", "failures", "errors", "time", "package", "id"},
    "property": {"name", "value"},
    "testcase": {"name", "classname", "time"},
    "error": {"type"},
    "failure": {"type"},
}
OPTIONAL = {"testsuite": {"skipped"}, "error": {"message"}, "failure": {"message"}, "skipped": {"message", "type"}}
ATTRIBUTES = {
    "timestamp": r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d",
    "tests": r"\d+",
    "failures": r"\d+",
    "errors": r"\d+",
    "skipped": r"\d+",
    "id": r"\d+",
    "time": r"\d+(\.\d{1,3})?",
    "name": r"\S+( \S+)*",
    "classname": r"\S+( \S+)*",
    "hostname": r"\S+",
}


def junit_problem(element):
    """The first rule that the element or one of its children breaks, or None."""
    children = "".join(child.tag + " " for child in element)
    if element.tag not in CHILDREN or not re.fullmatch(CHILDREN[element.tag], children):
        return f"<{element.tag}> holds {children}"
    required = REQUIRED.get(element.tag, set())
    if not required <= set(element.attrib) <= required | OPTIONAL.get(element.tag, set()):
        return f"<{element.tag}> has the attributes {sorted(element.attrib)}"
    for name, value in element.attrib.items():
        if name in ATTRIBUTES and not re.fullmatch(ATTRIBUTES[name], value):
            return f"<{element.tag}> has {name}=\"{value}\""
    return next(filter(None, map(junit_problem, element)), None)


class ReportTest(kit.KitTest):
    def wrong_tracer(self):
        with open(f"{kit.SOURCE}/shaders/trace_dda.frag") as file:
            source = file.read()
        end = "  trace_end(hit);"
        self.assertIn(end, source)
        return self.write("wrong.frag", source.replace(end, "  if (hit.texel.x >= 0) hit.texel.x ^= 1;\n" + end))


class Junit(ReportTest):
    def test_keeps_to_the_schema_and_agrees_with_the_results(self):
        # A shader that is wrong: some checks fail.
        result = self.trace("--replace", f"trace_dda={self.wrong_tracer()}", device=None)
        self.assert_exit(1, result)
        root = ElementTree.parse(self.path("out/junit.xml")).getroot()
        self.assertEqual("testsuites", root.tag)
        self.assertIsNone(junit_problem(root))
        checks = kit.read_json(self.path("out/results.json"))["checks"]
        failed = [check for check in checks if check["outcome"] == "fail"]
        self.assertTrue(failed)
        self.assertEqual(sorted(kit.DEVICES), sorted(suite.get("name") for suite in root))
        self.assertEqual(len(checks), len(root.findall("*/testcase")))
        self.assertEqual(sorted(check["message"] for check in failed), sorted(f.text for f in root.iter("failure")))
        for suite in root:
            cases = suite.findall("testcase")
            self.assertEqual(str(len(cases)), suite.get("tests"))
            self.assertEqual(str(len(suite.findall("testcase/failure"))), suite.get("failures"))

    def test_the_rules_find_what_breaks_them(self):
        good = ('<testsuites><testsuite name="d" timestamp="2026-01-31T12:00:00" hostname="localhost" tests="1" '
                'failures="1" errors="0" time="0" package="p" id="0"><properties/><testcase name="n" classname="c" '
                'time="0"><failure type="fail" message="m">x</failure></testcase><system-out/><system-err/>'
                '</testsuite></testsuites>')
        self.assertIsNone(junit_problem(ElementTree.fromstring(good)))
        for change in (("<properties/>", ""), (' type="fail"', ""), ('time="0"', 'time="soon"'), (":00\"", ":00Z\""),
                       ("<failure", "<skipped/><failure"), ('classname="c"', 'class="c"'), ("<system-out/>", "")):
            with self.subTest(change):
                self.assertIn(change[0], good)
                self.assertIsNotNone(junit_problem(ElementTree.fromstring(good.replace(*change, 1))))


class Csv(kit.KitTest):
    def test_has_a_row_for_each_check(self):
        self.assert_exit(0, self.trace(device=None))
        with open(self.path("out/checks.csv"), newline="") as file:
            text = file.read()
        self.assertEqual(text.count("\n"), text.count("\r\n"))
        rows = list(csv.DictReader(text.splitlines(), strict=True))
        checks = kit.read_json(self.path("out/results.json"))["checks"]
        self.assertTrue(checks)
        self.assertEqual([[check[key] for key in ("id", "scene", "device", "stage", "outcome")] for check in checks],
                         [[row[key] for key in ("id", "scene", "device", "stage", "outcome")] for row in rows])
        for check, row in zip(checks, rows):
            self.assertEqual(check["value"], float(row["value"]) if row["value"] else None)
            self.assertEqual(check["bound"]["max"], float(row["max"]) if row["max"] else None)


class Page(ReportTest):
    """What a browser makes of report.html."""

    def setUp(self):
        super().setUp()
        self.browser = shutil.which("chromium")
        if not self.browser:
            self.skipTest("chromium is not installed")

    def opened(self, path):
        """The document after its scripts have run, as text."""
        done = subprocess.run([self.browser, "--headless", "--no-sandbox", "--disable-gpu", "--dump-dom",
                               f"--user-data-dir={self.path('profile')}", f"file://{path}"],
                              capture_output=True, timeout=kit.PATIENCE_S, cwd=self.folder)
        self.assertEqual(0, done.returncode, done.stderr.decode(errors="replace"))
        return done.stdout.decode()

    def test_shows_the_failures_of_a_run(self):
        self.assert_exit(1, self.trace("--replace", f"trace_dda={self.wrong_tracer()}", device=None))
        checks = kit.read_json(self.path("out/results.json"))["checks"]
        failed = sum(check["outcome"] == "fail" for check in checks)
        document = self.opened(self.path("out/report.html"))
        self.assertIn(f"{failed} of {len(checks)} checks", document)
        self.assertEqual(failed, document.count('<tr class="check"'))

    def test_opens_ten_thousand_checks_page_by_page_and_escapes_all_of_them(self):
        self.assert_exit(0, self.trace())
        with open(self.path("out/report.html")) as file:
            page = file.read()
        begin = page.index('id="data">') + len('id="data">')
        end = page.index("</script>", begin)
        data = json.loads(page[begin:end])
        attack = len(data["strings"])
        data["strings"].append("<b>bold</b>")
        row = list(data["rows"][0])
        row[data["columns"].index("scene")] = attack
        data["rows"] = [row] * 10000
        text = json.dumps(data).replace("<", "\\u003c")
        document = self.opened(self.write("many.html", page[:begin] + text + page[end:]))
        self.assertIn("10000 of 10000 checks, the first 200 are shown", document)
        self.assertEqual(200, document.count('<tr class="check"'))
        self.assertNotIn("<b>bold", document)
        self.assertIn("&lt;b&gt;bold", document)


if __name__ == "__main__":
    kit.main()
