#include "scene/scene.h"

#include "base/check.h"

namespace ssrkit {

Camera cameraFor(const SceneCamera& scene_camera, Size size) {
  SSRKIT_CHECK_LT(0, size.width);
  SSRKIT_CHECK_LT(0, size.height);
  const double aspect = static_cast<double>(size.width) / size.height;
  Camera camera;
  camera.size = size;
  camera.clip_from_view =
      perspective(scene_camera.fov_y_rad, aspect, scene_camera.near_m, scene_camera.far_m);
  camera.view_from_world = scene_camera.view_from_world;
  if (scene_camera.previous_view_from_world != scene_camera.view_from_world) {
    camera.previous_view_from_world = scene_camera.previous_view_from_world;
  }
  camera.near_m = scene_camera.near_m;
  camera.far_m = scene_camera.far_m;
  return camera;
}

}  // namespace ssrkit
