#include "frame/posed_scene.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/text.h"
#include "frame/changed_view.h"
#include "frame/gbuffer_source.h"
#include "frame/shadow_map.h"
#include "frame/variants.h"
#include "scene/load.h"
#include "scene/motion.h"

namespace ssrkit {

namespace {

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

}  // namespace

Expected<PosedScene> loadPosedScene(Device& device, const Job& job) {
  auto scene =
      loadScene(job.scene_file, {.mirror_material = job.mirror_material, .camera_name = job.camera_name});
  if (!scene) {
    return tl::make_unexpected(scene.error());
  }
  auto resources = uploadScene(device, *scene);
  if (!resources) {
    return tl::make_unexpected(resources.error());
  }
  return PosedScene{.scene = *std::move(scene), .resources = *std::move(resources)};
}

Expected<Camera> poseForFrame(Device& device, const Job& job, int frame, PosedScene& posed,
                              UniformValues& values) {
  Scene& scene = posed.scene;
  if (scene.motion != nullptr) {
    if (auto done = poseScene(scene, timeOf(job.sequence, frame), previousTimeOf(job.sequence, frame));
        !done) {
      return tl::make_unexpected(done.error());
    }
    auto vertices = uploadVertices(device, scene);
    if (!vertices) {
      return tl::make_unexpected(vertices.error());
    }
    posed.resources.vertices = std::move(*vertices);
  }
  const auto variant = findVariant(job.variant);
  if (!variant) {
    return tl::make_unexpected(variant.error());
  }
  auto camera =
      sceneCamera(scene, job).map([&](const Camera& whole) { return cameraIn((*variant)->view, whole); });
  if (camera) {
    setCameraUniforms(values, *camera);
    setLightUniforms(values, scene, camera->view_from_world);
    posed.shadow_cascade_count = setShadowUniforms(values, scene, *camera);
  }
  return camera;
}

}  // namespace ssrkit
