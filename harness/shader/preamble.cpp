#include <fmt/format.h>

#include <algorithm>

#include "shader/front_end.h"

namespace ssrkit {

namespace {

bool isIdentifier(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&is_letter](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

// A value may not end its own line, nor open a comment that swallows the next ones.
bool staysOnItsLine(const std::string& value) {
  const bool printable = std::all_of(value.begin(), value.end(), [](char c) { return c >= ' ' && c <= '~'; });
  return printable && !value.ends_with('\\') && value.find("/*") == std::string::npos &&
         value.find("//") == std::string::npos;
}

}  // namespace

bool isHlsl(const std::filesystem::path& file) {
  return file.extension() == ".hlsl";
}

Expected<std::string> makePreamble(const ShaderSource& source, ShaderTarget target,
                                   const std::string& attempted) {
  std::string preamble = "#define SSR_HLSL 1\n";
  if (!isHlsl(source.entry)) {
    preamble = fmt::format("#extension GL_GOOGLE_include_directive : require\n#define SSR_VERTEX_INDEX {}\n",
                           target == ShaderTarget::kVulkan ? "gl_VertexIndex" : "gl_VertexID");
  }
  for (const auto& [name, value] : source.defines) {
    if (!isIdentifier(name) || name.starts_with("gl_") || !staysOnItsLine(value)) {
      return inputError(attempted,
                        fmt::format("the define '{}={}' is no name with a value on one line", name, value));
    }
    preamble += fmt::format("#define {} {}\n", name, value);
  }
  return preamble;
}

}  // namespace ssrkit
