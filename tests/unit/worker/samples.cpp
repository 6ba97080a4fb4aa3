#include "samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace ssrkit {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Image sampleImage(Size size, std::vector<std::string> channels) {
  Image image(size, std::move(channels));
  const float specials[] = {std::numeric_limits<float>::quiet_NaN(),
                            std::bit_cast<float>(0xFFC12345U),  // a NaN with a sign and a payload
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            -0.0F,
                            std::numeric_limits<float>::denorm_min(),
                            0.1F};
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    image.data[i] = i < std::size(specials) ? specials[i] : static_cast<float>(i) / 7.0F;
  }
  return image;
}

Camera sampleCamera() {
  Camera camera;
  camera.size = {7, 5};
  for (int i = 0; i < 16; ++i) {
    camera.clip_from_view[i / 4][i % 4] = 1.0 / (i + 3);
    camera.view_from_world[i / 4][i % 4] = -std::sqrt(i + 2.0);
  }
  camera.previous_view_from_world = 3.0 * camera.view_from_world;
  camera.near_m = 0.1 + 0.2;  // 0.30000000000000004
  camera.far_m = kInfinity;
  return camera;
}

TraceParameters sampleParameters() {
  TraceParameters p;
  p.thickness_m = 0.1;
  p.thickness_rel = 1e-300;
  p.max_distance_m = kInfinity;
  p.origin_bias = -0.0;
  p.lookup_budget = 12345;
  p.step_count = 77;
  p.step_m = std::nextafter(1.0, 2.0);
  p.bisection_count = 9;
  p.stride_px = 4;
  p.jitter = 1.0 / 3.0;
  p.max_mip = 6;
  p.step_growth = 1.0625;
  p.form = TracerForm::kTextbook;
  return p;
}

RayRecord sampleRecord() {
  RayRecord record{{3, 2}, {}};
  for (int i = 0; i < 6; ++i) {
    const auto f = static_cast<float>(i);
    record.rays.push_back({i, -i, f + 0.25F, -f, f == 3.0F ? std::nanf("") : f / 3.0F,
                           static_cast<RayClass>(i), static_cast<std::uint32_t>(4294967295U - i),
                           static_cast<std::uint32_t>(i)});
  }
  return record;
}

std::vector<PassReport> sampleReports() {
  const std::int64_t large = std::numeric_limits<std::int64_t>::max();
  return {{"trace_hiz", {large, 2, -3}, {{4, 5, std::nullopt}, {6, 7, 8}}}, {"", {}, {}}};
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class T, class Same>
bool samePresence(const std::optional<T>& a, const std::optional<T>& b, const Same& same) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

constexpr auto kSame = [](const auto& a, const auto& b) { return sameBits(a, b); };

bool sameImages(const std::map<std::string, Image>& a, const std::map<std::string, Image>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && sameBits(x.second, y.second);
  });
}

bool sameTime(const PassTime& a, const PassTime& b) {
  return a.wall_ns == b.wall_ns && a.cpu_ns == b.cpu_ns && a.device_ns == b.device_ns;
}

}  // namespace

Job sampleJob() {
  Job job;
  job.id = "clutter 7x5 \"quoted\"";
  job.scene_file = "scenes/\xff\xfe not UTF-8.gltf";
  job.camera_name = std::string("nul \0 inside", 12);
  job.mirror_material = "Glas grün";
  job.environment = EnvironmentChoice{.file = "sky.exr", .constant = glm::vec3(1.0F, 0.5F, 0.25F)};
  job.gbuffer["dist_view"] = sampleImage({7, 5}, {"Z"});
  job.gbuffer["normal_view"] = sampleImage({7, 5}, {"X", "Y", "Z"});
  job.gbuffer["nothing"] = Image();
  job.gbuffer_camera = sampleCamera();
  job.size = {7, 5};
  job.frame = "full";
  job.sequence = {.time_s = 1.0 / 3.0, .frame_count = 5, .time_step_s = 0.1};
  job.traces = {{"hiz", sampleParameters(), "replace"}, {"dda", {}, ""}};
  job.traces[1].peer = PeerShader{.name = "somebody's",
                                  .file = "peers/a.hlsl",
                                  .images = {{"depthTex", "depth"}},
                                  .values = {{"viewport", "size_px"}},
                                  .constants = {{"steps", 64}, {"bias", 0.1}},
                                  .depth = PeerDepth::kWindowReversed,
                                  .normal = PeerNormal::kForward,
                                  .answer = PeerAnswer::kTexel,
                                  .hit_channel = 2,
                                  .lookups_channel = 1};
  job.timing.rounds = 11;
  job.replacements = {{"trace_hiz", "/tmp/mine.frag"}};
  job.may_replace_nothing = true;
  job.shader_root = "shaders";
  job.variant = "tiled";
  job.want_gbuffer = false;
  return job;
}

JobResult sampleResult() {
  JobResult result;
  result.camera = sampleCamera();
  result.images["lit"] = sampleImage({5, 3}, {"R", "G", "B"});
  result.images["motion"] = sampleImage({1, 9}, {"motion.x", "motion.y"});
  TraceResult trace;
  trace.stage = "hiz";
  trace.technique = "replace";
  trace.parameters = sampleParameters();
  trace.record = sampleRecord();
  trace.images["reflection"] = sampleImage({3, 2}, {"R", "G", "B", "A"});
  trace.passes = sampleReports();
  result.traces = {trace, TraceResult{}};
  result.traces[1].images["composite"] = sampleImage({3, 2}, {"R", "G", "B"});
  result.frame_passes = sampleReports();
  result.setup = {.compile_ns = 123, .pipeline_ns = -456};
  result.notes = {"a light was added", ""};
  result.drawn_passes = {"light", "trace_hiz"};
  result.messages = {"driver said \x80"};
  return result;
}

bool sameBits(const Image& a, const Image& b) {
  return a.size == b.size && a.channels == b.channels && a.data.size() == b.data.size() &&
         (a.data.empty() || std::memcmp(a.data.data(), b.data.data(), a.data.size() * sizeof(float)) == 0);
}

bool sameBits(const Camera& a, const Camera& b) {
  bool same = a.size == b.size && a.previous_view_from_world == b.previous_view_from_world &&
              sameBits(a.near_m, b.near_m) && sameBits(a.far_m, b.far_m);
  for (int i = 0; i < 16; ++i) {
    same = same && sameBits(a.clip_from_view[i / 4][i % 4], b.clip_from_view[i / 4][i % 4]) &&
           sameBits(a.view_from_world[i / 4][i % 4], b.view_from_world[i / 4][i % 4]);
  }
  return same;
}

bool sameBits(const TraceParameters& a, const TraceParameters& b) {
  return a == b && std::signbit(a.origin_bias) == std::signbit(b.origin_bias);
}

bool sameBits(const RayRecord& a, const RayRecord& b) {
  return a.size == b.size && std::equal(a.rays.begin(), a.rays.end(), b.rays.begin(), b.rays.end(),
                                        [](const RayHit& x, const RayHit& y) {
                                          return x.texel_x == y.texel_x && x.texel_y == y.texel_y &&
                                                 sameBits(x.px_x, y.px_x) && sameBits(x.px_y, y.px_y) &&
                                                 sameBits(x.t_m, y.t_m) && x.ray_class == y.ray_class &&
                                                 x.lookups == y.lookups && x.steps == y.steps;
                                        });
}

bool sameBits(const std::vector<PassReport>& a, const std::vector<PassReport>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PassReport& x, const PassReport& y) {
    return x.pass == y.pass && sameTime(x.cold, y.cold) &&
           std::equal(x.steady.begin(), x.steady.end(), y.steady.begin(), y.steady.end(), sameTime);
  });
}

bool sameBits(const Job& a, const Job& b) {
  const auto same_trace = [](const TraceRequest& x, const TraceRequest& y) {
    return x.stage == y.stage && sameBits(x.parameters, y.parameters) && x.technique == y.technique &&
           x.peer == y.peer;
  };
  const auto same_replacement = [](const ShaderReplacement& x, const ShaderReplacement& y) {
    return x.pass == y.pass && x.file == y.file;
  };
  return a.id == b.id && a.scene_file == b.scene_file && a.camera_name == b.camera_name &&
         a.mirror_material == b.mirror_material && a.environment == b.environment &&
         sameImages(a.gbuffer, b.gbuffer) && samePresence(a.gbuffer_camera, b.gbuffer_camera, kSame) &&
         a.size == b.size && a.frame == b.frame && a.sequence == b.sequence &&
         std::equal(a.traces.begin(), a.traces.end(), b.traces.begin(), b.traces.end(), same_trace) &&
         a.timing.rounds == b.timing.rounds &&
         std::equal(a.replacements.begin(), a.replacements.end(), b.replacements.begin(),
                    b.replacements.end(), same_replacement) &&
         a.may_replace_nothing == b.may_replace_nothing && a.shader_root == b.shader_root &&
         a.variant == b.variant && a.want_gbuffer == b.want_gbuffer;
}

bool sameBits(const JobResult& a, const JobResult& b) {
  const auto same_trace = [](const TraceResult& x, const TraceResult& y) {
    return x.stage == y.stage && sameBits(x.parameters, y.parameters) && sameBits(x.record, y.record) &&
           x.technique == y.technique && sameImages(x.images, y.images) && sameBits(x.passes, y.passes);
  };
  return sameBits(a.camera, b.camera) && sameImages(a.images, b.images) &&
         std::equal(a.traces.begin(), a.traces.end(), b.traces.begin(), b.traces.end(), same_trace) &&
         sameBits(a.frame_passes, b.frame_passes) && a.drawn_passes == b.drawn_passes && a.setup == b.setup &&
         a.notes == b.notes && a.messages == b.messages;
}

}  // namespace ssrkit
