#include "scene/find_scene.h"

#include <gtest/gtest.h>

#include "gltf_test_file.h"
#include "scene_folder.h"

namespace ssrkit::test {
namespace {

namespace fs = std::filesystem;

std::string searchRefusal(const std::string& name) {
  const auto found = findScene(name, kScenes);
  return found ? "" : sentence(found.error());
}

TEST(FindScene, ListsTheBuiltInScenesInTheirOrder) {
  EXPECT_EQ(builtInScenes(kScenes),
            (std::vector<std::string>{"m1", "m2", "m3", "m4", "clutter", "thin", "facing", "curved", "gloss",
                                      "corridor", "outdoor", "moving"}));
  EXPECT_TRUE(builtInScenes("/no/such/folder").empty());
}

TEST(FindScene, FindsABuiltInSceneByName) {
  EXPECT_EQ(*findScene("m1", kScenes), kScenes / "m1" / "m1.gltf");
}

TEST(FindScene, FindsAFileByPath) {
  const ScratchFolder folder;
  const fs::path file = folder.write("mine.glb", "");
  EXPECT_EQ(*findScene(file.string(), kScenes), file);
}

TEST(FindScene, SuggestsTheNearestNameAndListsAll) {
  EXPECT_NE(searchRefusal("cluter").find(
                "could not find the scene 'cluter': there is no built-in scene or file of that name; "
                "did you mean 'clutter'? the built-in scenes are m1, m2, m3, m4, clutter,"),
            std::string::npos)
      << searchRefusal("cluter");
}

TEST(FindScene, TellsAFolderAndAMissingFileApart) {
  EXPECT_NE(searchRefusal(kScenes.string()).find("it is a folder; name the .gltf or .glb file in it"),
            std::string::npos);
  EXPECT_NE(searchRefusal("gone.gltf").find("there is no such file"), std::string::npos);
  EXPECT_NE(searchRefusal("").find("there is no built-in scene"), std::string::npos);
}

}  // namespace
}  // namespace ssrkit::test
