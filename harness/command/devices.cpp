#include "command/devices.h"

#include <fmt/format.h>

#include <future>
#include <nlohmann/json.hpp>
#include <vector>

#include "command/kit_paths.h"
#include "worker/supervisor.h"

namespace ssrkit {

namespace {

nlohmann::ordered_json toJson(const DeviceEntry& entry, const Expected<DeviceInfo>& info) {
  nlohmann::ordered_json json = {
      {"id", entry.id}, {"about", entry.description}, {"present", info.has_value()}};
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
  fmt::print("{:<14}{}\n", entry.id, entry.description);
  if (!info) {
    fmt::print("{:14}absent: {}\n", "", sentence(info.error()));
    return;
  }
  const DeviceTraits& traits = info->traits;
  fmt::print("{:14}{}, {}, {}\n", "", info->identity.api, info->identity.driver, info->identity.version);
  fmt::print("{:14}takes {}; loops are {}; its timer is {}\n", "", traits.shader_input,
             traits.loop_cap > 0 ? fmt::format("cut at {} iterations", traits.loop_cap) : "not cut",
             traits.device_timer_usable ? "right" : "wrong, wall and CPU time are used");
}

}  // namespace

Expected<int> devicesCommand(bool json) {
  std::vector<std::future<Expected<DeviceInfo>>> infos;
  for (const DeviceEntry& entry : deviceEntries()) {
    infos.push_back(std::async(
        std::launch::async, [&entry] { return Worker(entry, {.shader_root = kitPaths().shaders}).info(); }));
  }
  bool all_present = true;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < infos.size(); ++i) {
    const DeviceEntry& entry = deviceEntries()[i];
    const Expected<DeviceInfo> info = infos[i].get();
    all_present = all_present && info.has_value();
    if (json) {
      list.push_back(toJson(entry, info));
    } else {
      print(entry, info);
    }
  }
  if (json) {
    fmt::print("{}\n", list.dump(2));
  }
  return all_present ? 0 : 3;
}

}  // namespace ssrkit
