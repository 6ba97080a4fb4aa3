#include "report/table.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/text.h"
#include "report/table_text.h"

namespace ssrkit {
namespace {

RunRow rowOf(const std::string& stage, const std::string& device, Outcome outcome) {
  RunRow row;
  row.scene = "clutter";
  row.device = device;
  row.stage = stage;
  row.size = {640, 360};
  row.outcome = outcome;
  return row;
}

RunRow tracedRow() {
  RunRow row = rowOf("hiz", "gl-osmesa", Outcome::kPass);
  TraceSummary summary;
  summary.classes = {100, 50, 450, 550, 0, 0, 0};
  summary.traced_rays = 1000;
  summary.lookups = {31.24, 20, 60, 128};
  summary.verdicts = VerdictCounts{150, 989, 1, 2, 3, 4, 1, 0};
  row.summary = summary;
  row.passes = {{"trace", {.wall_ns = 6'200'000, .cpu_ns = 12'300'000, .device_ns = {}}, {}}};
  return row;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  lines.pop_back();
  return lines;
}

TEST(RunTable, ShowsEveryMeasureOfATrace) {
  const std::vector<RunRow> rows = {tracedRow()};
  const std::vector<std::string> lines = linesOf(runTable(rows, {}));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[2], "clutter 640x360");
  std::vector<std::string> cells = split(lines[3], ' ');
  std::erase(cells, "");
  EXPECT_EQ(cells, (std::vector<std::string>{"hiz", "gl-osmesa", "pass", "45.0", "98.90", "1", "2", "3", "4",
                                             "1", "31.2", "60", "12.3", "6.20"}));
}

TEST(RunTable, AlignsNumbersOnTheRightUnderTheirHeadings) {
  std::vector<RunRow> rows = {tracedRow(), tracedRow()};
  rows[1].summary->lookups.mean = 1234.0;
  const std::vector<std::string> lines = linesOf(runTable(rows, {}));
  const std::size_t mean_end = lines[1].find("mean") + 4;
  EXPECT_EQ(lines[3].substr(mean_end - 4, 4), "31.2");
  EXPECT_EQ(lines[4].substr(mean_end - 4, 4), "1234");
  EXPECT_EQ(lines[0].find("lookups/ray") + 11, lines[1].find("p95") + 3);
}

TEST(RunTable, ShowsDashesForATraceThatNeverCameBack) {
  const std::vector<RunRow> rows = {rowOf("dda", "vk-lavapipe", Outcome::kCrash)};
  std::vector<std::string> cells = split(linesOf(runTable(rows, {})).back(), ' ');
  std::erase(cells, "");
  EXPECT_EQ(cells.size(), 14U);
  EXPECT_EQ(cells[2], "crash");
  EXPECT_EQ(std::ranges::count(cells, "-"), 11);
}

TEST(RunTable, WritesAHeadingForEachSceneSizeAndCase) {
  std::vector<RunRow> rows = {tracedRow(), tracedRow(), tracedRow()};
  rows[2].case_name = "t_0.3m";
  const std::string text = runTable(rows, {});
  EXPECT_NE(text.find("clutter 640x360\n"), std::string::npos);
  EXPECT_NE(text.find("clutter 640x360 t_0.3m\n"), std::string::npos);
  EXPECT_EQ(linesOf(text).size(), 2U + 2U + 3U);
}

TEST(RunTable, FitsAHundredColumnsAtItsWidest) {
  RunRow wide = tracedRow();
  wide.scene = std::string(200, 's');
  wide.device = "vk-swiftshader-of-some-browser";
  wide.stage = "refined";
  wide.outcome = Outcome::kInconclusive;
  wide.summary->verdicts = VerdictCounts{0, 1, 99999, 99999, 99999, 99999, 99999, 99999};
  wide.summary->lookups = {1234.5, 60000, 60000, 60000};
  wide.passes[0].cold = {.wall_ns = 123'456'000'000, .cpu_ns = 123'456'000'000, .device_ns = {}};
  const std::vector<RunRow> rows = {wide};
  for (const std::string& line : linesOf(runTable(rows, {}))) {
    EXPECT_LE(columnsOf(line), 100U) << line;
  }
}

TEST(RunTable, ColoursOutcomeWordsOnlyAndOnlyWhenAsked) {
  const std::vector<RunRow> rows = {tracedRow(), rowOf("dda", "gl-osmesa", Outcome::kFail)};
  EXPECT_EQ(runTable(rows, {}).find('\x1b'), std::string::npos);
  const std::string coloured = runTable(rows, {.colour = true});
  EXPECT_NE(coloured.find("\x1b[32mpass\x1b[0m"), std::string::npos);
  EXPECT_NE(coloured.find("\x1b[31mfail\x1b[0m"), std::string::npos);
  EXPECT_EQ(std::ranges::count(coloured, '\x1b'), 4);
}

TEST(RunTable, IsEmptyWithoutRows) {
  EXPECT_EQ(runTable({}, {}), "");
}

TEST(WantsColour, RefusesAFileAndNoColor) {
  const int file = open("/dev/null", O_WRONLY);
  EXPECT_FALSE(wantsColour(file));
  close(file);
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0) {
    GTEST_SKIP() << "this system gives no pseudo-terminal";
  }
  unsetenv("NO_COLOR");
  setenv("TERM", "xterm", 1);
  EXPECT_TRUE(wantsColour(terminal));
  setenv("TERM", "dumb", 1);
  EXPECT_FALSE(wantsColour(terminal));
  setenv("TERM", "xterm", 1);
  setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(wantsColour(terminal));
  unsetenv("NO_COLOR");
  close(terminal);
}

}  // namespace
}  // namespace ssrkit
