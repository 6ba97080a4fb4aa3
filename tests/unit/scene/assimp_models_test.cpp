// The glTF files of Debian's assimp-testmodels, the broken ones among them. Runs where the package is
// installed.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

#include "scene/load.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;

const fs::path kModels = "/usr/share/assimp/models";

class AssimpModels : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(kModels)) {
      GTEST_SKIP() << "Debian's assimp-testmodels is not installed";
    }
  }
};

TEST_F(AssimpModels, AllLoadOrAreRefusedWithASentence) {
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kModels)) {
    if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") {
      continue;
    }
    ++seen;
    const auto scene = loadScene(entry.path());
    if (scene) {
      EXPECT_FALSE(scene->vertices.empty()) << entry.path();
      EXPECT_FALSE(scene->cameras.empty()) << entry.path();
    } else {
      EXPECT_EQ(scene.error().kind, ErrorKind::kInput) << entry.path();
      EXPECT_NE(sentence(scene.error()).find(entry.path().string()), std::string::npos);
    }
  }
  EXPECT_GT(seen, 40);
}

TEST_F(AssimpModels, TheValidOnesLoad) {
  struct Model {
    const char* file;
    std::size_t triangle_count;  // by the accessors' counts in the file
  };
  constexpr std::array<Model, 5> kValid{{{"glTF2/BoxTextured-glTF/BoxTextured.gltf", 12},
                                         {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", 12},
                                         {"glTF2/BoxTextured-glTF-Embedded/BoxTextured.gltf", 12},
                                         {"glTF2/cameras/Cameras.gltf", 2},
                                         {"glTF2/simple_skin/simple_skin.gltf", 8}}};
  for (const Model& model : kValid) {
    const auto scene = loadScene(kModels / model.file);
    ASSERT_TRUE(scene) << sentence(scene.error());
    EXPECT_EQ(scene->vertices.size(), 3 * model.triangle_count) << model.file;
  }
}

}  // namespace
}  // namespace ssrkit
