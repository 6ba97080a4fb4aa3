#include "command/devices.h"

#include <fmt/format.h>

#include <future>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/json_text.h"
#include "command/kit_paths.h"
#include "worker/supervisor.h"

namespace ssrkit {

namespace {

nlohmann::ordered_json toJson(const DeviceEntry& entry, const Expected<DeviceInfo>& info) {
  nlohmann::ordered_json json = {{"id", entry.id},
                                 {"about", entry.description},
                                 {"pipeline", entry.pipeline},
                                 {"rasteriser", entry.rasteriser},
                                 {"present", info.has_value()}};
  if (!info) {
    json["why_absent"] = sentence(info.error());
    return json;
  }
  json["api"] = info->identity.api;
  json["driver"] = info->identity.driver;
  json["version"] = info->identity.version;
  json["cpu"] = info->identity.cpu;
  json["cpu_features"] = info->identity.cpu_features;
  json["traits"] = {{"loop_cap", info->traits.loop_cap},
                    {"device_timer_usable", info->traits.device_timer_usable},
                    {"shader_input", info->traits.shader_input}};
  return json;
}

void print(const DeviceEntry& entry, const Expected<DeviceInfo>& info) {
  fmt::print("{:<15}{}\n", entry.id, entry.description);
  if (!info) {
    fmt::print("{:15}absent: {}\n", "", sentence(info.error()));
    return;
  }
  const DeviceTraits& traits = info->traits;
  fmt::print("{:15}{}, {}, {}\n", "", info->identity.api, info->identity.driver, info->identity.version);
  fmt::print("{:15}takes {}; pipeline {}, rasteriser {}; loops are {}; its timer is {}\n", "",
             traits.shader_input, entry.pipeline, entry.rasteriser,
             traits.loop_cap > 0 ? fmt::format("cut at {} iterations", traits.loop_cap) : "not cut",
             traits.device_timer_usable ? "right" : "wrong, wall and CPU time are used");
}

Expected<std::vector<const DeviceEntry*>> chosenEntries(const std::vector<std::string>& ids) {
  std::vector<const DeviceEntry*> entries;
  for (const std::string& id : ids) {
    const Expected<const DeviceEntry*> entry = findDevice(id);
    if (!entry) {
      return tl::make_unexpected(entry.error());
    }
    entries.push_back(*entry);
  }
  if (ids.empty()) {
    for (const DeviceEntry& entry : deviceEntries()) {
      entries.push_back(&entry);
    }
  }
  return entries;
}

}  // namespace

Expected<int> devicesCommand(const DevicesOptions& options) {
  const auto entries = chosenEntries(options.devices);
  if (!entries) {
    return tl::make_unexpected(entries.error());
  }
  std::vector<std::future<Expected<DeviceInfo>>> infos;
  for (const DeviceEntry* const entry : *entries) {
    infos.push_back(std::async(
        std::launch::async, [entry] { return Worker(*entry, {.shader_root = kitPaths().shaders}).info(); }));
  }
  bool all_present = true;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < infos.size(); ++i) {
    const DeviceEntry& entry = *(*entries)[i];
    const Expected<DeviceInfo> info = infos[i].get();
    all_present = all_present && info.has_value();
    if (options.json) {
      list.push_back(toJson(entry, info));
    } else {
      print(entry, info);
    }
  }
  if (options.json) {
    fmt::print("{}\n", jsonText(list, 2));
  }
  return all_present || options.devices.empty() ? 0 : 3;
}

}  // namespace ssrkit
