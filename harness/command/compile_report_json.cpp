#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/json_text.h"
#include "command/compile_names.h"
#include "command/compile_report.h"

namespace ssrkit {

namespace {

using Json = nlohmann::ordered_json;

Json memberJson(const BlockMember& member) {
  return {{"name", member.name},
          {"type", scalarName(member.type)},
          {"offset_bytes", member.offset_bytes},
          {"rows", member.rows},
          {"columns", member.columns},
          {"matrix_stride_bytes", member.matrix_stride_bytes},
          {"array_count", member.array_count},
          {"array_stride_bytes", member.array_stride_bytes}};
}

Json variablesJson(const std::vector<StageVariable>& variables) {
  Json list = Json::array();
  for (const StageVariable& variable : variables) {
    list.push_back({{"name", variable.name},
                    {"location", variable.location},
                    {"type", scalarName(variable.type)},
                    {"components", variable.components}});
  }
  return list;
}

Json interfaceJson(const ShaderInterface& interface) {
  Json samplers = Json::array();
  for (const SamplerBinding& sampler : interface.samplers) {
    samplers.push_back(
        {{"name", sampler.name}, {"binding", sampler.binding}, {"kind", samplerName(sampler.kind)}});
  }
  Json blocks = Json::array();
  for (const UniformBlock& block : interface.uniform_blocks) {
    Json members = Json::array();
    std::ranges::transform(block.members, std::back_inserter(members), memberJson);
    blocks.push_back({{"name", block.name},
                      {"binding", block.binding},
                      {"size_bytes", block.size_bytes},
                      {"members", std::move(members)}});
  }
  Json constants = Json::array();
  for (const SpecConstantInfo& constant : interface.spec_constants) {
    constants.push_back({{"name", constant.name},
                         {"id", constant.id},
                         {"type", scalarName(constant.type)},
                         {"default_bits", constant.default_bits}});
  }
  return {{"samplers", std::move(samplers)},
          {"uniform_blocks", std::move(blocks)},
          {"inputs", variablesJson(interface.inputs)},
          {"outputs", variablesJson(interface.outputs)},
          {"spec_constants", std::move(constants)}};
}

Json resultJson(const CompileResult& result) {
  Json json = {{"api", apiName(result.target)}, {"compiles", result.module.has_value()}};
  if (!result.module) {
    const Error& error = result.module.error();
    json["error"] = {{"where", error.where},
                     {"attempted", error.attempted},
                     {"problem", error.problem},
                     {"remedy", error.remedy},
                     {"reasons", error.reasons}};
    return json;
  }
  const ShaderModule& module = *result.module;
  json["spirv_words"] = module.spirv.size();
  json["spirv_bytes"] = module.spirv.size() * sizeof(std::uint32_t);
  json["from_cache"] = module.from_cache;
  json["time_ns"] = result.wall_ns;
  json["interface"] = interfaceJson(module.interface);
  json["dependencies"] = Json::array();
  for (const std::filesystem::path& path : module.dependencies) {
    json["dependencies"].push_back(path.string());
  }
  return json;
}

}  // namespace

std::string compileReportJson(const std::string& file, std::span<const CompileResult> results,
                              std::span<const CompiledFile> files) {
  Json json = {{"schema", "ssrkit-compile"},
               {"schema_version", kCompileSchemaVersion},
               {"file", file},
               {"targets", Json::array()},
               {"files", Json::array()}};
  std::ranges::transform(results, std::back_inserter(json["targets"]), resultJson);
  for (const CompiledFile& written : files) {
    json["files"].push_back(
        {{"path", written.path.string()}, {"holds", written.holds}, {"devices", written.devices}});
  }
  return jsonText(json, 2) + "\n";
}

}  // namespace ssrkit
