#include "report/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ssrkit {

namespace {

bool startsCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

bool isControl(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return code < 0x20 || code == 0x7F;
}

}  // namespace

std::string percentText(double fraction, int decimals) {
  const double scale = std::pow(10.0, decimals);
  constexpr double kRoundingSlack = 1e-9;  // 0.29 * 100 is 28.999...96
  return fmt::format("{:.{}f}", std::floor(fraction * 100.0 * scale + kRoundingSlack) / scale, decimals);
}

std::string countText(std::size_t count) {
  if (count < 100'000) {
    return fmt::format("{}", count);
  }
  if (count < 1'000'000) {
    return fmt::format("{}k", count / 1000);
  }
  const double millions = static_cast<double>(count) * 1e-6;
  return millions < 99.9 ? fmt::format("{:.1f}M", millions) : fmt::format("{:.0f}M", millions);
}

std::string measureText(double value) {
  if (!std::isfinite(value)) {
    return fmt::format("{}", value);
  }
  const double size = std::abs(value);
  const int decimals = size >= 99.95 || size == 0.0 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 ? 2 : 3;
  return fmt::format("{:.{}f}", value, decimals);
}

std::size_t columnsOf(std::string_view text) {
  std::size_t columns = 0;
  for (const char byte : text) {
    columns += startsCharacter(byte) ? 1 : 0;
  }
  return columns;
}

std::string cellText(std::string_view text, std::size_t columns) {
  constexpr std::string_view kCut = "..";
  const bool is_cut = columnsOf(text) > columns;
  const std::size_t kept = is_cut ? columns - std::min(columns, kCut.size()) : columns;
  std::string cell;
  std::size_t taken = 0;
  for (const char byte : text) {
    taken += startsCharacter(byte) ? 1 : 0;
    if (taken > kept) {
      break;
    }
    cell += isControl(byte) ? '?' : byte;
  }
  return is_cut ? cell + std::string(kCut.substr(0, columns)) : cell;
}

}  // namespace ssrkit
