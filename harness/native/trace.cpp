#include "native/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "base/check.h"
#include "base/share_out.h"
#include "native/depth_pyramid.h"
#include "native/hiz_kernel.h"

namespace ssrkit {

namespace {

constexpr int kRowsAtOnce = 8;  // what a thread takes on
constexpr double kInfinite = 1e30;

struct KernelRow {
  const char* peer;
  const char* instruction_set;
  const HizKernel* kernel;  // null where this CPU does not run it
};

// Widest first.
std::array<KernelRow, 3> kernelRows() {
  const HizKernel* avx512 = nullptr;
  const HizKernel* avx2 = nullptr;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    avx512 = &kHizAvx512;
  }
  avx2 = __builtin_cpu_supports("avx2") ? &kHizAvx2 : nullptr;
#endif
  return {{{"native-avx512", "AVX-512", avx512},
           {"native-avx2", "AVX2", avx2},
           {"native-baseline", "baseline", &kHizBaseline}}};
}

std::vector<const HizKernel*> kernels() {
  std::vector<const HizKernel*> list;
  for (const KernelRow& row : kernelRows()) {
    if (row.kernel != nullptr) {
      list.push_back(row.kernel);
    }
  }
  return list;
}

// As the uniforms of the shaders have it.
float uniform(double value) {
  return static_cast<float>(std::min(value, kInfinite));
}

HizScene sceneOf(const OracleInput& input, const DepthPyramid& pyramid) {
  const PixelProjection projection = pixelProjection(*input.camera);
  const TraceParameters& parameters = input.parameters;
  HizScene scene{.width = input.camera->size.width,
                 .height = input.camera->size.height,
                 .near_m = uniform(input.camera->near_m),
                 .thickness_m = uniform(parameters.thickness_m),
                 .thickness_rel = uniform(parameters.thickness_rel),
                 .max_distance_m = uniform(parameters.max_distance_m),
                 .origin_bias = uniform(parameters.origin_bias),
                 .lookup_budget = parameters.lookup_budget,
                 .coarsest_px = std::exp2(static_cast<float>(parameters.max_mip)),
                 .dist_view = input.dist_view->data.data(),
                 .normal_view = input.normal_view->data.data(),
                 .normal_channels = static_cast<int>(input.normal_view->channelCount()),
                 .pyramid = pyramid.entries.data(),
                 .pyramid_width = pyramid.width,
                 .pyramid_rows = static_cast<float>(pyramid.rows())};
  for (int axis = 0; axis < 2; ++axis) {
    scene.px_scale[axis] = uniform(projection.px_scale[axis]);
    scene.px_offset[axis] = uniform(projection.px_offset[axis]);
    scene.view_per_px[axis] = uniform(1.0 / projection.px_scale[axis]);
  }
  return scene;
}

// The texels of some rows that a ray starts from; the others get their class.
std::vector<int> raysOf(const OracleInput& input, int first_row, int end_row, RayRecord& record) {
  std::vector<int> texels;
  const int width = input.camera->size.width;
  for (int texel = first_row * width; texel < end_row * width; ++texel) {
    const auto i = static_cast<std::size_t>(texel);
    if (std::isinf(input.dist_view->data[i])) {
      record.rays[i].ray_class = RayClass::kBackground;
    } else if (input.mask == nullptr || input.mask->data[i] != 0.0F) {
      texels.push_back(texel);
    }
  }
  return texels;
}

void traceRows(const HizKernel& kernel, const HizScene& scene, const OracleInput& input, int first_row,
               RayRecord& record) {
  const int end_row = std::min(first_row + kRowsAtOnce, scene.height);
  const std::vector<int> texels = raysOf(input, first_row, end_row, record);
  std::vector<HizAnswer> answers(texels.size());
  kernel.trace(scene, texels.data(), static_cast<int>(texels.size()), answers.data());
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const HizAnswer& answer = answers[i];
    const auto lookups = static_cast<std::uint32_t>(answer.lookups);
    record.rays[static_cast<std::size_t>(texels[i])] = {.texel_x = answer.texel_x,
                                                        .texel_y = answer.texel_y,
                                                        .px_x = answer.px_x,
                                                        .px_y = answer.px_y,
                                                        .t_m = answer.t_m,
                                                        .ray_class = static_cast<RayClass>(answer.ray_class),
                                                        .lookups = lookups,
                                                        .steps = lookups};
  }
}

std::int64_t clockNs(clockid_t clock) {
  timespec now{};
  SSRKIT_CHECK_EQ(clock_gettime(clock, &now), 0);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

NativeTime timeNow() {
  return {.cpu_ns = clockNs(CLOCK_PROCESS_CPUTIME_ID), .wall_ns = clockNs(CLOCK_MONOTONIC)};
}

NativeTime between(const NativeTime& begin, const NativeTime& end) {
  return {.cpu_ns = end.cpu_ns - begin.cpu_ns, .wall_ns = end.wall_ns - begin.wall_ns};
}

void traceAll(const HizKernel& kernel, const HizScene& scene, const OracleInput& input, int thread_count,
              RayRecord& record) {
  const int pieces = (scene.height + kRowsAtOnce - 1) / kRowsAtOnce;
  forEachInParallel(pieces, thread_count,
                    [&](int piece) { traceRows(kernel, scene, input, piece * kRowsAtOnce, record); });
}

}  // namespace

std::vector<NativePeer> nativePeers() {
  std::vector<NativePeer> peers;
  for (const KernelRow& row : kernelRows()) {
    peers.push_back(
        {.name = row.peer, .instruction_set = row.instruction_set, .runs_here = row.kernel != nullptr});
  }
  return peers;
}

std::vector<std::string> nativeInstructionSets() {
  std::vector<std::string> names;
  for (const HizKernel* kernel : kernels()) {
    names.emplace_back(kernel->instruction_set);
  }
  return names;
}

Expected<NativeTrace> traceNative(const OracleInput& input, int thread_count,
                                  const std::string& instruction_set) {
  if (const auto valid = checkInput(input); !valid) {
    return tl::make_unexpected(valid.error());
  }
  SSRKIT_CHECK_LE(0, input.parameters.max_mip);
  const std::vector<const HizKernel*> all = kernels();
  const auto kernel = std::ranges::find_if(all, [&](const HizKernel* candidate) {
    return instruction_set.empty() || instruction_set == candidate->instruction_set;
  });
  SSRKIT_CHECK(kernel != all.end());
  NativeTrace result{.record = {input.camera->size, {}},
                     .instruction_set = (*kernel)->instruction_set,
                     .lane_count = (*kernel)->lane_count};
  const NativeTime start = timeNow();
  const DepthPyramid pyramid = buildDepthPyramid(*input.dist_view, input.parameters.max_mip);
  const NativeTime built = timeNow();
  result.record.rays.resize(input.dist_view->texelCount());
  traceAll(**kernel, sceneOf(input, pyramid), input, thread_count, result.record);
  result.pyramid = between(start, built);
  result.trace = between(built, timeNow());
  return result;
}

}  // namespace ssrkit
