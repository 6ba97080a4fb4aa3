#include "command/compile_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "command/compile_names.h"
#include "shader/source_tree.h"

namespace ssrkit {

namespace {

constexpr std::size_t kColumns = 100;

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

// All but the name of the API, so that two targets with one fault are told as one.
std::string faultText(const Error& error) {
  Error first = error;
  first.reasons.clear();
  first.attempted = "compile it";
  std::string text = wrapped("  " + sentence(first), 4) + "\n";
  for (std::size_t i = 1; i < error.reasons.size(); ++i) {
    text += wrapped("  " + error.reasons[i], 4) + "\n";
  }
  return text;
}

std::string headline(const CompileResult& result, bool use_colour) {
  if (!result.module) {
    return coloured(fmt::format("{}: does not compile", apiName(result.target)), "31", use_colour) + "\n";
  }
  const ShaderModule& module = *result.module;
  constexpr double kNsPerMs = 1e6;
  const std::size_t words = module.spirv.size();
  return coloured(fmt::format("{}: compiles", apiName(result.target)), "32", use_colour) +
         fmt::format(", {} bytes ({} words), {:.1f} ms{}\n", words * sizeof(std::uint32_t), words,
                     static_cast<double>(result.wall_ns) / kNsPerMs,
                     module.from_cache ? ", from the cache" : "");
}

std::string bodyText(const CompileResult& result) {
  return result.module ? interfaceText(result.module->interface) : faultText(result.module.error());
}

std::string includesText(std::span<const CompileResult> results) {
  const auto compiled = std::ranges::find_if(results, [](const CompileResult& result) {
    return result.module && result.module->dependencies.size() > 1;
  });
  if (compiled == results.end()) {
    return {};
  }
  std::string text = "includes\n";
  for (const std::filesystem::path& path : std::span(compiled->module->dependencies).subspan(1)) {
    text += wrapped("  " + shownPath(path), 4) + "\n";
  }
  return text;
}

}  // namespace

std::string compileReportText(const std::string& file, std::span<const CompileResult> results,
                              std::span<const CompiledFile> files, bool use_colour) {
  std::string text = wrapped(file, 4) + "\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    text += headline(results[i], use_colour);
    const std::string body = bodyText(results[i]);
    if (i + 1 == results.size() || bodyText(results[i + 1]) != body) {  // the same for the next: shown once
      text += body;
    }
  }
  text += includesText(results);
  for (const CompiledFile& written : files) {
    text += fmt::format("{}{}\n    {}, for {}\n", &written == files.data() ? "written\n  " : "  ",
                        written.path.string(), written.holds, written.devices);
  }
  return text;
}

}  // namespace ssrkit
