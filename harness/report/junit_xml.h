// DIR/junit.xml (docs/formats.md): what CI servers read. Valid against Jenkins' junit-10.xsd and the schema
// of Ant's JUnit task alike, so that it holds only what both know.
#pragma once

#include <string>

#include "report/run_report.h"

namespace ssrkit {

// One test suite a device, in the order in which checks name them; one test case a check.
// A case's time is its share of the jobs' that answered it, so that a suite's is that of its jobs.
[[nodiscard]] std::string junitXml(const RunReport& report);

}  // namespace ssrkit
