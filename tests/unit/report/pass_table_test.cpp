#include "report/pass_table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/text.h"
#include "ns_per_ms.h"

namespace ssrkit {
namespace {

PassReport timed(const std::string& pass, const std::vector<std::int64_t>& cpu_ms) {
  PassReport report{.pass = pass, .cold = {.wall_ns = 0, .cpu_ns = 900 * kNsPerMs}, .steady = {}};
  for (const std::int64_t ms : cpu_ms) {
    report.steady.push_back({.wall_ns = 0, .cpu_ns = ms * kNsPerMs});
  }
  return report;
}

RunRow rowOf(const std::string& device, std::vector<PassReport> passes) {
  RunRow row;
  row.scene = "clutter";
  row.device = device;
  row.stage = "hiz";
  row.size = {640, 360};
  row.passes = std::move(passes);
  return row;
}

std::vector<std::string> cellsOf(const std::string& text, std::size_t line) {
  std::vector<std::string> cells = split(split(text, '\n').at(line), ' ');
  std::erase(cells, "");
  return cells;
}

TEST(PassTable, SumsTheFramesPassesAndTheTracesAndComparesThemWithTheTrace) {
  const std::vector<FrameRow> frames = {{"clutter", "gl-osmesa", {640, 360}, {timed("light", {9, 10, 11})}}};
  const std::vector<RunRow> rows = {rowOf("gl-osmesa", {timed("trace", {20, 20}), timed("composite", {5})})};
  const std::string text = passTable(frames, rows);
  EXPECT_EQ(cellsOf(text, 1), (std::vector<std::string>{"pass", "gl-osmesa"}));
  EXPECT_EQ(cellsOf(text, 2), (std::vector<std::string>{"light", "10.0", "0.50", "x"}));
  EXPECT_EQ(cellsOf(text, 3), (std::vector<std::string>{"trace", "20.0", "1.00", "x"}));
  EXPECT_EQ(cellsOf(text, 4), (std::vector<std::string>{"composite", "5.00", "0.25", "x"}));
  EXPECT_EQ(cellsOf(text, 5), (std::vector<std::string>{"whole", "frame", "35.0", "1.75", "x"}));
}

TEST(PassTable, PutsDevicesSideBySideWithinAHundredColumns) {
  std::vector<RunRow> rows;
  for (const std::string device : {"gl-osmesa", "vk-lavapipe", "vk-swiftshader", "gl-softpipe"}) {
    rows.push_back(rowOf(device, {timed("trace", {1234})}));
  }
  const std::vector<std::string> lines = split(passTable({}, rows), '\n');
  EXPECT_NE(lines.at(1).find("vk-lavapipe"), std::string::npos);
  EXPECT_TRUE(std::ranges::all_of(lines, [](const std::string& line) { return line.size() <= 100; }));
}

TEST(PassTable, IsEmptyWhereNothingWasTimed) {
  const std::vector<RunRow> rows = {rowOf("gl-osmesa", {})};
  EXPECT_EQ(passTable({}, rows), "");
}

}  // namespace
}  // namespace ssrkit
