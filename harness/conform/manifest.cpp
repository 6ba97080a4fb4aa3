#include "conform/manifest.h"

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "conform/json_fields.h"
#include "report/json_parts.h"

namespace ssrkit {

namespace {

constexpr const char* kPlanSchema = "ssrkit-conform-plan";
constexpr int kPlanVersion = 1;

DeviceRow deviceFrom(const JsonFields& fields) {
  const JsonFields traits = fields.object("traits");
  DeviceRow row;
  row.identity = {.id = fields.text("id"),
                  .api = fields.text("api"),
                  .driver = fields.text("driver"),
                  .version = fields.text("version"),
                  .cpu = fields.text("cpu"),
                  .cpu_features = fields.texts("cpu_features")};
  row.traits.loop_cap = static_cast<std::uint32_t>(traits.count("loop_cap"));
  row.traits.device_timer_usable = traits.flag("device_timer_usable");
  row.traits.shader_input = traits.text("shader_input");
  return row;
}

}  // namespace

std::string toJson(const Manifest& manifest) {
  Json devices = Json::array();
  for (const DeviceRow& device : manifest.devices) {
    devices.push_back(deviceOf(device));
  }
  Json absent = Json::array();
  for (const auto& [id, reason] : manifest.absent) {
    absent.push_back({{"id", id}, {"reason", reason}});
  }
  Json cells = Json::array();
  for (std::size_t i = 0; i < manifest.cells.size(); ++i) {
    cells.push_back({{"id", manifest.cells[i]}, {"shard", manifest.shard_of_cell[i]}});
  }
  const Json json = {{"schema", kPlanSchema},
                     {"schema_version", kPlanVersion},
                     {"kit_version", manifest.kit_version},
                     {"started", manifest.started},
                     {"command", manifest.command},
                     {"shard", {{"index", manifest.shard.index}, {"count", manifest.shard.count}}},
                     {"devices", std::move(devices)},
                     {"absent", std::move(absent)},
                     {"cells", std::move(cells)}};
  return jsonText(json, 1) + "\n";
}

Expected<Manifest> readManifest(std::string_view json, const std::string& file) {
  return readJsonObject(json, file, kPlanSchema, kPlanVersion, [](const JsonFields& fields) {
    Manifest manifest;
    manifest.kit_version = fields.text("kit_version");
    manifest.started = fields.text("started");
    manifest.command = fields.texts("command");
    const JsonFields shard = fields.object("shard");
    manifest.shard = {static_cast<int>(shard.count("index")), static_cast<int>(shard.count("count"))};
    for (const JsonFields& device : fields.objects("devices")) {
      manifest.devices.push_back(deviceFrom(device));
    }
    for (const JsonFields& device : fields.objects("absent")) {
      manifest.absent.emplace_back(device.text("id"), device.text("reason"));
    }
    for (const JsonFields& cell : fields.objects("cells")) {
      manifest.cells.push_back(cell.text("id"));
      manifest.shard_of_cell.push_back(static_cast<int>(cell.count("shard")));
    }
    return manifest;
  });
}

std::vector<std::string> ownCells(const Manifest& manifest) {
  std::vector<std::string> own;
  for (std::size_t i = 0; i < manifest.cells.size(); ++i) {
    if (manifest.shard_of_cell[i] == manifest.shard.index) {
      own.push_back(manifest.cells[i]);
    }
  }
  return own;
}

}  // namespace ssrkit
