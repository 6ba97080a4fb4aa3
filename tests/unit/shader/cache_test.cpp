#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <thread>
#include <vector>

#include "shader_folder.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;

class Cache : public ShaderFolder {
 protected:
  void SetUp() override {
    ShaderFolder::SetUp();
    write("shaders/include/f.glsl", "float f(float x) { return x; }\n");
    write("shaders/a.frag",
          "#version 450\n#include \"f.glsl\"\nlayout(binding = 2) uniform sampler2D image;\nlayout(std140, "
          "binding = 1) "
          "uniform U { float scale; };\nlayout(location = 0) out float y;\nvoid main() { y = f(scale); }\n");
  }
  [[nodiscard]] ShaderModule compileCached(const CompileOptions& options = {},
                                           ShaderTarget target = ShaderTarget::kOpenGl) const {
    const Expected<ShaderModule> module = compileEntry("a.frag", target, options);
    EXPECT_TRUE(module) << sentence(module.error());
    return module.value_or(ShaderModule{});
  }
  [[nodiscard]] std::vector<fs::path> entries() const {
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(cacheFolder())) {
      paths.push_back(entry.path());
    }
    return paths;
  }
};

TEST_F(Cache, GivesTheSameModuleTheSecondTime) {
  const ShaderModule cold = compileCached();
  const ShaderModule warm = compileCached();
  EXPECT_FALSE(cold.from_cache);
  EXPECT_TRUE(warm.from_cache);
  EXPECT_EQ(warm.spirv, cold.spirv);
  EXPECT_EQ(warm.dependencies, cold.dependencies);
  ASSERT_EQ(warm.interface.samplers.size(), 1U);
  EXPECT_EQ(warm.interface.samplers[0].name, "image");
  ASSERT_EQ(warm.interface.uniform_blocks.size(), 1U);
  EXPECT_EQ(warm.interface.uniform_blocks[0].members[0].name, "scale");
  EXPECT_EQ(warm.interface.outputs[0].name, "y");
}

TEST_F(Cache, MissesWhenAnyByteOfAnyFileChanges) {
  static_cast<void>(compileCached());
  write("shaders/include/f.glsl", "float f(float x) { return y; }\n");
  EXPECT_FALSE(compileEntry("a.frag", ShaderTarget::kOpenGl, {}));
  write("shaders/include/f.glsl", "float f(float x) { return x; }\n");
  EXPECT_TRUE(compileCached().from_cache);
}

TEST_F(Cache, MissesWhenANewFileComesFirstInTheSearch) {
  static_cast<void>(compileCached());
  write("shaders/f.glsl", "float f(float x) { return 2.0 * x; }\n");
  EXPECT_FALSE(compileCached().from_cache);
}

TEST_F(Cache, KeepsTargetsOptionsStagesAndDefinesApart) {
  EXPECT_FALSE(compileCached().from_cache);
  EXPECT_FALSE(compileCached({}, ShaderTarget::kVulkan).from_cache);
  EXPECT_FALSE(compileCached({.form = ModuleForm::kOptimised}).from_cache);
  const ShaderSource defined{root(), "a.frag", ShaderStage::kFragment, {{"A", "1"}}};
  EXPECT_FALSE(compileShader(defined, ShaderTarget::kOpenGl)->from_cache);
  EXPECT_TRUE(compileShader(defined, ShaderTarget::kOpenGl)->from_cache);
  EXPECT_EQ(entries().size(), 4U);
}

TEST_F(Cache, IsLeftAloneWhenNotWanted) {
  static_cast<void>(compileCached({.use_cache = false}));
  EXPECT_FALSE(fs::exists(cacheFolder()));
}

TEST_F(Cache, KeepsNoErrors) {
  write("shaders/a.frag", "#version 450\nvoid main() { nope; }\n");
  EXPECT_FALSE(compileEntry("a.frag", ShaderTarget::kOpenGl, {}));
  EXPECT_FALSE(fs::exists(cacheFolder()));
}

TEST_F(Cache, RebuildsAnEntryWithOneByteChangedAnywhere) {
  const ShaderModule cold = compileCached();
  ASSERT_EQ(entries().size(), 1U);
  const fs::path entry = entries().front();
  std::ifstream file(entry, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(file), {});
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 40) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    std::ofstream(entry, std::ios::binary) << damaged;
    const ShaderModule module = compileCached();
    EXPECT_FALSE(module.from_cache) << "byte " << at;
    EXPECT_EQ(module.spirv, cold.spirv);
  }
  EXPECT_TRUE(compileCached().from_cache);
}

TEST_F(Cache, RebuildsAnEntryThatIsCutShortOrEmptyOrTooLong) {
  static_cast<void>(compileCached());
  const fs::path entry = entries().front();
  for (const std::uintmax_t size :
       {fs::file_size(entry) - 1, fs::file_size(entry) / 2, std::uintmax_t{0}, fs::file_size(entry) + 4}) {
    fs::resize_file(entry, size);
    EXPECT_FALSE(compileCached().from_cache) << size;
  }
}

TEST_F(Cache, ThatCannotBeWrittenIsNoError) {
  write("cache", "a file stands where the folder should be");
  EXPECT_FALSE(compileCached().from_cache);
  EXPECT_FALSE(compileCached().from_cache);
}

TEST_F(Cache, MayBeAbsent) {
  ASSERT_EQ(setenv("XDG_CACHE_HOME", "relative/paths/are/ignored", 1), 0);
  const char* const home = std::getenv("HOME");
  const std::string kept = home == nullptr ? "" : home;
  unsetenv("HOME");
  EXPECT_FALSE(compileCached().from_cache);
  EXPECT_FALSE(compileCached().from_cache);
  if (home != nullptr) {
    setenv("HOME", kept.c_str(), 1);
  }
}

TEST_F(Cache, ServesSeveralThreadsAtOnce) {
  const ShaderModule expected = compileCached({.use_cache = false});
  std::vector<std::thread> threads;
  std::vector<std::vector<std::uint32_t>> results(8);
  threads.reserve(results.size());
  for (std::vector<std::uint32_t>& result : results) {
    threads.emplace_back([this, &result] { result = compileCached().spirv; });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const std::vector<std::uint32_t>& result : results) {
    EXPECT_EQ(result, expected.spirv);
  }
  EXPECT_EQ(entries().size(), 1U);
}

}  // namespace
}  // namespace ssrkit
