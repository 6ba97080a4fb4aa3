#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "gltf_test_file.h"

namespace ssrkit::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string refusalOfText(const std::string& text) {
  const ScratchFolder folder;
  const auto scene = loadScene(folder.write("a.gltf", text));
  return scene ? "" : sentence(scene.error());
}

std::string contentOf(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

TEST(HostileFiles, BadSyntaxIsRefusedAtItsLineAndColumn) {
  EXPECT_NE(refusalOfText("{\n \"asset\": {,\n}")
                .find("a.gltf:2:12: could not load the scene: its JSON has a syntax error"),
            std::string::npos)
      << refusalOfText("{\n \"asset\": {,\n}");
  EXPECT_NE(refusalOfText("{").find("a.gltf:1:2:"), std::string::npos) << refusalOfText("{");
}

TEST(HostileFiles, EveryTruncationOfAValidFileIsRefused) {
  const std::string text = triangleFile().dump();
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(refusalOfText(text.substr(0, size)), "") << size;
  }
}

TEST(HostileFiles, DeepNestingIsRefusedBeforeItIsBuilt) {
  const std::string deep = "{\"extras\":" + std::string(1'000'000, '[');
  EXPECT_NE(refusalOfText(deep).find(
                "a.gltf:1:74: could not load the scene: the JSON is nested deeper than 64 levels"),
            std::string::npos)
      << refusalOfText(deep).substr(0, 200);
}

TEST(HostileFiles, NumbersOutOfRangeAreRefused) {
  EXPECT_NE(refusalOfText("{\"asset\":{\"version\":\"2.0\"},\"scene\":1e999}")
                .find("its JSON cannot be read: number overflow"),
            std::string::npos);
}

TEST(HostileFiles, OtherKindsOfFilesAreToldApart) {
  EXPECT_NE(refusalOfText("").find("the file is empty"), std::string::npos);
  EXPECT_NE(refusalOfText("\x89PNG").find("it is neither glTF JSON nor a GLB file"), std::string::npos);
  EXPECT_NE(refusalOfText("[]").find("it is neither glTF JSON nor a GLB file"), std::string::npos);
  EXPECT_NE(refusalOfText("{\"a\":\"\xFF\"}").find("syntax error"), std::string::npos);
  const auto missing = loadScene("no/such/file.gltf");
  ASSERT_FALSE(missing);
  EXPECT_NE(
      sentence(missing.error()).find("no/such/file.gltf: could not load the scene: there is no such file"),
      std::string::npos);
  EXPECT_FALSE(loadScene(fs::temp_directory_path()));
}

TEST(HostileFiles, ControlCharactersOfNamesDoNotReachTheOutput) {
  json root = triangleFile();
  root["materials"] = {{{"name", "\x1B[31mred\x07\n"}}};
  root["meshes"][0]["primitives"][0]["material"] = 0;
  const auto scene = loadFile(root);
  ASSERT_TRUE(scene) << sentence(scene.error());
  EXPECT_EQ(scene->materials[0].name, "[31mred");
}

TEST(HostileFiles, ALinkOutOfTheFolderIsRefused) {
  const ScratchFolder outside;
  outside.write("secret.bin", std::string(36, '\0'));
  const ScratchFolder folder;
  fs::create_symlink(outside.path() / "secret.bin", folder.path() / "a.bin");
  json root = triangleFile();
  root["buffers"][0]["uri"] = "a.bin";
  const auto scene = loadScene(folder.write("a.gltf", root.dump()));
  ASSERT_FALSE(scene);
  EXPECT_NE(sentence(scene.error()).find("the URI 'a.bin' leads out of the scene's folder"),
            std::string::npos);
}

TEST(HostileFiles, ASceneThatRepeatsAMeshWithoutEndIsRefused) {
  json root = triangleFile();
  // 5000 triangles in 2000 nodes are 30 million vertices.
  setPositions(root, std::vector<float>(45'000, 1.0F));
  for (int i = 1; i < 2000; ++i) {
    root["nodes"].push_back({{"mesh", 0}});
    root["scenes"][0]["nodes"].push_back(i);
  }
  EXPECT_NE(refusalOf(root).find("the scene has more than 6666666 triangles"), std::string::npos)
      << refusalOf(root);
}

TEST(HostileFiles, DamagedScenesNeverCrash) {
  // Text: bytes changed at random; half of the changes are to digits, which keep the syntax whole.
  const fs::path scenes = fs::path(SSRKIT_SOURCE_DIR) / "scenes";
  const std::string text = contentOf(scenes / "m3" / "m3.gltf");
  const ScratchFolder folder;
  fs::copy_file(scenes / "m3" / "m3.bin", folder.path() / "m3.bin");
  std::mt19937 random(1);
  int refused = 0;
  constexpr int kRounds = 600;
  for (int round = 0; round < kRounds; ++round) {
    std::string damaged = text;
    for (int change = 0; change <= round % 3; ++change) {
      std::size_t at = random() % damaged.size();
      if (round % 2 == 0) {
        at = std::min(damaged.find_first_of("0123456789", at), damaged.size() - 1);
        damaged[at] = static_cast<char>('0' + random() % 10);
      } else {
        damaged[at] = static_cast<char>(random() % 256);
      }
    }
    const auto scene = loadScene(folder.write("m3.gltf", damaged));
    refused += scene ? 0 : 1;
    EXPECT_TRUE(scene || !sentence(scene.error()).empty());
  }
  EXPECT_GT(refused, kRounds / 4);
  EXPECT_LT(refused, kRounds);
}

TEST(HostileFiles, DamagedBuffersNeverCrash) {
  const fs::path scenes = fs::path(SSRKIT_SOURCE_DIR) / "scenes";
  const std::string binary = contentOf(scenes / "m3" / "m3.bin");
  const ScratchFolder folder;
  const fs::path file = folder.write("m3.gltf", contentOf(scenes / "m3" / "m3.gltf"));
  std::mt19937 random(2);
  for (int round = 0; round < 150; ++round) {
    std::string damaged = binary;
    for (int change = 0; change < 20; ++change) {
      damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    }
    folder.write("m3.bin", damaged);
    const auto scene = loadScene(file);
    EXPECT_TRUE(scene || !sentence(scene.error()).empty());
  }
}

}  // namespace
}  // namespace ssrkit::test
