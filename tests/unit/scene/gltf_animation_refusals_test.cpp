#include <gtest/gtest.h>

#include <limits>

#include "gltf_test_file.h"
#include "refusal.h"

namespace ssrkit::test {
namespace {

using nlohmann::json;

class GltfAnimationRefusals : public testing::TestWithParam<Refusal> {};

TEST_P(GltfAnimationRefusals, NameThePlaceAndTheProblem) {
  json root = triangleFile();
  animate(root, 0, "translation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0});
  GetParam().spoil(root);
  const std::string refusal = refusalOf(root);
  EXPECT_NE(refusal.find("a.gltf: " + GetParam().expected), std::string::npos) << refusal;
}

json& samplerOf(json& root) {
  return root["animations"][0]["samplers"][0];
}

json& channelOf(json& root) {
  return root["animations"][0]["channels"][0];
}

void setTimes(json& root, const std::vector<float>& times) {
  samplerOf(root)["input"] =
      addAccessor(root, bytesOf(times), kFloat, static_cast<int>(times.size()), "SCALAR");
}

const std::vector<Refusal> kAnimationRefusals{
    {"MissingInput", [](json& r) { samplerOf(r).erase("input"); },
     "animations[0].samplers[0]: could not load the scene: 'input' is missing"},
    {"AccessorOutOfRange", [](json& r) { samplerOf(r)["output"] = 9; },
     "animations[0].samplers[0].output: could not load the scene: the value is 9 and there are 4 accessors"},
    {"TargetNodeOutOfRange", [](json& r) { channelOf(r)["target"]["node"] = 1; },
     "animations[0].channels[0].target.node: could not load the scene: the value is 1 and there are 1 nodes"},
    {"SamplerOutOfRange", [](json& r) { channelOf(r)["sampler"] = 1; },
     "animations[0].channels[0].sampler: could not load the scene: the value is 1 and there are 1 samplers"},
    {"UnknownPath", [](json& r) { channelOf(r)["target"]["path"] = "colour"; },
     "animations[0].channels[0].target.path: could not load the scene: it is 'colour'; it must be one of "
     "translation, rotation"},
    {"UnknownInterpolation", [](json& r) { samplerOf(r)["interpolation"] = "BEZIER"; },
     "animations[0].samplers[0].interpolation: could not load the scene: it is 'BEZIER'; it must be one of "
     "STEP"},
    {"TooFewValues",
     [](json& r) {
       setTimes(r, {0, 1, 2});
     },
     "animations[0].samplers[0]: could not load the scene: it has 3 times and 2 values; LINEAR needs 3 "
     "values"},
    {"SplineWithoutTangents", [](json& r) { samplerOf(r)["interpolation"] = "CUBICSPLINE"; },
     "animations[0].samplers[0]: could not load the scene: it has 2 times and 2 values; CUBICSPLINE needs 6 "
     "values: in-tangent, value and out-tangent for each time"},
    {"NoKeys", [](json& r) { setTimes(r, {}); },
     "animations[0].samplers[0].input: could not load the scene: there is no key"},
    {"TimesThatStandStill",
     [](json& r) {
       setTimes(r, {1, 1});
     },
     "animations[0].samplers[0].input: could not load the scene: time 1 is 1 s and the one before it is 1 s; "
     "times "
     "must increase"},
    {"TimeNan",
     [](json& r) {
       setTimes(r, {0, std::numeric_limits<float>::quiet_NaN()});
     },
     "animations[0].samplers[0].input: could not load the scene: time 1 is nan"},
    {"TimesOfVectors", [](json& r) { samplerOf(r)["input"] = 0; },
     "animations[0].samplers[0].input (accessors[0]): could not load the scene: its type is not SCALAR"},
    {"RotationOfThree", [](json& r) { channelOf(r)["target"]["path"] = "rotation"; },
     "animations[0].samplers[0].output (accessors[3]): could not load the scene: its type is not VEC4"},
    {"RotationOfNoLength",
     [](json& r) {
       animate(r, 0, "rotation", "STEP", {0, 1}, {0, 0, 0, 1, 0, 0, 0, 0});
     },
     "animations[1].samplers[0].output: could not load the scene: value 1 is a quaternion of length 0"},
    {"InfiniteValue",
     [](json& r) {
       samplerOf(r)["output"] = addAccessor(
           r, bytesOf<float>({0, 0, 0, 1, std::numeric_limits<float>::infinity(), 0}), kFloat, 2, "VEC3");
     },
     "animations[0].samplers[0].output: could not load the scene: value 1 is not finite"},
    {"SamePropertyTwice", [](json& r) { r["animations"][0]["channels"].push_back(channelOf(r)); },
     "animations[0].channels[1]: could not load the scene: the animation moves the translation of nodes[0] "
     "twice"},
    {"AnimatedMatrix",
     [](json& r) { r["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; },
     "animations[0].channels[0]: could not load the scene: nodes[0] is animated and has a matrix; give the "
     "node "
     "a translation, rotation and scale instead"},
    {"CycleOfAnimatedNodes",
     [](json& r) {
       r["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
       channelOf(r)["target"]["node"] = 2;
     },
     "nodes[1]: could not load the scene: it is its own ancestor"},
    {"PlaceOutOfPrecision",
     [](json& r) {
       r["nodes"].push_back({{"children", {0}}, {"scale", {1e300, 1, 1}}});
       r["scenes"][0]["nodes"] = {1};
     },
     "meshes[0].primitives[0]: could not load the scene: vertex 1 is not finite in the world"},
};

INSTANTIATE_TEST_SUITE_P(All, GltfAnimationRefusals, testing::ValuesIn(kAnimationRefusals),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace ssrkit::test
