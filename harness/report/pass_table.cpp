#include "report/pass_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "report/table_text.h"

namespace ssrkit {

namespace {

constexpr std::size_t kNameColumns = 24;
constexpr std::size_t kDeviceColumns = 20;
constexpr std::size_t kMostDevices = 3;  // a hundred columns hold no more

struct Times {
  std::string device;
  std::vector<PassReport> passes;
};

// One trace on all devices.
struct TraceGroup {
  const RunRow* row = nullptr;  // the first device's
  std::vector<Times> devices;
};

bool isSameTrace(const RunRow& a, const RunRow& b) {
  return a.scene == b.scene && a.size == b.size && a.stage == b.stage && a.case_name == b.case_name;
}

// The passes of the frame, then those of the trace.
std::vector<PassReport> allPassesOf(const RunRow& row, std::span<const FrameRow> frames) {
  std::vector<PassReport> passes;
  const auto frame = std::ranges::find_if(frames, [&](const FrameRow& candidate) {
    return candidate.scene == row.scene && candidate.size == row.size && candidate.device == row.device;
  });
  if (frame != frames.end()) {
    passes = frame->passes;
  }
  passes.insert(passes.end(), row.passes.begin(), row.passes.end());
  return passes;
}

std::vector<TraceGroup> groupsOf(std::span<const FrameRow> frames, std::span<const RunRow> rows) {
  std::vector<TraceGroup> groups;
  for (const RunRow& row : rows) {
    if (row.passes.empty()) {
      continue;
    }
    auto group =
        std::ranges::find_if(groups, [&](const TraceGroup& known) { return isSameTrace(*known.row, row); });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), {.row = &row, .devices = {}});
    }
    if (group->devices.size() < kMostDevices) {
      group->devices.push_back({row.device, allPassesOf(row, frames)});
    }
  }
  return groups;
}

double passCpuMs(const Times& times, std::string_view pass) {
  const auto found = std::ranges::find(times.passes, pass, &PassReport::pass);
  return found == times.passes.end() ? 0.0 : cpuMs(*found);
}

double wholeOf(const Times& times) {
  double sum = 0.0;
  for (const PassReport& pass : times.passes) {
    sum += cpuMs(pass);
  }
  return sum;
}

std::string passLine(std::string_view name, const TraceGroup& group, const std::vector<double>& cpu_ms) {
  std::string text = fmt::format("  {:<{}}", cellText(name, kNameColumns), kNameColumns);
  for (std::size_t i = 0; i < group.devices.size(); ++i) {
    const double trace = passCpuMs(group.devices[i], "trace");
    const std::string multiple = trace > 0.0 ? fmt::format("{:.2f} x", cpu_ms[i] / trace) : "-";
    text += fmt::format("{:>{}}{:>9}", measureText(cpu_ms[i]), kDeviceColumns - 9, multiple);
  }
  return text + "\n";
}

std::string traceGroupText(const TraceGroup& group) {
  const RunRow& row = *group.row;
  std::string text =
      fmt::format("{} {}x{} {}{}{}, CPU ms and multiples of the trace\n", row.scene, row.size.width,
                  row.size.height, row.stage, row.case_name.empty() ? "" : " ", row.case_name);
  text += fmt::format("  {:<{}}", "pass", kNameColumns);
  for (const Times& times : group.devices) {
    text += fmt::format("{:>{}}", cellText(times.device, kDeviceColumns - 1), kDeviceColumns);
  }
  text += "\n";
  const auto add = [&](std::string_view name, const auto& timeOf) {
    std::vector<double> cpu_ms;
    for (const Times& times : group.devices) {
      cpu_ms.push_back(timeOf(times));
    }
    text += passLine(name, group, cpu_ms);
  };
  for (const PassReport& pass : group.devices.front().passes) {
    add(pass.pass, [&](const Times& times) { return passCpuMs(times, pass.pass); });
  }
  add("whole frame", wholeOf);
  return text;
}

}  // namespace

std::string passTable(std::span<const FrameRow> frames, std::span<const RunRow> rows) {
  std::string text;
  for (const TraceGroup& group : groupsOf(frames, rows)) {
    text += traceGroupText(group);
  }
  return text;
}

}  // namespace ssrkit
