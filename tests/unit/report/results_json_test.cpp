#include "report/results_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../temporary_folder.h"
#include "base/atomic_file.h"

namespace ssrkit {
namespace {

RunReport smallReport() {
  RunReport report;
  report.kit_version = "0.1.0";
  report.started = "2026-01-31T12:00:00Z";
  report.command = {"ssrkit", "run", "--scene", "clutter"};
  report.devices = {{.identity = {.id = "gl-osmesa",
                                  .api = "OpenGL 4.5 core",
                                  .driver = "llvmpipe",
                                  .version = "Mesa 22.3.6",
                                  .cpu = "some CPU",
                                  .cpu_features = {"avx2"}},
                     .traits = {.loop_cap = 65536, .device_timer_usable = false, .shader_input = "SPIR-V"}}};
  CheckResult check;
  check.id = "hiz.matches_oracle.different_rays";
  check.scene = "clutter";
  check.device = "gl-osmesa";
  check.stage = "hiz";
  check.size = {64, 32};
  check.outcome = Outcome::kFail;
  check.metric = "different_rays";
  check.value = std::numeric_limits<double>::infinity();
  check.max = 0.0;
  check.unit = "rays";
  check.message = "first bad byte: \xff\n";
  check.repro = "ssrkit run --scene clutter";
  check.parameters = TraceParameters{.lookup_budget = 500, .jitter = 0.5};
  report.checks = {check};
  RunRow row;
  row.scene = "clutter";
  row.device = "gl-osmesa";
  row.stage = "hiz";
  row.size = {64, 32};
  row.outcome = Outcome::kFail;
  row.parameters.lookup_budget = 500;
  row.parameters.jitter = 0.5;
  TraceSummary summary;
  summary.classes[2] = 7;
  summary.traced_rays = 7;
  summary.lookups = {1.5, 1, 2, 3};
  summary.verdicts = VerdictCounts{0, 6, 1, 0, 0, 0, 0, 0};
  row.summary = summary;
  row.passes = {{"trace",
                 {.wall_ns = 10, .cpu_ns = 20, .device_ns = 5},
                 {{.wall_ns = 1, .cpu_ns = 2, .device_ns = {}}}}};
  row.true_classes = TrueClassSummary{};
  row.true_classes->geometry.rays[1] = 7;
  row.true_classes->geometry.verdicts[1] = {0, 4, 2, 1, 0};
  row.true_classes->against_oracle[1] = {0, 6, 1, 0, 0, 0, 0, 0};
  report.rows = {row};
  GeometryRow geometry;
  geometry.scene = "clutter";
  geometry.device = "gl-osmesa";
  geometry.size = {64, 32};
  geometry.counts.rays = {2, 7, 0, 0, 0, 3, 0};
  geometry.counts.verdicts[5] = {0, 0, 1, 0, 2};
  report.geometries = {geometry};
  report.frames = {
      {"clutter", "gl-osmesa", {64, 32}, {{"gbuffer", {.wall_ns = 3, .cpu_ns = 4, .device_ns = {}}, {}}}}};
  return report;
}

TEST(ResultsJson, NamesItsSchemaAndTheRun) {
  const auto json = nlohmann::json::parse(resultsJson(smallReport()));
  EXPECT_EQ(json.at("schema"), "ssrkit-results");
  EXPECT_EQ(json.at("schema_version"), 1);
  EXPECT_EQ(json.at("kit_version"), "0.1.0");
  EXPECT_EQ(json.at("started"), "2026-01-31T12:00:00Z");
  EXPECT_EQ(json.at("command"), (std::vector<std::string>{"ssrkit", "run", "--scene", "clutter"}));
  EXPECT_EQ(json.at("devices")[0].at("traits").at("loop_cap"), 65536);
  EXPECT_EQ(json.at("devices")[0].at("cpu_features")[0], "avx2");
  EXPECT_EQ(json.at("summary").at("line"), "0 passed, 1 failed");
  EXPECT_EQ(json.at("summary").at("exit_code"), 1);
  EXPECT_EQ(json.at("summary").at("outcomes").at("fail"), 1);
}

TEST(ResultsJson, HoldsACheckWithTheParametersOfItsTrace) {
  const auto json = nlohmann::json::parse(resultsJson(smallReport()));
  const auto& check = json.at("checks")[0];
  EXPECT_EQ(check.at("id"), "hiz.matches_oracle.different_rays");
  EXPECT_EQ(check.at("size"), (std::vector<int>{64, 32}));
  EXPECT_EQ(check.at("outcome"), "fail");
  EXPECT_EQ(check.at("bound").at("max"), 0.0);
  EXPECT_TRUE(check.at("bound").at("min").is_null());
  EXPECT_EQ(check.at("parameters").at("lookup_budget"), 500);
  EXPECT_EQ(check.at("parameters").at("jitter"), 0.5);
  EXPECT_EQ(check.at("parameters").at("form"), "tuned");
}

TEST(ResultsJson, WritesInfinityAsTextAndBytesThatAreNoUtf8AsReplacements) {
  const auto json = nlohmann::json::parse(resultsJson(smallReport()));
  EXPECT_EQ(json.at("checks")[0].at("value"), "inf");
  EXPECT_EQ(json.at("checks")[0].at("parameters").at("thickness_m"), "inf");
  EXPECT_EQ(json.at("checks")[0].at("message"), "first bad byte: \xEF\xBF\xBD\n");
}

TEST(ResultsJson, HoldsTimesCountersAndHistograms) {
  const auto json = nlohmann::json::parse(resultsJson(smallReport()));
  const auto& trace = json.at("traces")[0];
  EXPECT_EQ(trace.at("classes").at("HIT"), 7);
  EXPECT_EQ(trace.at("classes").size(), 7U);
  EXPECT_EQ(trace.at("verdicts").at("SAME"), 6);
  EXPECT_EQ(trace.at("verdicts").at("NEAR"), 1);
  EXPECT_EQ(trace.at("lookups").at("mean"), 1.5);
  EXPECT_EQ(trace.at("lookups").at("max"), 3.0);
  EXPECT_EQ(trace.at("passes")[0].at("cold").at("device_ns"), 5);
  EXPECT_EQ(trace.at("passes")[0].at("steady")[0].at("cpu_ns"), 2);
  EXPECT_TRUE(trace.at("passes")[0].at("steady")[0].at("device_ns").is_null());
  EXPECT_EQ(json.at("frames")[0].at("passes")[0].at("pass"), "gbuffer");
}

TEST(ResultsJson, HoldsWhatTheRaysTrulyMeet) {
  const auto json = nlohmann::json::parse(resultsJson(smallReport()));
  const auto& of_trace = json.at("traces")[0].at("true_classes");
  EXPECT_EQ(of_trace.size(), 6U);
  EXPECT_EQ(of_trace.at("VISIBLE").at("rays"), 7);
  EXPECT_EQ(of_trace.at("VISIBLE").at("oracle").at("SAME"), 6);
  EXPECT_EQ(of_trace.at("VISIBLE").at("geometry").at("FALSE_HIT"), 2);
  EXPECT_EQ(of_trace.at("SKY").at("rays"), 0);
  const auto& of_scene = json.at("geometry")[0];
  EXPECT_EQ(of_scene.at("scene"), "clutter");
  EXPECT_EQ(of_scene.at("rays"), 10);
  EXPECT_EQ(of_scene.at("true_classes").at("OFFSCREEN_TRUE").at("rays"), 3);
  EXPECT_EQ(of_scene.at("true_classes").at("OFFSCREEN_TRUE").at("oracle").at("TRUE_MISS"), 2);
  EXPECT_EQ(of_scene.at("parameters").at("max_distance_m"), "inf");
}

TEST(ResultsJson, WritesNullForATraceThatNeverCameBack) {
  RunReport report = smallReport();
  report.rows[0].summary.reset();
  report.rows[0].true_classes.reset();
  report.checks[0].parameters.reset();
  const auto json = nlohmann::json::parse(resultsJson(report));
  EXPECT_TRUE(json.at("traces")[0].at("lookups").is_null());
  EXPECT_TRUE(json.at("traces")[0].at("true_classes").is_null());
  EXPECT_TRUE(json.at("traces")[0].at("verdicts").is_null());
  EXPECT_TRUE(json.at("checks")[0].at("parameters").is_null());
}

TEST(ResultsJson, ItsLineIsTheOneThatIsPrinted) {
  RunReport report = smallReport();
  for (const Outcome outcome : {Outcome::kFlake, Outcome::kInconclusive, Outcome::kSkip}) {
    report.checks.push_back(report.checks[0]);
    report.checks.back().outcome = outcome;
  }
  report.unit_tests = {.passed = 12, .failed = 2, .skipped = 1};
  const auto json = nlohmann::json::parse(resultsJson(report));
  EXPECT_EQ(json.at("summary").at("line"), "12 passed, 3 failed, 2 skipped");
  EXPECT_EQ(json.at("unit_tests").at("passed"), 12);
  EXPECT_TRUE(nlohmann::json::parse(resultsJson(smallReport())).at("unit_tests").is_null());
}

TEST(WriteResultsJson, WritesTheSameText) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeResultsJson(folder / "results.json", smallReport()));
  EXPECT_EQ(readFile(folder / "results.json").value(), resultsJson(smallReport()));
}

}  // namespace
}  // namespace ssrkit
