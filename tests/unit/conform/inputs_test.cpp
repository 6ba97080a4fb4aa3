#include "conform/inputs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "../temporary_folder.h"

namespace ssrkit {
namespace {

class Inputs : public ::testing::Test {
 protected:
  void SetUp() override {
    write("program", "code");
    write("shaders/include/a.glsl", "a");
    write("shaders/b.frag", "b");
    write("test.toml", "t");
    write("scene/scene.gltf", "{}");
    write("scene/scene.bin", "0");
  }

  void write(const std::string& name, const std::string& content) {
    const auto file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << content;
  }

  std::string hash(const std::string& cell = "t/scene/1x1/d") {
    auto hasher = InputHasher::create(folder_.path() / "program", folder_.path() / "shaders");
    EXPECT_TRUE(hasher.has_value());
    const auto inputs =
        hasher->inputs(cell, folder_.path() / "test.toml", folder_.path() / "scene/scene.gltf", {device_});
    EXPECT_TRUE(inputs.has_value());
    return inputs.value_or("");
  }

  testing::TemporaryFolder folder_;
  DeviceIdentity device_{.id = "d", .driver = "llvm", .version = "22.3.6", .cpu_features = {"avx2"}};
};

TEST_F(Inputs, AreTheSameForTheSame) {
  EXPECT_EQ(hash(), hash());
  EXPECT_EQ(32U, hash().size());
}

TEST_F(Inputs, EachOfThemCounts) {
  std::string last = hash();
  const auto changed = [&](const std::string& what) {
    const std::string now = hash();
    EXPECT_NE(last, now) << what;
    last = now;
  };
  for (const char* file :
       {"program", "shaders/include/a.glsl", "test.toml", "scene/scene.gltf", "scene/scene.bin"}) {
    write(file, "changed");
    changed(file);
  }
  write("shaders/new.frag", "n");
  changed("a new shader");
  device_.version = "25.0";
  changed("the driver's version");
  device_.cpu_features = {"sse4_1"};
  changed("the processor's features");
  EXPECT_NE(last, hash("t/scene/2x2/d")) << "the cell";
}

TEST_F(Inputs, FilesBesideTheSceneThatAreNoneOfItsKindDoNotCount) {
  const std::string before = hash();
  write("scene/notes.txt", "x");
  write("scene/deeper/other.bin", "x");
  EXPECT_EQ(before, hash());
}

TEST_F(Inputs, AMissingFileIsAnError) {
  EXPECT_FALSE(InputHasher::create(folder_.path() / "none", folder_.path() / "shaders").has_value());
  EXPECT_FALSE(InputHasher::create(folder_.path() / "program", folder_.path() / "none").has_value());
}

}  // namespace
}  // namespace ssrkit
