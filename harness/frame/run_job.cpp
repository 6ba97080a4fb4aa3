#include "frame/run_job.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <string>

#include "frame/changed_view.h"
#include "frame/draw_sequence.h"
#include "frame/environment_images.h"
#include "frame/first_draws.h"
#include "frame/frame_drawing.h"
#include "frame/frame_read_back.h"
#include "frame/given_gbuffer.h"
#include "frame/posed_scene.h"
#include "frame/replacements.h"
#include "frame/tiled_device.h"
#include "frame/tracing.h"
#include "frame/variants.h"
#include "shader/module_variants.h"

namespace ssrkit {

namespace {

constexpr int kTileColumns = 3;
constexpr int kTileRows = 2;

}  // namespace

struct JobRunner::Impl {
  Impl(Device& drawn_on, ShaderTarget target)
      : device(drawn_on),
        first_draws(drawn_on),
        tiled(first_draws, kTileColumns, kTileRows),
        programs(drawn_on, target) {}

  Device& device;
  FirstDraws first_draws;
  TiledDevice tiled;
  Programs programs;
  std::map<std::string, PosedScene> scenes;
  std::optional<FrameImages> images;

  [[nodiscard]] Expected<JobResult> run(const Job& job, const ViewChange& view, const Progress& progress);
  [[nodiscard]] Expected<PosedScene*> loaded(const Job& job);
  [[nodiscard]] Expected<FrameDrawing> frame(const Job& job, const CompileSettings& settings,
                                             const Progress& progress, UniformValues& values,
                                             JobResult& result);
  [[nodiscard]] Expected<const PosedScene*> scene(const Job& job, const Progress& progress,
                                                  JobResult& result);
  [[nodiscard]] Expected<void> pose(const Job& job, int frame, UniformValues& values, JobResult& result);
  [[nodiscard]] Expected<void> environment(const Job& job, const Scene& scene, const Progress& progress,
                                           UniformValues& values);
  [[nodiscard]] Expected<void> draw(const Job& job, const CompileSettings& settings, const Progress& progress,
                                    UniformValues& values, JobResult& result);
};

JobRunner::JobRunner(Device& device, ShaderTarget target) : impl_(std::make_unique<Impl>(device, target)) {}

JobRunner::~JobRunner() = default;

Expected<PosedScene*> JobRunner::Impl::loaded(const Job& job) {
  const std::string key =
      fmt::format("{}|{}|{}", job.scene_file.string(), job.mirror_material, job.camera_name);
  if (const auto found = scenes.find(key); found != scenes.end()) {
    return &found->second;
  }
  auto scene = loadPosedScene(device, job);
  if (!scene) {
    return tl::make_unexpected(scene.error());
  }
  // One scene at a time: jobs come scene by scene, and scenes may be large.
  scenes.clear();
  return &scenes.emplace(key, *std::move(scene)).first->second;
}

Expected<const PosedScene*> JobRunner::Impl::scene(const Job& job, const Progress& progress,
                                                   JobResult& result) {
  progress("load " + job.scene_file.filename().string());
  const auto scene = loaded(job);
  if (!scene) {
    return tl::make_unexpected(scene.error());
  }
  result.notes = (*scene)->scene.notes;
  return *scene;
}

// A G-buffer made by others stays as it is.
Expected<void> JobRunner::Impl::pose(const Job& job, int frame, UniformValues& values, JobResult& result) {
  values.set("frame_index", frame);
  if (job.gbuffer_camera) {
    return {};
  }
  const auto scene = loaded(job);
  if (!scene) {
    return tl::make_unexpected(scene.error());
  }
  const auto camera = poseForFrame(device, job, frame, **scene, values);
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  result.camera = *camera;
  return {};
}

// The maps of what is around the scene.
Expected<void> JobRunner::Impl::environment(const Job& job, const Scene& scene, const Progress& progress,
                                            UniformValues& values) {
  progress("prepare environment");
  const auto maps = environmentMaps(environmentSource(scene, job.environment));
  return maps ? uploadEnvironment(device, *maps, *images, values) : tl::make_unexpected(maps.error());
}

Expected<FrameDrawing> JobRunner::Impl::frame(const Job& job, const CompileSettings& settings,
                                              const Progress& progress, UniformValues& values,
                                              JobResult& result) {
  const auto kind = findFrameKind(job.frame);
  if (!kind) {
    return tl::make_unexpected(kind.error());
  }
  const PosedScene* drawn = nullptr;
  std::vector<std::string> given;
  if (job.gbuffer_camera) {
    progress("upload gbuffer");
    result.camera = *job.gbuffer_camera;
    auto uploaded = uploadGiven(device, job, *images, values);
    if (!uploaded) {
      return tl::make_unexpected(uploaded.error());
    }
    given = std::move(*uploaded);
    if ((*kind)->has_environment && given.size() == 1) {
      return inputError("light the G-buffer", fmt::format("it has '{}' alone", given.front()), "",
                        fmt::format("the frame '{}' needs both lit and lit_base, or neither", job.frame));
    }
  } else {
    const auto placed = scene(job, progress, result);
    if (!placed) {
      return tl::make_unexpected(placed.error());
    }
    drawn = *placed;
  }
  if ((*kind)->has_environment) {
    const Scene& around = drawn != nullptr ? drawn->scene : sceneOfGiven();
    if (const auto made = environment(job, around, progress, values); !made) {
      return tl::make_unexpected(made.error());
    }
  }
  return FrameDrawing::prepare(programs, settings, **kind, drawn, given, progress);
}

Expected<void> JobRunner::Impl::draw(const Job& job, const CompileSettings& settings,
                                     const Progress& progress, UniformValues& values, JobResult& result) {
  auto drawing = frame(job, settings, progress, values, result);
  if (!drawing) {
    return tl::make_unexpected(drawing.error());
  }
  std::vector<Tracing> tracings;
  for (const TraceRequest& request : job.traces) {
    auto tracing = Tracing::prepare(programs, settings, job, request, progress);
    if (!tracing) {
      return tl::make_unexpected(tracing.error());
    }
    tracings.push_back(std::move(*tracing));
  }
  const std::set<std::string> passes = programs.takePassNames();
  if (const auto taken = checkReplacementsTookPlace(job.replacements, passes);
      !taken && !job.may_replace_nothing) {
    return taken;
  }
  result.drawn_passes.assign(passes.begin(), passes.end());
  const auto variant = findVariant(job.variant);
  if (!variant) {
    return tl::make_unexpected(variant.error());
  }
  first_draws.startJob(progress);
  Device& drawn_by = (*variant)->is_tiled ? static_cast<Device&>(tiled) : first_draws;
  const auto drawn = drawSequence({.device = drawn_by,
                                   .images = *images,
                                   .frame = *drawing,
                                   .traces = tracings,
                                   .values = values,
                                   .progress = progress,
                                   .pose = [&](int frame) { return pose(job, frame, values, result); }},
                                  job.sequence.frame_count, job.timing.rounds, result);
  if (!drawn) {
    return drawn;
  }
  result.frame_passes = drawing->times();
  return {};
}

Expected<JobResult> JobRunner::run(const Job& job, const Progress& progress) {
  const auto variant = findVariant(job.variant);
  if (!variant) {
    return tl::make_unexpected(variant.error());
  }
  const ViewChange& view = (*variant)->view;
  return view == ViewChange{} ? impl_->run(job, view, progress)
                              : impl_->run(jobIn(view, job), view, progress);
}

Expected<JobResult> JobRunner::Impl::run(const Job& job, const ViewChange& view, const Progress& progress) {
  const auto settings = compileSettings(job);
  if (!settings) {
    return tl::make_unexpected(settings.error());
  }
  const Size size = sizeIn(view, job.size);
  if (!images || images->size() != size) {
    images.reset();
    images.emplace(device, size);
  }
  JobResult result;
  programs.takePassNames();  // of a job that failed
  UniformValues values;
  if (settings->form == ModuleForm::kDeadCode) {
    values.set(kDeadCodeZero, -0.0);
  }
  auto done = draw(job, *settings, progress, values, result);
  if (done && job.want_gbuffer) {
    done = readFrame(device, *images, job.gbuffer_camera.has_value()).map([&](auto read) {
      result.images = std::move(read);
    });
  }
  if (isLargeFrame(size)) {
    images.reset();
  }
  result.setup = programs.takeTimes();
  result.messages = device.drainMessages();
  if (!done) {
    Error error = done.error();
    error.reasons.insert(error.reasons.end(), result.messages.begin(), result.messages.end());
    return tl::make_unexpected(std::move(error));
  }
  return result;
}

}  // namespace ssrkit
