#include "frame/run_job.h"

#include <fmt/format.h>

#include <map>
#include <optional>

#include "base/check.h"
#include "base/text.h"
#include "frame/environment_images.h"
#include "frame/frame_drawing.h"
#include "frame/gbuffer_source.h"
#include "frame/image_transfer.h"
#include "frame/replacements.h"
#include "frame/shadow_map.h"
#include "frame/tracing.h"
#include "scene/load.h"

namespace ssrkit {

namespace {

struct LoadedScene {
  Scene scene;
  SceneResources resources;
};

Expected<Camera> sceneCamera(const Scene& scene, const Job& job) {
  std::vector<std::string> names;
  for (const SceneCamera& camera : scene.cameras) {
    if (job.camera_name.empty() || camera.name == job.camera_name) {
      return cameraFor(camera, job.size);
    }
    names.push_back(camera.name);
  }
  return inputError(fmt::format("use the camera '{}'", job.camera_name), "the scene has no such camera",
                    job.scene_file.string(), "its cameras are " + joinNames(names));
}

// A G-buffer made by others brings no lights: one from above and behind the camera, under the default sky.
Scene defaultLight() {
  Scene scene;
  scene.directional_lights = {
      {.direction_world = glm::normalize(glm::dvec3(-0.4, -0.8, -0.45)), .radiance = glm::vec3(3.0F)}};
  return scene;
}

}  // namespace

struct JobRunner::Impl {
  Device& device;
  Programs programs;
  std::map<std::string, LoadedScene> scenes;
  std::optional<FrameImages> images;

  [[nodiscard]] Expected<const LoadedScene*> loaded(const Job& job);
  [[nodiscard]] Expected<FrameDrawing> frame(const Job& job, const CompileSettings& settings,
                                             const Progress& progress, UniformValues& values,
                                             JobResult& result);
  [[nodiscard]] Expected<std::optional<DrawnScene>> scene(const Job& job, const Progress& progress,
                                                          UniformValues& values, JobResult& result);
  [[nodiscard]] Expected<std::vector<std::string>> upload(const Job& job, const Progress& progress,
                                                          UniformValues& values, JobResult& result);
  [[nodiscard]] Expected<void> light(const Job& job, const Scene& scene, const FrameKind& kind,
                                     const Progress& progress, UniformValues& values, const Camera& camera);
  [[nodiscard]] Expected<void> draw(const Job& job, const CompileSettings& settings, const Progress& progress,
                                    UniformValues& values, JobResult& result);
  [[nodiscard]] Expected<void> readFrame(const Job& job, JobResult& result);
};

JobRunner::JobRunner(Device& device, ShaderTarget target)
    : impl_(std::make_unique<Impl>(Impl{device, Programs(device, target), {}, std::nullopt})) {}

JobRunner::~JobRunner() = default;

Expected<const LoadedScene*> JobRunner::Impl::loaded(const Job& job) {
  const std::string key =
      fmt::format("{}|{}|{}", job.scene_file.string(), job.mirror_material, job.camera_name);
  if (const auto found = scenes.find(key); found != scenes.end()) {
    return &found->second;
  }
  auto scene =
      loadScene(job.scene_file, {.mirror_material = job.mirror_material, .camera_name = job.camera_name});
  if (!scene) {
    return tl::make_unexpected(scene.error());
  }
  auto resources = uploadScene(device, *scene);
  if (!resources) {
    return tl::make_unexpected(resources.error());
  }
  // One scene at a time: jobs come scene by scene, and scenes may be large.
  scenes.clear();
  return &scenes.emplace(key, LoadedScene{std::move(*scene), std::move(*resources)}).first->second;
}

Expected<std::optional<DrawnScene>> JobRunner::Impl::scene(const Job& job, const Progress& progress,
                                                           UniformValues& values, JobResult& result) {
  progress("load " + job.scene_file.filename().string());
  const auto scene = loaded(job);
  if (!scene) {
    return tl::make_unexpected(scene.error());
  }
  const auto camera = sceneCamera((*scene)->scene, job);
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  result.camera = *camera;
  result.notes = (*scene)->scene.notes;
  setCameraUniforms(values, result.camera);
  return DrawnScene{.scene = &(*scene)->scene,
                    .resources = &(*scene)->resources,
                    .shadow_cascade_count = setShadowUniforms(values, (*scene)->scene, result.camera)};
}

// The names of the images that were given.
Expected<std::vector<std::string>> JobRunner::Impl::upload(const Job& job, const Progress& progress,
                                                           UniformValues& values, JobResult& result) {
  progress("upload gbuffer");
  result.camera = *job.gbuffer_camera;
  setCameraUniforms(values, result.camera);
  // Nothing casts a shadow: there is one empty cascade.
  SSRKIT_CHECK_EQ(setShadowUniforms(values, defaultLight(), result.camera), 1);
  if (const auto uploaded = uploadGbuffer(device, job.gbuffer, *images); !uploaded) {
    return tl::make_unexpected(uploaded.error());
  }
  std::vector<std::string> given;
  for (const std::string name : {"lit", "lit_base"}) {
    const auto found = job.gbuffer.find(name);
    if (found == job.gbuffer.end()) {
      continue;
    }
    const auto image = images->get(name);
    const auto done = image ? uploadImage(device, **image, found->second, {0, 0, 0, 1})
                            : tl::make_unexpected(image.error());
    if (!done) {
      return tl::make_unexpected(done.error());
    }
    given.push_back(name);
  }
  return given;
}

// The lights' uniforms and, where the kind of frame samples them, the environment's maps.
Expected<void> JobRunner::Impl::light(const Job& job, const Scene& scene, const FrameKind& kind,
                                      const Progress& progress, UniformValues& values, const Camera& camera) {
  setLightUniforms(values, scene, camera.view_from_world);
  if (!kind.has_environment) {
    return {};
  }
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
  std::optional<DrawnScene> drawn;
  std::vector<std::string> given;
  if (job.gbuffer_camera) {
    auto uploaded = upload(job, progress, values, result);
    if (!uploaded) {
      return tl::make_unexpected(uploaded.error());
    }
    given = std::move(*uploaded);
    if ((*kind)->has_environment && given.size() == 1) {
      return inputError("light the G-buffer", fmt::format("it has '{}' alone", given.front()), "",
                        fmt::format("the frame '{}' needs both lit and lit_base, or neither", job.frame));
    }
  } else {
    const auto placed = scene(job, progress, values, result);
    if (!placed) {
      return tl::make_unexpected(placed.error());
    }
    drawn = *placed;
  }
  if (const auto lit =
          light(job, drawn ? *drawn->scene : defaultLight(), **kind, progress, values, result.camera);
      !lit) {
    return tl::make_unexpected(lit.error());
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
    auto tracing = Tracing::prepare(programs, settings, request, job.size, progress);
    if (!tracing) {
      return tl::make_unexpected(tracing.error());
    }
    tracings.push_back(std::move(*tracing));
  }
  for (int round = 0; round <= job.timing.rounds; ++round) {
    if (const auto drawn = drawing->draw(device, *images, values, progress); !drawn) {
      return drawn;
    }
    for (Tracing& tracing : tracings) {
      if (const auto drawn = tracing.draw(device, *images, values, progress); !drawn) {
        return drawn;
      }
      if (round == job.timing.rounds) {
        progress("read back");
        auto read = tracing.read(device, *images);
        if (!read) {
          return tl::make_unexpected(read.error());
        }
        result.traces.push_back(std::move(*read));
      }
    }
  }
  result.frame_passes = drawing->times();
  return {};
}

Expected<void> JobRunner::Impl::readFrame(const Job& job, JobResult& result) {
  if (!job.want_gbuffer) {
    return {};
  }
  for (const FrameImageRow& row : frameImages()) {
    const DeviceImage* image = images->find(row.name);
    if (row.folder.empty() || image == nullptr || (row.name == "depth_window" && job.gbuffer_camera)) {
      continue;
    }
    auto read = readImage(device, *image, row.channels);
    if (!read) {
      return tl::make_unexpected(read.error());
    }
    result.images.emplace(row.name, std::move(*read));
  }
  return {};
}

Expected<JobResult> JobRunner::run(const Job& job, const Progress& progress) {
  Impl& impl = *impl_;
  const auto settings = compileSettings(job);
  if (!settings) {
    return tl::make_unexpected(settings.error());
  }
  if (!impl.images || impl.images->size() != job.size) {
    impl.images.reset();
    impl.images.emplace(impl.device, job.size);
  }
  JobResult result;
  UniformValues values;
  auto done = impl.draw(job, *settings, progress, values, result);
  if (done) {
    done = impl.readFrame(job, result);
  }
  result.messages = impl.device.drainMessages();
  if (!done) {
    Error error = done.error();
    error.reasons.insert(error.reasons.end(), result.messages.begin(), result.messages.end());
    return tl::make_unexpected(std::move(error));
  }
  return result;
}

}  // namespace ssrkit
