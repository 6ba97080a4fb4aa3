#include <gtest/gtest.h>

#include "shader_folder.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;

class KitShaders : public ShaderFolder {};

TEST_F(KitShaders, AllCompileForBothTargetsOptimisedOrNot) {
  const fs::path kit = fs::path(SSRKIT_SOURCE_DIR) / "shaders";
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(kit)) {
    const Expected<ShaderStage> stage = stageOfFile(entry.path());
    if (!stage) {
      continue;
    }
    ++count;
    for (const ShaderTarget target : kBothTargets) {
      for (const ModuleForm form :
           {ModuleForm::kPlain, ModuleForm::kOptimised, ModuleForm::kOptimisedSize, ModuleForm::kRobust,
            ModuleForm::kDeadCode, ModuleForm::kUniformsReversed}) {
        const Expected<ShaderModule> module = compileShader({kit, entry.path().filename(), *stage, {}},
                                                            target, {.form = form, .use_cache = false});
        EXPECT_TRUE(module) << sentence(module.error());
      }
    }
  }
  EXPECT_GE(count, 10);
}

}  // namespace
}  // namespace ssrkit
