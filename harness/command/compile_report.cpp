#include "command/compile_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace ssrkit {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kColumns = 100;

std::string apiName(ShaderTarget target) {
  return target == ShaderTarget::kVulkan ? "Vulkan 1.1" : "OpenGL 4.5";
}

std::string scalarName(ScalarType type) {
  return type == ScalarType::kFloat ? "float" : type == ScalarType::kInt ? "int" : "uint";
}

std::string vectorName(ScalarType type, std::uint32_t size) {
  if (size == 1) {
    return scalarName(type);
  }
  const std::string prefix = type == ScalarType::kFloat ? "" : type == ScalarType::kInt ? "i" : "u";
  return fmt::format("{}vec{}", prefix, size);
}

std::string memberType(const BlockMember& member) {
  std::string type = member.columns > 1 ? fmt::format("mat{}x{}", member.columns, member.rows)
                                        : vectorName(member.type, member.rows);
  return member.array_count == 0 ? type : fmt::format("{}[{}]", type, member.array_count);
}

std::string samplerName(SamplerKind kind) {
  return kind == SamplerKind::kFloat ? "sampler" : kind == SamplerKind::kInt ? "isampler" : "usampler";
}

std::string defaultText(const SpecConstantInfo& constant) {
  switch (constant.type) {
    case ScalarType::kFloat:
      return fmt::format("{}", std::bit_cast<float>(constant.default_bits));
    case ScalarType::kInt:
      return fmt::format("{}", static_cast<std::int32_t>(constant.default_bits));
    default:
      return fmt::format("{}", constant.default_bits);
  }
}

// Breaks between words, or inside one that is longer than a line; continuation lines are indented as told.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string result;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t room = kColumns - column;
    if (text.size() <= room) {
      return result + std::string(text);
    }
    const std::size_t blank = text.rfind(' ', room);
    const bool at_blank = blank != std::string_view::npos && blank > indent;
    const std::size_t length = at_blank ? blank : room;
    result += std::string(text.substr(0, length)) + "\n" + std::string(indent, ' ');
    text.remove_prefix(length + (at_blank ? 1 : 0));
    column = indent;
  }
  return result;
}

std::string line(std::string_view text) {
  return wrapped(text, 12) + "\n";
}

std::string interfaceText(const ShaderInterface& interface) {
  std::string text;
  for (const SamplerBinding& sampler : interface.samplers) {
    text +=
        line(fmt::format("  binding {:>2}  {} {}", sampler.binding, samplerName(sampler.kind), sampler.name));
  }
  for (const UniformBlock& block : interface.uniform_blocks) {
    text +=
        line(fmt::format("  binding {:>2}  block {}, {} bytes", block.binding, block.name, block.size_bytes));
    for (const BlockMember& member : block.members) {
      text +=
          line(fmt::format("     {:>6}    {:<10} {}", member.offset_bytes, memberType(member), member.name));
    }
  }
  const auto add_variables = [&text](std::string_view kind, const std::vector<StageVariable>& variables) {
    for (const StageVariable& variable : variables) {
      text += line(fmt::format("  {:<6} {:>3}  {:<10} {}", kind, variable.location,
                               vectorName(variable.type, variable.components), variable.name));
    }
  };
  add_variables("in", interface.inputs);
  add_variables("out", interface.outputs);
  for (const SpecConstantInfo& constant : interface.spec_constants) {
    text += line(fmt::format("  const  {:>3}  {:<10} {} = {}", constant.id, scalarName(constant.type),
                             constant.name, defaultText(constant)));
  }
  return text;
}

std::string coloured(std::string text, std::string_view code, bool use_colour) {
  return use_colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : text;
}

std::string resultText(const CompileResult& result, bool use_colour) {
  const std::string api = apiName(result.target);
  if (!result.module) {
    std::string text = coloured(fmt::format("{}: does not compile", api), "31", use_colour) + "\n";
    const Error& error = result.module.error();
    Error first = error;
    first.reasons.clear();
    text += wrapped("  " + sentence(first), 4) + "\n";
    for (std::size_t i = 1; i < error.reasons.size(); ++i) {
      text += wrapped("  " + error.reasons[i], 4) + "\n";
    }
    return text;
  }
  const ShaderModule& module = *result.module;
  constexpr double kNsPerMs = 1e6;
  const std::size_t words = module.spirv.size();
  return coloured(fmt::format("{}: compiles", api), "32", use_colour) +
         fmt::format(", {} bytes ({} words), {:.1f} ms{}\n", words * sizeof(std::uint32_t), words,
                     static_cast<double>(result.wall_ns) / kNsPerMs,
                     module.from_cache ? ", from the cache" : "") +
         interfaceText(module.interface);
}

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

std::string compileReportText(const std::string& file, std::span<const CompileResult> results,
                              bool use_colour) {
  std::string text = wrapped(file, 4) + "\n";
  for (const CompileResult& result : results) {
    text += resultText(result, use_colour);
  }
  for (const CompileResult& result : results) {
    if (result.module && result.module->dependencies.size() > 1) {
      text += "includes\n";
      for (std::size_t i = 1; i < result.module->dependencies.size(); ++i) {
        text += wrapped("  " + result.module->dependencies[i].string(), 4) + "\n";
      }
      break;
    }
  }
  return text;
}

std::string compileReportJson(const std::string& file, std::span<const CompileResult> results) {
  Json json = {{"file", file}, {"targets", Json::array()}};
  std::ranges::transform(results, std::back_inserter(json["targets"]), resultJson);
  // Bytes of a shader that are no UTF-8 must not throw here.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ssrkit
