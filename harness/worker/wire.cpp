#include "worker/wire.h"

#include <limits>
#include <type_traits>
#include <variant>

#include "base/size.h"
#include "worker/archive.h"

namespace ssrkit {

namespace {

bool isPlausible(Size size) {
  return size.width >= 0 && size.width <= kMaxImageSide && size.height >= 0 && size.height <= kMaxImageSide;
}

std::size_t texelCount(Size size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

}  // namespace

// Each struct's fields, in its own order. Not in the unnamed namespace: Packer and Unpacker find them by
// argument-dependent look-up.
template <class Archive, Is<Size> T>
void fields(Archive& archive, T& size) {
  archive(size.width, size.height);
}

template <class Archive, Is<glm::dmat4> T>
void fields(Archive& archive, T& matrix) {
  for (int column = 0; column < 4; ++column) {
    auto& c = matrix[column];
    archive(c.x, c.y, c.z, c.w);
  }
}

template <class Archive, Is<Camera> T>
void fields(Archive& archive, T& camera) {
  archive(camera.size, camera.clip_from_view, camera.view_from_world, camera.previous_view_from_world,
          camera.near_m, camera.far_m);
}

template <class Archive, Is<Sequence> T>
void fields(Archive& archive, T& sequence) {
  archive(sequence.time_s, sequence.frame_count, sequence.time_step_s);
}

template <class Archive, Is<Image> T>
void fields(Archive& archive, T& image) {
  archive(image.size, image.channels);
  archive.bulk(image.data);
  archive.require(isPlausible(image.size) &&
                  image.data.size() == texelCount(image.size) * image.channels.size());
}

template <class Archive, Is<RayRecord> T>
void fields(Archive& archive, T& record) {
  archive(record.size);
  archive.bulk(record.rays);
  archive.require(isPlausible(record.size) && record.rays.size() == texelCount(record.size));
}

template <class Archive, Is<TraceParameters> T>
void fields(Archive& archive, T& p) {
  archive(p.thickness_m, p.thickness_rel, p.max_distance_m, p.origin_bias, p.lookup_budget, p.step_count,
          p.step_m, p.bisection_count, p.stride_px, p.jitter, p.max_mip, p.step_growth, p.form);
  archive.require(p.form == TracerForm::kTextbook || p.form == TracerForm::kTuned);
}

// Numbers of a peer's own: a whole one or not, and its value.
template <class Archive, Is<UniformConstant> T>
void fields(Archive& archive, T& constant) {
  bool is_whole = std::holds_alternative<int>(constant);
  double value = std::visit([](auto number) { return static_cast<double>(number); }, constant);
  archive(is_whole, value);
  constexpr std::numeric_limits<int> kInts;
  archive.require(!is_whole || (value >= kInts.min() && value <= kInts.max()));
  if constexpr (!std::is_const_v<T>) {
    is_whole = is_whole && value >= kInts.min() && value <= kInts.max();
    constant = is_whole ? UniformConstant(static_cast<int>(value)) : UniformConstant(value);
  }
}

template <class Archive, Is<PeerShader> T>
void fields(Archive& archive, T& peer) {
  archive(peer.name, peer.file, peer.images, peer.values, peer.constants, peer.depth, peer.mips, peer.normal,
          peer.answer, peer.hit_channel, peer.lookups_channel);
}

template <class Archive, Is<TraceRequest> T>
void fields(Archive& archive, T& request) {
  archive(request.stage, request.parameters, request.technique, request.peer);
}

template <class Archive, Is<ShaderReplacement> T>
void fields(Archive& archive, T& replacement) {
  archive(replacement.pass, replacement.file);
}

template <class Archive, Is<glm::vec3> T>
void fields(Archive& archive, T& vector) {
  archive(vector.x, vector.y, vector.z);
}

template <class Archive, Is<EnvironmentChoice> T>
void fields(Archive& archive, T& choice) {
  archive(choice.file, choice.constant);
}

template <class Archive, Is<Job> T>
void fields(Archive& archive, T& job) {
  archive(job.id, job.scene_file, job.camera_name, job.mirror_material, job.environment, job.gbuffer,
          job.gbuffer_camera, job.size, job.frame, job.sequence, job.traces, job.timing.rounds,
          job.replacements, job.may_replace_nothing, job.shader_root, job.variant, job.want_gbuffer);
}

template <class Archive, Is<PassTime> T>
void fields(Archive& archive, T& time) {
  archive(time.wall_ns, time.cpu_ns, time.device_ns);
}

template <class Archive, Is<PassReport> T>
void fields(Archive& archive, T& report) {
  archive(report.pass, report.cold, report.steady);
}

template <class Archive, Is<TraceResult> T>
void fields(Archive& archive, T& trace) {
  archive(trace.stage, trace.technique, trace.parameters, trace.record, trace.images, trace.passes);
}

template <class Archive, Is<SetupTimes> T>
void fields(Archive& archive, T& times) {
  archive(times.compile_ns, times.pipeline_ns);
}

template <class Archive, Is<JobResult> T>
void fields(Archive& archive, T& result) {
  archive(result.camera, result.images, result.traces, result.frame_passes, result.drawn_passes, result.setup,
          result.notes, result.messages);
}

template <class Archive, Is<Error> T>
void fields(Archive& archive, T& error) {
  archive(error.kind, error.attempted, error.problem, error.where, error.remedy, error.reasons);
  archive.require(error.kind == ErrorKind::kInput || error.kind == ErrorKind::kSetup);
}

template <class Archive, Is<DeviceInfo> T>
void fields(Archive& archive, T& info) {
  auto& identity = info.identity;
  archive(identity.id, identity.api, identity.driver, identity.version, identity.cpu, identity.cpu_features);
  archive(info.traits.loop_cap, info.traits.device_timer_usable, info.traits.shader_input, info.create_ns);
}

namespace {

template <class... Values>
Expected<Payload> pack(const Values&... values) {
  Packer packer;
  packer(values...);
  return packer.finish();
}

template <class T>
std::optional<T> unpack(const Payload& payload) {
  Unpacker unpacker(payload);
  T value;
  unpacker(value);
  return unpacker.succeeded() ? std::optional<T>(std::move(value)) : std::nullopt;
}

}  // namespace

Expected<Payload> packStart(const std::filesystem::path& shader_root) {
  return pack(shader_root);
}
Expected<Payload> packInfo(const DeviceInfo& info) {
  return pack(info);
}
Expected<Payload> packResult(JobResult result) {
  Packer packer;
  packer(result);
  return packer.finish();
}
Expected<Payload> packError(const Error& error) {
  return pack(error);
}

Expected<Payload> packJob(const Job& job, std::chrono::seconds cpu_limit) {
  return pack(std::int64_t{cpu_limit.count()}, job);
}

std::optional<std::filesystem::path> unpackStart(const Payload& payload) {
  return unpack<std::filesystem::path>(payload);
}
std::optional<DeviceInfo> unpackInfo(const Payload& payload) {
  return unpack<DeviceInfo>(payload);
}
std::optional<JobResult> unpackResult(const Payload& payload) {
  return unpack<JobResult>(payload);
}
std::optional<Error> unpackError(const Payload& payload) {
  return unpack<Error>(payload);
}

std::optional<LimitedJob> unpackJob(const Payload& payload) {
  Unpacker unpacker(payload);
  std::int64_t cpu_limit_s = 0;
  LimitedJob limited;
  unpacker(cpu_limit_s, limited.job);
  limited.cpu_limit = std::chrono::seconds(cpu_limit_s);
  return unpacker.succeeded() ? std::optional(std::move(limited)) : std::nullopt;
}

}  // namespace ssrkit
