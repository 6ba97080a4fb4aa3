// The native tracer against the shaders' record, bit for bit, and against Oracle A.
#include "native/trace.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "device/registry.h"
#include "frame/run_job.h"

namespace ssrkit {
namespace {

struct Traced {
  JobResult result;
  Image mask;

  [[nodiscard]] OracleInput input(std::size_t trace) const {
    return {.camera = &result.camera,
            .dist_view = &result.images.at("dist_view"),
            .normal_view = &result.images.at("normal_view"),
            .mask = &mask,
            .parameters = result.traces[trace].parameters};
  }
};

std::string root() {
  return SSRKIT_SOURCE_DIR;
}

Image maskOf(const Image& material) {
  Image mask(material.size, {"mask"});
  for (std::size_t texel = 0; texel < mask.texelCount(); ++texel) {
    mask.data[texel] = material.data[texel * material.channelCount() + 2];
  }
  return mask;
}

// A scene's traces by `hiz` on vk-lavapipe, and what the tracers read.
Traced traced(const std::string& scene, Size size, const std::vector<TraceParameters>& parameters) {
  const auto entry = findDevice("vk-lavapipe");
  EXPECT_TRUE(entry.has_value());
  for (const auto& [name, value] : (*entry)->environment) {
    EXPECT_EQ(setenv(name.c_str(), value.c_str(), 1), 0);
  }
  auto device = (*entry)->create();
  EXPECT_TRUE(device.has_value()) << sentence(device.error());
  Job job;
  job.id = scene;
  job.scene_file = root() + "/scenes/" + scene + "/" + scene + ".gltf";
  job.size = size;
  job.shader_root = root() + "/shaders";
  for (const TraceParameters& one : parameters) {
    job.traces.push_back({.stage = "hiz", .parameters = one, .technique = ""});
  }
  auto result = JobRunner(**device, (*entry)->target).run(job, [](const std::string&) {});
  EXPECT_TRUE(result.has_value()) << sentence(result.error());
  Image mask = maskOf(result->images.at("material"));
  return {std::move(*result), std::move(mask)};
}

bool sameBits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool sameRay(const RayHit& a, const RayHit& b) {
  return a.texel_x == b.texel_x && a.texel_y == b.texel_y && sameBits(a.px_x, b.px_x) &&
         sameBits(a.px_y, b.px_y) && sameBits(a.t_m, b.t_m) && a.ray_class == b.ray_class &&
         a.lookups == b.lookups && a.steps == b.steps;
}

int differentRays(const RayRecord& a, const RayRecord& b) {
  EXPECT_EQ(a.rays.size(), b.rays.size());
  int count = 0;
  for (std::size_t i = 0; i < a.rays.size(); ++i) {
    count += sameRay(a.rays[i], b.rays[i]) ? 0 : 1;
  }
  return count;
}

class NativeTraceTest : public testing::TestWithParam<std::string> {};

// Endless, thin and relative columns, a bias that moves the origin, a range, a budget that binds, and a
// pyramid of two levels.
const std::vector<TraceParameters> kParameters = {{},
                                                  {.thickness_m = 0.3},
                                                  {.thickness_m = 0.0, .thickness_rel = 0.05},
                                                  {.thickness_m = 0.3, .origin_bias = 0.004},
                                                  {.thickness_m = 0.3, .max_distance_m = 2.0},
                                                  {.thickness_m = 0.3, .lookup_budget = 7},
                                                  {.thickness_m = 0.3, .max_mip = 1}};

TEST_P(NativeTraceTest, ItsRecordHasTheShadersBits) {
  for (const Size size : {Size{161, 91}, Size{320, 180}}) {
    const Traced of_shader = traced(GetParam(), size, kParameters);
    for (std::size_t i = 0; i < kParameters.size(); ++i) {
      for (const std::string& instruction_set : nativeInstructionSets()) {
        for (const int thread_count : {1, 2}) {
          const auto native = traceNative(of_shader.input(i), thread_count, instruction_set);
          ASSERT_TRUE(native.has_value()) << sentence(native.error());
          EXPECT_EQ(differentRays(native->record, of_shader.result.traces[i].record), 0)
              << size.width << "x" << size.height << ", parameters " << i << ", " << instruction_set;
        }
      }
    }
  }
}

TEST_P(NativeTraceTest, ItMeetsWhatTheOracleMeetsExceptAtTies) {
  const Traced of_shader = traced(GetParam(), {320, 180}, {{.thickness_m = 0.3}});
  const auto native = traceNative(of_shader.input(0));
  const auto oracle = traceOracle(of_shader.input(0));
  ASSERT_TRUE(native.has_value() && oracle.has_value());
  int hits = 0;
  for (std::size_t i = 0; i < native->record.rays.size(); ++i) {
    const RayHit& got = native->record.rays[i];
    const RayHit& expected = oracle->record.rays[i];
    hits += expected.ray_class == RayClass::kHit ? 1 : 0;
    if (oracle->ambiguity[i] == Ambiguity::kNone) {
      ASSERT_EQ(got.ray_class, expected.ray_class) << "texel " << i;
      ASSERT_EQ(got.texel_x, expected.texel_x) << "texel " << i;
      ASSERT_EQ(got.texel_y, expected.texel_y) << "texel " << i;
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST_P(NativeTraceTest, ItsTimesAreOfTheCpu) {
  const Traced of_shader = traced(GetParam(), {161, 91}, {{.thickness_m = 0.3}});
  const auto native = traceNative(of_shader.input(0));
  ASSERT_TRUE(native.has_value());
  EXPECT_GT(native->pyramid.cpu_ns, 0);
  EXPECT_GT(native->trace.cpu_ns, 0);
  EXPECT_GT(native->pyramid.wall_ns, 0);
  EXPECT_GT(native->trace.wall_ns, 0);
  EXPECT_EQ(native->instruction_set, nativeInstructionSets().front());
}

TEST(NativePeers, AreTheSameEverywhereAndRunWhereTheirInstructionsDo) {
  std::vector<std::string> names;
  std::vector<std::string> run_here;
  for (const NativePeer& peer : nativePeers()) {
    names.push_back(peer.name);
    if (peer.runs_here) {
      run_here.push_back(peer.instruction_set);
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"native-avx512", "native-avx2", "native-baseline"}));
  EXPECT_EQ(run_here, nativeInstructionSets());
}

INSTANTIATE_TEST_SUITE_P(Scenes, NativeTraceTest, testing::Values("clutter", "corridor"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace ssrkit
