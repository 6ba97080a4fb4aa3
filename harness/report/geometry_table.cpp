#include "report/geometry_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/table_text.h"

namespace ssrkit {

namespace {

// A column for each true class: its heading and width.
struct ClassColumn {
  TrueClass true_class;
  const char* heading;
  std::size_t width;
};
constexpr std::array<ClassColumn, 6> kClassColumns = {{{TrueClass::kVisible, "VISIBLE", 8},
                                                       {TrueClass::kUnsampled, "UNSAMPLED", 10},
                                                       {TrueClass::kOccluded, "OCCLUDED", 9},
                                                       {TrueClass::kBackface, "BACKFACE", 9},
                                                       {TrueClass::kOffscreen, "OFFSCREEN", 10},
                                                       {TrueClass::kSky, "SKY", 7}}};
struct VerdictColumn {
  GeometryVerdict verdict;
  const char* heading;
  std::size_t width;
};
constexpr std::array<VerdictColumn, 4> kVerdictColumns = {{{GeometryVerdict::kTrueHit, "TRUE", 8},
                                                           {GeometryVerdict::kFalseHit, "FALSE", 6},
                                                           {GeometryVerdict::kMissedHit, "MISSED", 7},
                                                           {GeometryVerdict::kTrueMiss, "NONE", 7}}};
constexpr std::size_t kLineWidth = 100;
constexpr std::size_t kSceneWidth = 12;
constexpr std::size_t kRaysWidth = 7;
constexpr std::size_t kStageWidth = 12;
constexpr std::size_t kVerdictWidth = 11;

std::string percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? "-" : percentText(static_cast<double>(part) / static_cast<double>(whole), 2);
}

template <class Columns>
std::size_t widthOfAll(const Columns& columns) {
  std::size_t sum = 0;
  for (const auto& column : columns) {
    sum += column.width;
  }
  return sum;
}

std::string classHeadings() {
  std::string text;
  for (const ClassColumn& column : kClassColumns) {
    text += fmt::format("{:>{}}", column.heading, column.width);
  }
  return text;
}

std::string geometryHeadings() {
  std::string text = fmt::format("{:>{}}{:>{}}\n{:<{}}{:>{}}", "what the rays truly meet, %",
                                 kSceneWidth + kRaysWidth + widthOfAll(kClassColumns), "hits of Oracle A, %",
                                 widthOfAll(kVerdictColumns), "scene", kSceneWidth, "rays", kRaysWidth);
  text += classHeadings();
  for (const VerdictColumn& column : kVerdictColumns) {
    text += fmt::format("{:>{}}", column.heading, column.width);
  }
  return text + "\n";
}

// A case has a line of its own: its name finds no room beside the numbers.
std::string geometryLabel(const GeometryRow& row) {
  const std::string scene = cellText(row.scene, kSceneWidth);
  const std::string blanks(kSceneWidth, ' ');
  return row.case_name.empty() ? scene + blanks.substr(columnsOf(scene))
                               : cellText(row.scene + " " + row.case_name, kLineWidth) + "\n" + blanks;
}

std::string geometryLine(const GeometryRow& row) {
  const std::size_t rays = row.counts.rayCount();
  std::string text = geometryLabel(row);
  text += fmt::format("{:>{}}", countText(rays), kRaysWidth);
  for (const ClassColumn& column : kClassColumns) {
    const std::size_t of_class = row.counts.rays.at(static_cast<std::size_t>(column.true_class));
    text += fmt::format("{:>{}}", percent(of_class, rays), column.width);
  }
  for (const VerdictColumn& column : kVerdictColumns) {
    text += fmt::format("{:>{}}", percent(row.counts.count(column.verdict), rays), column.width);
  }
  return text + "\n";
}

std::string trueClassLines(const RunRow& row) {
  std::string text;
  for (int v = 1; v < kVerdictCount; ++v) {
    const auto verdict = static_cast<std::size_t>(v);
    const auto& by_class = row.true_classes->against_oracle;
    if (std::ranges::all_of(by_class, [&](const VerdictCounts& counts) { return counts.at(verdict) == 0; })) {
      continue;
    }
    text += fmt::format("  {:<{}}{:<{}}", text.empty() ? cellText(row.stage, kStageWidth - 1) : "",
                        kStageWidth, name(static_cast<Verdict>(v)), kVerdictWidth);
    for (const ClassColumn& column : kClassColumns) {
      const VerdictCounts& counts = by_class.at(static_cast<std::size_t>(column.true_class));
      text += fmt::format("{:>{}}", countText(counts.at(verdict)), column.width);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string geometryTable(std::span<const GeometryRow> rows) {
  std::string text;
  for (const GeometryRow& row : rows) {
    text += geometryLine(row);
  }
  return text.empty() ? text : geometryHeadings() + text;
}

std::string trueClassTable(std::span<const RunRow> rows) {
  std::string text;
  std::string heading;
  for (const RunRow& row : rows) {
    if (!row.true_classes) {
      continue;
    }
    const std::string case_text = row.case_name.empty() ? "" : " " + row.case_name;
    std::string own = fmt::format("{} {}x{}{} {}: rays by verdict against Oracle A and by what they meet",
                                  row.scene, row.size.width, row.size.height, case_text, row.device);
    own = cellText(own, kLineWidth);
    if (own != heading) {
      text +=
          fmt::format("{}\n{}{}\n", own, std::string(2 + kStageWidth + kVerdictWidth, ' '), classHeadings());
      heading = std::move(own);
    }
    text += trueClassLines(row);
  }
  return text;
}

}  // namespace ssrkit
