#include "conform/outcome_table.h"

#include <gtest/gtest.h>

#include "base/text.h"
#include "made_records.h"

namespace ssrkit {
namespace {

CellRecord recordOf(const std::string& device, std::vector<CheckResult> checks) {
  CellRecord record{.id = "trace.bits/m1/64x36/" + device, .checks = std::move(checks)};
  for (CheckResult& check : record.checks) {
    check.device = device;
  }
  return record;
}

TEST(OutcomeTable, CountsWhatPassedByCheckAndDevice) {
  const CheckResult pass = madeCheck("trace.bits.identical", Outcome::kPass);
  const std::vector records = {recordOf("gl-a", {pass, pass}), recordOf("vk-b", {pass})};
  EXPECT_EQ(
      "                                                                                         gl       vk\n"
      "                                                                                          a        b\n"
      "trace.bits\n"
      "  identical                                                                               2        "
      "1\n",
      outcomeTable(records, false));
}

TEST(OutcomeTable, SplitsByStageWhereNotAllIsWell) {
  CheckResult fail = madeCheck("trace.bits.identical", Outcome::kFail);
  fail.stage = "dda";
  const CheckResult pass = madeCheck("trace.bits.identical", Outcome::kPass);
  const std::string table =
      outcomeTable(std::vector{recordOf("gl-a", {pass, fail}), recordOf("vk-b", {pass})}, false);
  EXPECT_NE(std::string::npos, table.find("  identical hiz ")) << table;
  EXPECT_NE(std::string::npos, table.find("1 fail        -\n")) << table;
}

TEST(OutcomeTable, SkipsAndNobodysChecksAreToldApart) {
  const std::string table =
      outcomeTable(std::vector{recordOf("gl-a", {madeCheck("trace.bits.x", Outcome::kSkip)}),
                               recordOf("vk-b", {madeCheck("trace.bits.y", Outcome::kPass)})},
                   false);
  EXPECT_NE(std::string::npos, table.find("skip        -\n")) << table;
}

TEST(OutcomeTable, SevenDevicesFitAHundredColumns) {
  std::vector<CellRecord> records;
  for (const char* device :
       {"gl-osmesa", "vk-lavapipe", "gl-egl", "gl-zink", "gl-softpipe", "gl-glsl", "vk-swiftshader"}) {
    std::vector<CheckResult> checks;
    checks.reserve(12345);
    for (int i = 0; i < 12345; ++i) {
      checks.push_back(madeCheck("trace.bits.a_name_that_is_far_longer_than_any", Outcome::kInconclusive));
    }
    records.push_back(recordOf(device, std::move(checks)));
  }
  for (const std::string& line : split(outcomeTable(records, false), '\n')) {
    EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(OutcomeTable, ColoursWhatIsNotWell) {
  const std::vector records = {recordOf("gl-a", {madeCheck("trace.bits.x", Outcome::kCrash)})};
  EXPECT_NE(std::string::npos, outcomeTable(records, true).find("\033[31m"));
  EXPECT_EQ(std::string::npos, outcomeTable(records, false).find('\033'));
}

}  // namespace
}  // namespace ssrkit
