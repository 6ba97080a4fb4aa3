#include "report/bench_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "ns_per_ms.h"
#include "report/bench_svg.h"
#include "spaces/roofline.h"

namespace ssrkit {
namespace {

constexpr std::size_t kRounds = 15;

// 15 rounds of this CPU time, half of it in wall time, after a first of ten times as much.
BenchSeries seriesOf(const std::string& stage, const std::string& pass, std::int64_t cpu_ns) {
  BenchSeries series;
  series.scene = "clutter";
  series.device = "vk-lavapipe";
  series.stage = stage;
  series.size = {8, 8};
  series.pass = pass;
  series.first = {.wall_ns = 5 * cpu_ns, .cpu_ns = 10 * cpu_ns};
  series.steady.assign(kRounds, {.wall_ns = cpu_ns / 2, .cpu_ns = cpu_ns});
  return series;
}

BenchReport report() {
  BenchReport made;
  made.kit_version = "1.2.3";
  made.machine = {"a CPU", 2};
  made.series = {seriesOf("", "gbuffer", 2 * kNsPerMs), seriesOf("hiz", "trace", 4 * kNsPerMs),
                 seriesOf("walk", "trace", 12 * kNsPerMs)};
  made.series[1].rays = 64;
  made.series[1].lookups = 640;
  return made;
}

TEST(BenchSeries, RowsBecomeOneSeriesAPass) {
  RunRow row;
  row.scene = "clutter";
  row.device = "gl-osmesa";
  row.stage = "hiz";
  row.size = {4, 2};
  row.summary = TraceSummary{.traced_rays = 8, .lookups = {.mean = 2.5}};
  row.passes = {{.pass = "pyramid"}, {.pass = "trace"}};
  const std::vector<FrameRow> frames = {{"clutter", "gl-osmesa", {4, 2}, {{.pass = "gbuffer"}}}};
  const std::vector<BenchSeries> series = benchSeries(frames, std::vector{row});
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[0].pass, "gbuffer");
  EXPECT_EQ(series[0].stage, "");
  EXPECT_EQ(series[2].pass, "trace");
  EXPECT_EQ(series[2].rays, 8U);
  EXPECT_EQ(series[2].lookups, 20.0);
}

TEST(BenchSeries, RatiosAreTakenRoundByRound) {
  BenchSeries slow = seriesOf("walk", "trace", 30);
  BenchSeries fast = seriesOf("hiz", "trace", 10);
  for (std::size_t round = 0; round < kRounds; ++round) {  // a machine that slows down
    slow.steady[round].cpu_ns *= static_cast<std::int64_t>(round + 1);
    fast.steady[round].cpu_ns *= static_cast<std::int64_t>(round + 1);
  }
  const auto ratio = cpuRatio(slow, fast);
  ASSERT_TRUE(ratio.has_value());
  EXPECT_EQ(ratio->low, 3.0);
  EXPECT_EQ(ratio->high, 3.0);
  fast.steady.pop_back();
  EXPECT_FALSE(cpuRatio(slow, fast).has_value());
}

TEST(BenchSeries, TheLimitIsLookupsAsFetchesAndPixelsAsWrites) {
  BenchReport made = report();
  EXPECT_FALSE(rooflineMultiple(made.series[1], made.series).has_value());
  // 32 fetches at each of 64 pixels in 2048 ns: one each. 640 lookups and a write of 360 ns are 1000 ns.
  made.series.push_back(seriesOf("hiz", "bench_dependent_fetch", std::int64_t{64} * kRooflineFetchCount));
  made.series.push_back(seriesOf("hiz", "bench_write", 360));
  const auto multiple = rooflineMultiple(made.series[1], made.series);
  ASSERT_TRUE(multiple.has_value());
  EXPECT_DOUBLE_EQ(multiple->median, 4000.0);
}

TEST(BenchNatives, HoldEveryDevicesTraceAgainstThePeersOfTheSameRays) {
  BenchReport made = report();
  BenchSeries native = seriesOf("hiz", "trace", 2 * kNsPerMs);
  native.device = "native-avx2";
  made.series.push_back(native);
  native.device = "native-avx512";
  native.case_name = "another";
  made.series.push_back(native);
  made.over_natives =
      ratiosOverNatives(made.series, std::vector<std::string>{"native-avx512", "native-avx2"});
  ASSERT_EQ(made.over_natives.size(), 1U);
  EXPECT_EQ(made.over_natives[0].series, &made.series[1]);
  EXPECT_EQ(made.over_natives[0].peer, "native-avx2");
  ASSERT_TRUE(made.over_natives[0].ratio.has_value());
  EXPECT_EQ(made.over_natives[0].ratio->median, 2.0);
  EXPECT_NE(benchText(made).find("native-avx2"), std::string::npos);
  const auto json = nlohmann::json::parse(benchJson(made));
  EXPECT_EQ(json.at("over_natives").at(0).at("peer"), "native-avx2");
  EXPECT_EQ(json.at("over_natives").at(0).at("ratio").at("median"), 2.0);
}

TEST(BenchMove, IsNamedOnlyWhereTheWholeIntervalHasMoved) {
  const auto move = [](double low, double high) {
    return std::string(name(moveOf(RatioInterval{(low + high) / 2.0, low, high, low, high}, 0.05)));
  };
  EXPECT_EQ(move(1.06, 1.2), "slower");
  EXPECT_EQ(move(1.04, 1.2), "inconclusive");
  EXPECT_EQ(move(0.97, 1.03), "unchanged");
  EXPECT_EQ(move(0.8, 0.95), "faster");
  EXPECT_EQ(move(0.8, 0.96), "inconclusive");
  EXPECT_EQ(move(0.5, 2.0), "inconclusive");
  EXPECT_STREQ(name(moveOf(std::nullopt, 0.05)), "inconclusive");
}

TEST(BenchComparison, HoldsOnlyWhatWasTracedAlikeAndNamesTheRest) {
  std::vector<BenchSeries> then = {seriesOf("", "gbuffer", kNsPerMs), seriesOf("hiz", "trace", 4 * kNsPerMs),
                                   seriesOf("walk", "trace", kNsPerMs), seriesOf("dda", "trace", kNsPerMs)};
  then[1].parameters = then[2].parameters = then[3].parameters = TraceParameters{};
  std::vector<BenchSeries> now = {
      seriesOf("", "gbuffer", 2 * kNsPerMs), seriesOf("hiz", "trace", 4 * kNsPerMs),
      seriesOf("walk", "trace", 2 * kNsPerMs), seriesOf("naive", "trace", kNsPerMs)};
  now[1].parameters = now[2].parameters = now[3].parameters = TraceParameters{};
  now[2].parameters->thickness_m = 0.3;
  now[2].parameters->jitter = 1.0;
  const BenchComparison comparison = compareSeries(now, then);
  ASSERT_EQ(comparison.changes.size(), 2U);
  EXPECT_EQ(comparison.changes[0].series, &now[0]);
  EXPECT_EQ(comparison.changes[0].move, BenchMove::kSlower);
  EXPECT_EQ(comparison.changes[1].series, &now[1]);
  EXPECT_EQ(comparison.changes[1].move, BenchMove::kUnchanged);
  std::vector<std::string> reasons;
  for (const BenchUncompared& one : comparison.uncompared) {
    reasons.push_back(one.series.stage + ": " + one.why);
    EXPECT_TRUE(one.series.steady.empty());
  }
  EXPECT_EQ(reasons, (std::vector<std::string>{"walk: thickness_m is 0.3 and was inf, jitter is 1 and was 0",
                                               "naive: only in this run", "dda: only in the baseline"}));
}

TEST(BenchText, FitsAHundredColumnsAndHoldsTraceAgainstHiz) {
  BenchReport made = report();
  made.series[0].scene = "a scene with a name that is much longer than any column could ever be";
  made.starts = {
      {"clutter", "vk-lavapipe", false, 20 * kNsPerMs, 300 * kNsPerMs, 4 * kNsPerMs, 900 * kNsPerMs}};
  made.scalings = {{"resolution",
                    "texels across",
                    "CPU",
                    "clutter",
                    "vk-lavapipe",
                    "hiz",
                    {{"640x360", 640.0, 30.0, 20.0}, {"1280x720", 1280.0, 36.0, 24.0}},
                    PowerLaw{0.26, 0.0, 1.0},
                    std::nullopt}};
  made.baseline = "earlier.json";
  made.comparison.changes = {
      {&made.series[1], RatioInterval{1.5, 1.4, 1.6, 1.3, 1.7}, BenchMove::kSlower},
      {&made.series[2], RatioInterval{1.0, 1.0, 1.0, 1.0, 1.0}, BenchMove::kUnchanged}};
  made.comparison.uncompared = {{seriesOf("dda", "trace", kNsPerMs), std::string(100, 'w')}};
  made.replacements = {std::string(100, 'r') + "=a.frag"};
  const std::string text = benchText(made);
  for (const std::string& line : split(text, '\n')) {
    EXPECT_LE(line.size(), 100U + (line.find("a scene with") != std::string::npos ? 100U : 0U)) << line;
  }
  EXPECT_NE(text.find("walk over hiz"), std::string::npos) << text;
  EXPECT_NE(text.find("3.00"), std::string::npos) << text;
  EXPECT_NE(text.find("0.26 +- 0.00"), std::string::npos) << text;
  EXPECT_NE(text.find("slower"), std::string::npos) << text;
  EXPECT_NE(text.find("1 of 2 passes unchanged"), std::string::npos) << text;
  EXPECT_NE(text.find("not compared  clutter 8x8 vk-lavapipe dda trace"), std::string::npos) << text;
  EXPECT_NE(text.find("shaders replaced then: none"), std::string::npos) << text;
}

TEST(BenchText, NamesAGateInFull) {
  BenchReport made;
  CheckResult gate{
      .id = "gate.threads_full_vk.composite_replace", .scene = "corridor", .device = "vk-lavapipe@1"};
  gate.stage = "hiz";
  gate.size = {1280, 720};
  gate.case_name = "tuned";
  gate.value = 1.9;
  gate.interval = {1.87, 1.95};
  gate.min = 1.85;
  gate.unit = "ratio of wall time";
  made.gates = {gate};
  const std::string text = benchText(made);
  EXPECT_NE(text.find("gate.threads_full_vk.composite_replace corridor 1280x720 tuned vk-lavapipe@1 hiz"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("1.90 (1.87 .. 1.95)"), std::string::npos) << text;
  EXPECT_NE(text.find(">= 1.85 ratio of wall time"), std::string::npos) << text;
}

TEST(BenchJson, SaysWhatWasMeasuredAndWhere) {
  BenchReport made = report();
  made.series[1].parameters = TraceParameters{};
  const auto json = nlohmann::json::parse(benchJson(made));
  EXPECT_EQ(json.at("schema"), "ssrkit-bench");
  EXPECT_EQ(json.at("schema_version"), 2);
  EXPECT_EQ(json.at("machine").at("core_count"), 2);
  const auto& trace = json.at("series").at(1);
  EXPECT_EQ(trace.at("stage"), "hiz");
  EXPECT_EQ(trace.at("cpu_ms").at("median"), 4.0);
  EXPECT_EQ(trace.at("steady").size(), kRounds);
  EXPECT_EQ(trace.at("first").at("cpu_ns"), 40 * kNsPerMs);
  EXPECT_TRUE(trace.at("roofline_multiple").is_null());
  EXPECT_EQ(trace.at("parameters").at("thickness_m"), "inf");
  EXPECT_TRUE(json.at("series").at(0).at("parameters").is_null());
}

TEST(BenchCsv, HasOneLineASeriesAndAsManyCellsAsTheHeader) {
  BenchReport made = report();
  made.series[2].scene = "a, \"b\"";
  const std::vector<std::string> lines = split(benchCsv(made), '\n');
  ASSERT_EQ(lines.size(), 5U);
  const auto cells = [](const std::string& line) { return std::ranges::count(line, ',') + 1; };
  EXPECT_EQ(cells(lines[1]), cells(lines[0]));
  EXPECT_EQ(cells(lines[2]), cells(lines[0]));
  EXPECT_TRUE(lines[3].starts_with("\"a, \"\"b\"\"\",vk-lavapipe,8,8,walk,,trace,")) << lines[3];
  EXPECT_NE(lines[2].find(",64,640,15,4,4,4,2,,40,20"), std::string::npos) << lines[2];
}

TEST(BenchHtml, DrawsABarForEachSeriesAndAPointForEachStep) {
  BenchReport made = report();
  made.series[1].stage = "<hiz>";
  made.scalings = {
      {"resolution",
       "texels across",
       "CPU",
       "clutter",
       "vk-lavapipe",
       "hiz",
       {{"640x360", 640.0, 30.0, 20.0}, {"1280x720", 1280.0, 36.0, 24.0}, {"none", 0.0, 0.0, 0.0}},
       PowerLaw{0.26, 0.0, 5.0},
       std::nullopt}};
  const std::string html = benchHtml(made);
  const auto count = [&html](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = html.find(word); at != std::string::npos; at = html.find(word, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("<rect"), 3U);
  EXPECT_EQ(count("<circle cx") - 1, 2U);  // one in the legend; a point without a logarithm is left out
  EXPECT_EQ(count("<hiz>"), 0U);
  EXPECT_EQ(count("nan"), 0U);
  EXPECT_TRUE(html.ends_with("</html>\n"));
}

}  // namespace
}  // namespace ssrkit
