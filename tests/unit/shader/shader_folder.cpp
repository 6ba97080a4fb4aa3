#include "shader_folder.h"

#include <cstdlib>
#include <fstream>

namespace ssrkit {

namespace fs = std::filesystem;

void ShaderFolder::SetUp() {
  std::string name = (fs::temp_directory_path() / "ssrkit-shader-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  folder_ = fs::canonical(name);
  fs::create_directories(root() / "include");
  ASSERT_EQ(setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1), 0);
}

void ShaderFolder::TearDown() {
  fs::remove_all(folder_);
}

fs::path ShaderFolder::write(const std::string& name, std::string_view text) const {
  fs::path path = folder_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

Expected<ShaderModule> ShaderFolder::compileFragment(std::string_view text, ShaderTarget target) const {
  write("shaders/a.frag", text);
  return compileEntry("a.frag", target);
}

Expected<ShaderModule> ShaderFolder::compileEntry(const fs::path& entry, ShaderTarget target,
                                                  const CompileOptions& options) const {
  const ShaderStage stage = entry.extension() == ".vert" ? ShaderStage::kVertex : ShaderStage::kFragment;
  return compileShader({root(), entry, stage, {}}, target, options);
}

Error ShaderFolder::errorOf(std::string_view text, ShaderTarget target) const {
  const Expected<ShaderModule> module = compileFragment(text, target);
  return module ? Error{} : module.error();
}

}  // namespace ssrkit
