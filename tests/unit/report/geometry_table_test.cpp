#include "report/geometry_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.h"
#include "report/table_text.h"

namespace ssrkit {
namespace {

GeometryRow geometryRow() {
  GeometryRow row;
  row.scene = "clutter";
  row.size = {640, 360};
  row.counts.rays = {100, 600, 50, 150, 100, 60, 40};
  row.counts.verdicts[1] = {0, 560, 30, 10, 0};
  row.counts.verdicts[2] = {0, 20, 20, 0, 10};
  row.counts.verdicts[3] = {0, 0, 100, 0, 50};
  row.counts.verdicts[6] = {0, 0, 0, 0, 40};
  return row;
}

RunRow tracedRow() {
  RunRow row;
  row.scene = "clutter";
  row.device = "gl-osmesa";
  row.stage = "dda";
  row.size = {640, 360};
  row.true_classes = TrueClassSummary{};
  row.true_classes->against_oracle[1] = {0, 590, 0, 0, 0, 3, 7, 0};
  row.true_classes->against_oracle[6] = {0, 40, 0, 0, 0, 0, 0, 0};
  return row;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells = split(line, ' ');
  std::erase(cells, "");
  return cells;
}

TEST(GeometryTable, GivesSharesOfTheRays) {
  const std::vector<GeometryRow> rows = {geometryRow()};
  const std::vector<std::string> lines = split(geometryTable(rows), '\n');
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(cellsOf(lines[1]),
            (std::vector<std::string>{"scene", "rays", "VISIBLE", "UNSAMPLED", "OCCLUDED", "BACKFACE",
                                      "OFFSCREEN", "SKY", "TRUE", "FALSE", "MISSED", "NONE"}));
  EXPECT_EQ(cellsOf(lines[2]), (std::vector<std::string>{"clutter", "1000", "60.00", "5.00", "15.00", "10.00",
                                                         "6.00", "4.00", "58.00", "15.00", "1.00", "10.00"}));
}

TEST(GeometryTable, NamesACaseInFull) {
  GeometryRow row = geometryRow();
  row.case_name = "normals_octahedral";
  const std::vector<GeometryRow> rows = {row};
  const std::vector<std::string> lines = split(geometryTable(rows), '\n');
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[2], "clutter normals_octahedral");
  EXPECT_EQ(cellsOf(lines[3]).front(), "1000");
  EXPECT_EQ(columnsOf(lines[3]), columnsOf(lines[1]));
}

TEST(GeometryTable, FitsAHundredColumnsAtItsWidest) {
  GeometryRow wide = geometryRow();
  wide.scene = std::string(80, 's');
  wide.case_name = "t_inf";
  for (std::size_t i = 1; i < wide.counts.rays.size(); ++i) {
    wide.counts.rays[i] = 10'000'000;
    wide.counts.verdicts[i] = {0, 10'000'000, 10'000'000, 10'000'000, 10'000'000};
  }
  RunRow row = tracedRow();
  row.scene = std::string(120, 's');
  row.stage = "a-stage-of-a-long-name";
  for (VerdictCounts& counts : row.true_classes->against_oracle) {
    counts.fill(10'000'000);
  }
  const std::vector<GeometryRow> rows = {wide};
  const std::vector<RunRow> traces = {row};
  for (const std::string& line : split(geometryTable(rows) + trueClassTable(traces), '\n')) {
    EXPECT_LE(columnsOf(line), 100U) << line;
  }
}

TEST(GeometryTable, ShowsDashesWithoutRaysAndNothingWithoutRows) {
  GeometryRow empty = geometryRow();
  empty.counts = {};
  const std::vector<GeometryRow> rows = {empty};
  const std::vector<std::string> cells = cellsOf(split(geometryTable(rows), '\n')[2]);
  EXPECT_EQ(std::ranges::count(cells, "-"), 10);
  EXPECT_EQ(geometryTable({}), "");
}

TEST(TrueClassTable, ShowsTheVerdictsThatOccur) {
  RunRow without = tracedRow();
  without.true_classes.reset();
  const std::vector<RunRow> rows = {tracedRow(), without};
  const std::vector<std::string> lines = split(trueClassTable(rows), '\n');
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(cellsOf(lines[2]), (std::vector<std::string>{"dda", "SAME", "590", "0", "0", "0", "0", "40"}));
  EXPECT_EQ(cellsOf(lines[3]), (std::vector<std::string>{"MISSED_HIT", "3", "0", "0", "0", "0", "0"}));
  EXPECT_EQ(cellsOf(lines[4]), (std::vector<std::string>{"LEAK", "7", "0", "0", "0", "0", "0"}));
  EXPECT_EQ(trueClassTable(std::vector<RunRow>{without}), "");
}

}  // namespace
}  // namespace ssrkit
