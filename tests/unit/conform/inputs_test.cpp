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
    write("scene/scene.gltf", R"({"buffers": [{"uri": "scene.bin"}, {"uri": "data:;base64,AA=="}],
                                  "images": [{"uri": "textures/wall%20one.PNG"}, {"uri": "no.png"}]})");
    write("scene/scene.bin", "0");
    write("scene/textures/wall one.PNG", "p");
    write("scene/scene.toml", "environment = \"../skies/day.exr\"\n");
    write("skies/day.exr", "e");
    write("goldens/t/scene/1x1/lit.exr", "g");
  }

  void write(const std::string& name, const std::string& content) {
    const auto file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << content;
  }

  std::string hash(const std::string& cell = "t/scene/1x1/d") {
    auto hasher = InputHasher::create(folder_.path() / "program", folder_.path() / "shaders");
    EXPECT_TRUE(hasher.has_value());
    const auto inputs = hasher->inputs({.id = cell,
                                        .test_file = folder_.path() / "test.toml",
                                        .scene_file = folder_.path() / "scene/scene.gltf",
                                        .goldens = goldens_.empty() ? goldens_ : folder_.path() / goldens_,
                                        .devices = {device_}});
    EXPECT_TRUE(inputs.has_value());
    return inputs.value_or("");
  }

  test::TemporaryFolder folder_;
  std::filesystem::path goldens_ = "goldens/t/scene";
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
       {"program", "shaders/include/a.glsl", "test.toml", "scene/scene.bin", "scene/textures/wall one.PNG",
        "skies/day.exr", "goldens/t/scene/1x1/lit.exr", "scene/scene.toml", "scene/scene.gltf"}) {
    write(file, "changed");
    changed(file);
  }
  write("goldens/t/scene/1x1/new.exr", "n");
  changed("a new golden");
  write("shaders/new.frag", "n");
  changed("a new shader");
  device_.version = "25.0";
  changed("the driver's version");
  device_.cpu_features = {"sse4_1"};
  changed("the processor's features");
  EXPECT_NE(last, hash("t/scene/2x2/d")) << "the cell";
}

TEST_F(Inputs, FilesThatTheSceneDoesNotNameDoNotCount) {
  const std::string before = hash();
  write("scene/other.png", "x");
  write("scene/deeper/other.bin", "x");
  EXPECT_EQ(before, hash());
}

TEST_F(Inputs, AFileThatTheSceneNamesCountsOnceItIsThere) {
  const std::string before = hash();
  write("scene/no.png", "x");
  EXPECT_NE(before, hash());
}

TEST_F(Inputs, GoldensCountOnlyWhereTheTestAsksForThem) {
  const std::string with_goldens = hash();
  goldens_.clear();
  const std::string without = hash();
  EXPECT_NE(with_goldens, without);
  write("goldens/t/scene/1x1/lit.exr", "changed");
  EXPECT_EQ(without, hash());
  goldens_ = "goldens/none/yet";
  EXPECT_EQ(without, hash()) << "no golden is blessed yet";
}

TEST_F(Inputs, AMissingFileIsAnError) {
  EXPECT_FALSE(InputHasher::create(folder_.path() / "none", folder_.path() / "shaders").has_value());
  EXPECT_FALSE(InputHasher::create(folder_.path() / "program", folder_.path() / "none").has_value());
}

}  // namespace
}  // namespace ssrkit
