#include "command/compile_files.h"

#include <fmt/format.h>

#include <bit>
#include <utility>

#include "base/atomic_file.h"
#include "shader/glsl_translation.h"
#include "shader/spirv_tools.h"

namespace ssrkit {

namespace {

struct Content {
  CompiledFile file;
  std::string bytes;
};

struct Translated {
  const char* device;
  GlslVersion version;
  const char* holds;
};
constexpr Translated kTranslated[] = {{"gl-glsl", GlslVersion::k450, "GLSL 450"},
                                      {"gl-softpipe", GlslVersion::k330, "GLSL 330"}};

std::string bytesOf(const std::vector<std::uint32_t>& words) {
  static_assert(std::endian::native == std::endian::little);
  return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t)};
}

Expected<void> addFiles(const std::filesystem::path& folder, const std::string& name,
                        const CompileResult& result, std::vector<Content>& contents) {
  const std::string attempted = fmt::format("show the module of '{}'", name);
  const std::vector<std::uint32_t>& spirv = result.module->spirv;
  const bool is_vulkan = result.target == ShaderTarget::kVulkan;
  const std::string module_name = name + (is_vulkan ? ".vulkan" : ".opengl");
  const std::string devices = is_vulkan ? "Vulkan devices" : "OpenGL devices that take SPIR-V";
  auto text = disassembleSpirv(spirv, result.target, attempted);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  contents.push_back({{folder / (module_name + ".spv"), "SPIR-V", devices}, bytesOf(spirv)});
  contents.push_back(
      {{folder / (module_name + ".spvasm"), "SPIR-V, disassembled", devices}, *std::move(text)});
  if (is_vulkan) {
    return {};
  }
  for (const Translated& row : kTranslated) {
    auto glsl = translateToGlsl(spirv, row.version, {});
    if (!glsl) {
      return tl::make_unexpected(glsl.error());
    }
    contents.push_back(
        {{folder / fmt::format("{}.{}.glsl", name, row.device), row.holds, row.device}, *std::move(glsl)});
  }
  return {};
}

}  // namespace

Expected<std::vector<CompiledFile>> writeCompiled(const std::filesystem::path& folder,
                                                  const std::string& name,
                                                  std::span<const CompileResult> results) {
  std::vector<Content> contents;
  for (const CompileResult& result : results) {
    if (auto added = addFiles(folder, name, result, contents); !added) {
      return tl::make_unexpected(added.error());
    }
  }
  std::vector<CompiledFile> files;
  for (const Content& content : contents) {
    if (auto written = writeFileAtomically(content.file.path, content.bytes); !written) {
      return tl::make_unexpected(written.error());
    }
    files.push_back(content.file);
  }
  return files;
}

}  // namespace ssrkit
