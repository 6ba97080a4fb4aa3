// A shader folder and a cache of its own for each test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "shader/compiler.h"

namespace ssrkit {

class ShaderFolder : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  // Parents are made; `name` is relative to the test's own folder.
  std::filesystem::path write(const std::string& name, std::string_view text) const;

  [[nodiscard]] std::filesystem::path root() const { return folder_ / "shaders"; }
  [[nodiscard]] std::filesystem::path folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path cacheFolder() const { return folder_ / "cache" / "ssrkit" / "spirv"; }

  // Writes the text as shaders/a.frag and compiles it without the cache.
  [[nodiscard]] Expected<ShaderModule> compileFragment(std::string_view text,
                                                       ShaderTarget target = ShaderTarget::kOpenGl) const;
  [[nodiscard]] Expected<ShaderModule> compileEntry(const std::filesystem::path& entry,
                                                    ShaderTarget target = ShaderTarget::kOpenGl,
                                                    const CompileOptions& options = {
                                                        .use_cache = false}) const;

  // The error of a text that must not compile; an empty one when it does.
  [[nodiscard]] Error errorOf(std::string_view text, ShaderTarget target = ShaderTarget::kOpenGl) const;

 private:
  std::filesystem::path folder_;
};

inline constexpr ShaderTarget kBothTargets[] = {ShaderTarget::kOpenGl, ShaderTarget::kVulkan};

}  // namespace ssrkit
