#include <gtest/gtest.h>

#include <cstring>

#include "gltf_test_file.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

std::string word(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

std::string chunk(const std::string& kind, const std::string& content) {
  return word(static_cast<std::uint32_t>(content.size())) + kind + content;
}

std::string glb(const std::string& chunks, std::uint32_t version = 2) {
  return "glTF" + word(version) + word(static_cast<std::uint32_t>(chunks.size()) + 12) + chunks;
}

std::string jsonChunk(const std::string& text) {
  return chunk("JSON", text);
}

std::string binaryChunk(const std::string& content) {
  return chunk(std::string("BIN\0", 4), content);
}

// The triangle with its buffers in one binary chunk.
std::string triangleGlb() {
  json root = triangleFile();
  const auto positions = bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto indices = bytesOf<std::uint16_t>({0, 1, 2, 0});
  root["buffers"] = {{{"byteLength", 42}}};
  root["bufferViews"] = {{{"buffer", 0}, {"byteLength", 36}},
                         {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 6}}};
  return glb(jsonChunk(root.dump()) + binaryChunk(std::string(positions.begin(), positions.end()) +
                                                  std::string(indices.begin(), indices.end())));
}

Expected<Scene> loadGlb(const std::string& bytes, const std::string& name = "a.glb") {
  const ScratchFolder folder;
  return loadScene(folder.write(name, bytes));
}

std::string glbRefusal(const std::string& bytes) {
  const auto scene = loadGlb(bytes);
  return scene ? "" : sentence(scene.error());
}

TEST(Glb, IsReadWithItsBinaryChunkWhateverItsName) {
  for (const char* name : {"a.glb", "a.gltf", "a"}) {
    const auto scene = loadGlb(triangleGlb(), name);
    ASSERT_TRUE(scene) << sentence(scene.error());
    EXPECT_EQ(scene->vertices[1].p_world, glm::vec3(1, 0, 0));
  }
}

TEST(Glb, ChunksOfOtherKindsAreSkipped) {
  std::string bytes = triangleGlb().substr(12) + chunk("XTRA", "1234");
  EXPECT_TRUE(loadGlb(glb(bytes)));
}

TEST(Glb, BrokenContainersAreRefused) {
  EXPECT_NE(glbRefusal("glTF").find("the file ends after 4 bytes, inside the GLB header"), std::string::npos);
  EXPECT_NE(glbRefusal(glb(jsonChunk("{}  "), 1)).find("it is GLB version 1"), std::string::npos);
  const std::string whole = triangleGlb();
  EXPECT_NE(glbRefusal(whole.substr(0, whole.size() - 1)).find("its header says"), std::string::npos);
  EXPECT_NE(glbRefusal(glb(binaryChunk("1234") + jsonChunk("{}")))
                .find("chunk 0: could not load the scene: a GLB file begins with its one JSON chunk"),
            std::string::npos);
  EXPECT_NE(glbRefusal(glb(word(0xFFFFFFFFU) + "JSON{}"))
                .find("chunk 0: could not load the scene: it has 4294967295 bytes and 2 are left"),
            std::string::npos);
  EXPECT_NE(glbRefusal(glb(jsonChunk(""))).find("the JSON chunk is empty"), std::string::npos);
}

TEST(Glb, ACutAtEveryLengthIsRefusedWithASentence) {
  const std::string whole = triangleGlb();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(glbRefusal(whole.substr(0, size)).find("could not load the scene"), std::string::npos) << size;
  }
}

}  // namespace
}  // namespace ssrkit::test
