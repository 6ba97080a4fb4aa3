#include <gtest/gtest.h>

#include <limits>

#include "gltf_test_file.h"
#include "refusal.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

class GltfRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(GltfRefusals, NameThePlaceAndTheProblem) {
  json root = triangleFile();
  GetParam().spoil(root);
  const std::string refusal = refusalOf(root);
  EXPECT_NE(refusal.find("a.gltf: " + GetParam().expected), std::string::npos) << refusal;
}

const float kNan = std::numeric_limits<float>::quiet_NaN();
const float kInfinity = std::numeric_limits<float>::infinity();

const std::vector<Refusal> kFileRefusals{
    {"NoVersion", [](json& r) { r["asset"] = json::object(); },
     "asset: could not load the scene: 'version' is missing"},
    {"Version1", [](json& r) { r["asset"]["version"] = "1.0"; },
     "asset.version: could not load the scene: it is glTF '1.0'; ssrkit reads glTF 2.0"},
    {"Draco", [](json& r) { r["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
     "extensionsRequired[0]: could not load the scene: the file needs KHR_draco_mesh_compression, which "
     "ssrkit does not read"},
    {"Meshopt",
     [](json& r) {
       r["extensionsRequired"] = {"KHR_lights_punctual", "EXT_meshopt_compression"};
     },
     "extensionsRequired[1]: could not load the scene: the file needs EXT_meshopt_compression"},
    {"ExtensionsNoArray", [](json& r) { r["extensionsRequired"] = 7; },
     "extensionsRequired: could not load the scene: the value is not an array"},
    {"NodesNoArray", [](json& r) { r["nodes"] = 5; },
     "nodes: could not load the scene: the value is not an array"},
    {"NodeNoObject", [](json& r) { r["nodes"].push_back(5); },
     "nodes[1]: could not load the scene: the value is not an object"},
    {"MeshOutOfRange", [](json& r) { r["nodes"][0]["mesh"] = 1; },
     "nodes[0].mesh: could not load the scene: the value is 1 and there are 1 meshes"},
    {"NegativeIndex", [](json& r) { r["nodes"][0]["mesh"] = -1; },
     "nodes[0].mesh: could not load the scene: the value is not an index"},
    {"HugeIndex", [](json& r) { r["nodes"][0]["mesh"] = 4294967296; },
     "nodes[0].mesh: could not load the scene: the value is not an index"},
    {"MaterialOutOfRange", [](json& r) { primitiveOf(r)["material"] = 3; },
     "meshes[0].primitives[0].material: could not load the scene: the value is 3 and there are 0 materials"},
    {"ShortMatrix",
     [](json& r) {
       r["nodes"][0]["matrix"] = {1, 2, 3};
     },
     "nodes[0].matrix: could not load the scene: the value is not an array of 16 numbers"},
    {"TextInMatrix",
     [](json& r) {
       r["nodes"][0]["scale"] = {1, "x", 3};
     },
     "nodes[0].scale: could not load the scene: the value is not an array of 3 numbers"},
    {"InfiniteTransform",
     [](json& r) {
       r["nodes"][0]["scale"] = {1e308, 1, 1};
       r["nodes"][0]["children"] = {1};
       r["nodes"].push_back({{"scale", {1e308, 1, 1}}});
     },
     "nodes[1]: could not load the scene: its transform is not finite"},
    {"FarAway",
     [](json& r) {
       r["nodes"][0]["scale"] = {1e300, 1, 1};
     },
     "meshes[0].primitives[0]: could not load the scene: vertex 1 is not finite in the world"},
    {"Cycle",
     [](json& r) {
       r["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}, {"name", "b"}}};
     },
     "nodes[1]: could not load the scene: it is its own ancestor"},
    {"OwnChild", [](json& r) { r["nodes"][0]["children"] = {0}; },
     "nodes[0]: could not load the scene: it is its own ancestor"},
    {"TwoParents",
     [](json& r) {
       r["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"name", "leg"}}};
     },
     "nodes[2] 'leg': could not load the scene: it is a child of nodes[0] and of nodes[1]"},
    {"RootTwice",
     [](json& r) {
       r["scenes"][0]["nodes"] = {0, 0};
     },
     "scenes[0].nodes: could not load the scene: nodes[0] is listed twice"},
    {"RootIsChild",
     [](json& r) {
       r["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
       r["scenes"][0]["nodes"] = {1};
     },
     "scenes[0].nodes: could not load the scene: nodes[1] is no root"},
    {"NoTriangle", [](json& r) { r["nodes"][0].erase("mesh"); },
     "could not load the scene: the scene has no triangle to draw"},
    {"OnlyLines", [](json& r) { primitiveOf(r)["mode"] = 1; },
     "could not load the scene: the scene has no triangle to draw, only points or lines"},
    {"UnknownMode", [](json& r) { primitiveOf(r)["mode"] = 7; },
     "meshes[0].primitives[0]: could not load the scene: its mode 7 is not one of glTF's"},
    {"NoPositions", [](json& r) { primitiveOf(r)["attributes"] = json::object(); },
     "meshes[0].primitives[0].attributes: could not load the scene: 'POSITION' is missing"},
    {"IndexTooLarge",
     [](json& r) {
       primitiveOf(r)["indices"] = addAccessor(r, {0, 1, 3}, kUnsignedByte, 3, "SCALAR");
     },
     "meshes[0].primitives[0].indices (accessors[2]): could not load the scene: index 2 is 3 and there are 3 "
     "vertices"},
    {"FloatIndices",
     [](json& r) {
       primitiveOf(r)["indices"] = addAccessor(r, bytesOf<float>({0, 1, 2}), kFloat, 3, "SCALAR");
     },
     "meshes[0].primitives[0].indices (accessors[2]): could not load the scene: indices must be unsigned "
     "integers"},
    {"NanPosition",
     [](json& r) {
       setPositions(r, {0, 0, 0, 1, kNan, 0, 0, 1, 0});
     },
     "meshes[0].primitives[0].attributes.POSITION (accessors[2]): could not load the scene: vertex 1 is not "
     "finite"},
    {"InfinitePosition",
     [](json& r) {
       setPositions(r, {0, 0, 0, 1, 0, 0, 0, 1, -kInfinity});
     },
     "meshes[0].primitives[0].attributes.POSITION (accessors[2]): could not load the scene: vertex 2 is not "
     "finite"},
    {"WrongVectorSize", [](json& r) { r["accessors"][0]["type"] = "VEC2"; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: its type is not "
     "VEC3"},
    {"UnknownComponent", [](json& r) { r["accessors"][0]["componentType"] = 5124; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: component type "
     "5124"},
    {"AccessorPastView", [](json& r) { r["accessors"][0]["count"] = 4; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: it reads 12 "
     "bytes past bufferViews[0]"},
    {"AccessorOffset", [](json& r) { r["accessors"][0]["byteOffset"] = 4; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: it reads 4 bytes "
     "past bufferViews[0]"},
    {"StrideOverlaps", [](json& r) { r["bufferViews"][0]["byteStride"] = 8; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: bufferViews[0] "
     "has a stride of 8 bytes and an element has 12"},
    {"StridePastView", [](json& r) { r["bufferViews"][0]["byteStride"] = 16; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: it reads 8 bytes "
     "past bufferViews[0]"},
    {"HugeCount", [](json& r) { r["accessors"][0]["count"] = 2147483647; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: it has "
     "2147483647 elements and the limit is"},
    {"CountWraps", [](json& r) { r["accessors"][0]["count"] = 18446744073709551615U; },
     "accessors[0].count: could not load the scene: the value is not a whole number between 0 and "
     "2147483647"},
    {"ViewPastBuffer", [](json& r) { r["bufferViews"][0]["byteLength"] = 37; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: bufferViews[0] "
     "ends at byte 37 and buffers[0] has 36"},
    {"ViewOffsetPastBuffer", [](json& r) { r["bufferViews"][0]["byteOffset"] = 2147483647; },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: bufferViews[0] "
     "ends at byte 2147483683"},
    {"BufferTooShort", [](json& r) { r["buffers"][0]["byteLength"] = 40; },
     "buffers[0]: could not load the scene: it declares 40 bytes and has 36"},
    {"BufferWithoutUri", [](json& r) { r["buffers"][0].erase("uri"); },
     "buffers[0]: could not load the scene: it has neither a URI nor a binary chunk"},
    {"NotBase64", [](json& r) { r["buffers"][0]["uri"] = "data:application/octet-stream;base64,A*BC"; },
     "buffers[0].uri: could not load the scene: the data: URI holds a character that is not base64"},
    {"DataWithoutBase64", [](json& r) { r["buffers"][0]["uri"] = "data:text/plain,hello"; },
     "buffers[0].uri: could not load the scene: the data: URI is not base64"},
    {"MissingBin", [](json& r) { r["buffers"][0]["uri"] = "gone.bin"; },
     "buffers[0].uri: could not load the scene: 'gone.bin': there is no such file"},
    {"AbsolutePath", [](json& r) { r["buffers"][0]["uri"] = "/etc/passwd"; },
     "buffers[0].uri: could not load the scene: the URI '/etc/passwd' leads out of the scene's folder"},
    {"ParentFolder", [](json& r) { r["buffers"][0]["uri"] = "x/../../secret.bin"; },
     "buffers[0].uri: could not load the scene: the URI 'x/../../secret.bin' leads out"},
    {"EscapedParent", [](json& r) { r["buffers"][0]["uri"] = "%2e%2e%2fsecret.bin"; },
     "buffers[0].uri: could not load the scene: the URI '../secret.bin' leads out"},
    {"BackslashParent", [](json& r) { r["buffers"][0]["uri"] = "..\\secret.bin"; },
     "buffers[0].uri: could not load the scene: the URI '..\\secret.bin' leads out"},
    {"Scheme", [](json& r) { r["buffers"][0]["uri"] = "https://example.org/a.bin"; },
     "buffers[0].uri: could not load the scene: the URI 'https://example.org/a.bin' is neither data: nor a "
     "file"},
    {"FileScheme", [](json& r) { r["buffers"][0]["uri"] = "file:///etc/passwd"; },
     "buffers[0].uri: could not load the scene: the URI 'file:///etc/passwd' is neither"},
    {"NulInUri", [](json& r) { r["buffers"][0]["uri"] = "a%00b"; },
     "buffers[0].uri: could not load the scene: the URI is not a file name"},
    {"NormalCount",
     [](json& r) {
       primitiveOf(r)["attributes"]["NORMAL"] = addAccessor(r, bytesOf<float>({0, 0, 1}), kFloat, 1, "VEC3");
     },
     "meshes[0].primitives[0].attributes.NORMAL: could not load the scene: it has 1 elements and POSITION "
     "has 3"},
    {"SparseIndexTooLarge",
     [](json& r) {
       const int indices = addView(r, {3});
       r["accessors"][0]["sparse"] = {
           {"count", 1},
           {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
           {"values", {{"bufferView", 0}}}};
     },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]): could not load the scene: sparse index 0 "
     "is 3 and there are 3"},
    {"SparsePastView",
     [](json& r) {
       const int indices = addView(r, {0});
       r["accessors"][0]["sparse"] = {
           {"count", 2},
           {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
           {"values", {{"bufferView", 0}}}};
     },
     "meshes[0].primitives[0].attributes.POSITION (accessors[0]) (sparse indices): could not load the scene: "
     "it reads 1 bytes past bufferViews[2]"},
    {"ExtraOfWrongType",
     [](json& r) {
       r["materials"] = {{{"extras", {{"ssrkit_mirror", 1}}}}};
     },
     "materials[0].extras.ssrkit_mirror: could not load the scene: the value is neither true nor false"},
};

INSTANTIATE_TEST_SUITE_P(EachKind, GltfRefusals, testing::ValuesIn(kFileRefusals),
                         [](const auto& refusal) { return refusal.param.name; });

// Images are looked at when a material uses them.
std::string imageRefusal(const json& image, const std::vector<std::uint8_t>& bytes = {}) {
  json root = triangleFile();
  root["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
  root["textures"] = {{{"source", 0}}};
  root["images"] = {image};
  if (!bytes.empty()) {
    root["images"][0]["bufferView"] = addView(root, bytes);
  }
  return refusalOf(root);
}

TEST(GltfImageRefusals, NameTheImage) {
  EXPECT_NE(imageRefusal({{"uri", "gone.png"}})
                .find("images[0].uri: could not load the scene: 'gone.png': there is no such file"),
            std::string::npos);
  EXPECT_NE(imageRefusal(json::object())
                .find("images[0]: could not load the scene: it must have either a URI or a buffer view"),
            std::string::npos);
  EXPECT_NE(imageRefusal({{"mimeType", "image/webp"}}, {'R', 'I', 'F', 'F', 1, 2, 3, 4})
                .find("images[0]: could not load the scene: it is neither PNG nor JPEG"),
            std::string::npos);
}

TEST(GltfImageRefusals, TellABrokenImageFromATooLargeOne) {
  std::vector<std::uint8_t> png = plainPng(4, 4, 1, 2, 3);
  png.resize(40);
  EXPECT_NE(imageRefusal(json::object(), png)
                .find("images[0]: could not load the scene: the image cannot be decoded"),
            std::string::npos);
  png = plainPng(4, 4, 1, 2, 3);
  png[16 + 2] = 0x40;  // 16388 wide
  EXPECT_NE(imageRefusal(json::object(), png).find("it is 16388x4 and the limits are 16384 a side"),
            std::string::npos);
  png[16 + 2] = 0x3F;
  png[20 + 2] = 0x3F;  // 16132 x 16132 is 993 MiB
  EXPECT_NE(imageRefusal(json::object(), png).find("256 MiB decoded"), std::string::npos);
  png.resize(20);
  EXPECT_NE(imageRefusal(json::object(), png).find("its header is broken"), std::string::npos);
  EXPECT_NE(
      imageRefusal(json::object(), {0xFF, 0xD8, 0xFF, 0xC0, 0, 17, 8, 0x7F}).find("its header is broken"),
      std::string::npos);
  EXPECT_NE(imageRefusal(json::object(), {0xFF, 0xD8, 0xFF, 0xC0, 0, 17, 8, 0x7F, 0xFF, 0x7F, 0xFF})
                .find("it is 32767x32767"),
            std::string::npos);
}

}  // namespace
}  // namespace ssrkit::test
