#include "device/identity.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

namespace ssrkit {
namespace {

// The instruction sets that LLVM and Subzero choose between when they compile a shader (x86, then Arm).
constexpr std::array<std::string_view, 15> kFeatures{
    "sse4_1",   "sse4_2",   "avx",      "avx2",  "fma",     "f16c",    "avx512f", "avx512bw",
    "avx512dq", "avx512vl", "avx512cd", "asimd", "asimdhp", "asimddp", "sve"};

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) {
    return {};
  }
  return std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

std::vector<std::string> knownFeatures(const std::string& flags) {
  std::istringstream stream(flags);
  const std::vector<std::string> present{std::istream_iterator<std::string>(stream), {}};
  std::vector<std::string> known;
  for (const std::string_view feature : kFeatures) {
    if (std::ranges::find(present, feature) != present.end()) {
      known.emplace_back(feature);
    }
  }
  return known;
}

}  // namespace

CpuIdentity parseCpuInfo(std::string_view cpuinfo) {
  CpuIdentity identity;
  std::istringstream lines{std::string(cpuinfo)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) {
      continue;
    }
    const std::string key = trimmed(std::string_view(line).substr(0, colon));
    const std::string value = trimmed(std::string_view(line).substr(colon + 1));
    if (key == "model name" && identity.model.empty()) {
      identity.model = value;
    } else if ((key == "flags" || key == "Features") && identity.features.empty()) {
      identity.features = knownFeatures(value);
    }
  }
  if (identity.model.empty()) {
    identity.model = "unknown";
  }
  return identity;
}

CpuIdentity cpuIdentity() {
  std::ifstream file("/proc/cpuinfo");
  return parseCpuInfo(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace ssrkit
