#include "check/finding_map.h"

#include <algorithm>
#include <cstddef>

namespace ssrkit {

namespace {

constexpr int kMostColumns = 160;
constexpr int kMostRows = 90;

// Above 64 for the least severe finding, 255 for the worst; equal severities are equally bright.
std::uint8_t brightness(double severity, const std::vector<double>& sorted) {
  const auto upper = std::ranges::upper_bound(sorted, severity);
  const double rank = static_cast<double>(upper - sorted.begin()) / static_cast<double>(sorted.size());
  constexpr double kLeast = 64.0;  // still told apart from the ground
  return static_cast<std::uint8_t>(kLeast + (255.0 - kLeast) * rank);
}

}  // namespace

FindingMap findingMap(Size size, std::span<const Finding> findings) {
  const int step = std::max(
      {1, (size.width + kMostColumns - 1) / kMostColumns, (size.height + kMostRows - 1) / kMostRows});
  FindingMap map;
  map.size = {(size.width + step - 1) / step, (size.height + step - 1) / step};
  map.dots.assign(static_cast<std::size_t>(map.size.width) * static_cast<std::size_t>(map.size.height), 0);
  std::vector<double> sorted;
  sorted.reserve(findings.size());
  for (const Finding& finding : findings) {
    sorted.push_back(finding.severity);
  }
  std::ranges::sort(sorted);
  for (const Finding& finding : findings) {
    const bool is_inside =
        finding.x >= 0 && finding.y >= 0 && finding.x < size.width && finding.y < size.height;
    if (is_inside) {
      const auto index =
          static_cast<std::size_t>(finding.y / step) * static_cast<std::size_t>(map.size.width) +
          static_cast<std::size_t>(finding.x / step);
      map.dots[index] = std::max(map.dots[index], brightness(finding.severity, sorted));
    }
  }
  return map;
}

}  // namespace ssrkit
