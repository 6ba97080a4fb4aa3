#include "report/checks_csv.h"

#include <gtest/gtest.h>

#include <limits>

namespace ssrkit {
namespace {

constexpr const char* kHeader =
    "id,scene,device,stage,width,height,case,outcome,metric,value,min,max,unit,compared,message,repro\r\n";

TEST(ChecksCsv, WithoutChecksThereIsAHeader) {
  EXPECT_EQ(checksCsv({}), kHeader);
}

TEST(ChecksCsv, NumbersReadBackAsTheyWereAndWhatWasNotMeasuredIsEmpty) {
  CheckResult check{.id = "t.ulps", .scene = "m1", .device = "gl-osmesa", .stage = "hiz", .size = {64, 32}};
  check.case_name = "t_0.3m";
  check.outcome = Outcome::kFail;
  check.metric = "ulps";
  check.value = 0.1;
  check.max = std::numeric_limits<double>::infinity();
  check.unit = "ulp";
  check.compared = 7;
  RunReport report;
  report.checks = {check};
  EXPECT_EQ(checksCsv(report),
            std::string(kHeader) + "t.ulps,m1,gl-osmesa,hiz,64,32,t_0.3m,fail,ulps,0.1,,inf,ulp,7,,\r\n");
}

TEST(ChecksCsv, SeparatorsQuotesAndLineBreaksAreQuoted) {
  CheckResult check{.id = "a,b", .scene = "the \"scene\""};
  check.outcome = Outcome::kPass;
  check.message = "two\nlines \xFF";
  check.repro = "plain";
  RunReport report;
  report.checks = {check};
  EXPECT_EQ(checksCsv(report),
            std::string(kHeader) +
                "\"a,b\",\"the \"\"scene\"\"\",,,0,0,,pass,,,,,,0,\"two\nlines \uFFFD\",plain\r\n");
}

}  // namespace
}  // namespace ssrkit
