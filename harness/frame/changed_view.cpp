#include "frame/changed_view.h"

#include <glm/gtc/matrix_transform.hpp>

namespace ssrkit {

namespace {

// So that texels stay as large as they are, and their upper left one is the crop's.
void cropProjection(Camera& camera, const Crop& crop) {
  const PixelProjection whole = pixelProjection(camera);
  const glm::dvec2 offset = whole.px_offset - glm::dvec2(crop.x, crop.y);
  const glm::dvec2 half_size(0.5 * crop.size.width, 0.5 * crop.size.height);
  camera.size = crop.size;
  camera.clip_from_view[0][0] = whole.px_scale.x / half_size.x;
  camera.clip_from_view[1][1] = -whole.px_scale.y / half_size.y;
  camera.clip_from_view[2][0] = 1.0 - offset.x / half_size.x;
  camera.clip_from_view[2][1] = offset.y / half_size.y - 1.0;
}

}  // namespace

Camera cameraIn(const ViewChange& view, const Camera& camera) {
  Camera seen = camera;
  if (view.is_cropped) {
    cropProjection(seen, cropOf(camera.size));
  }
  const glm::dvec3 axes(view.is_mirrored ? -view.scale : view.scale, view.scale, view.scale);
  const glm::dmat4 change = glm::scale(glm::dmat4(1.0), axes);
  seen.view_from_world = change * seen.view_from_world;
  if (seen.previous_view_from_world) {
    seen.previous_view_from_world = change * *seen.previous_view_from_world;
  }
  seen.clip_from_view[2][0] *= view.is_mirrored ? -1.0 : 1.0;
  seen.clip_from_view[3][2] *= view.scale;
  seen.near_m *= view.scale;
  seen.far_m *= view.scale;
  return seen;
}

TraceParameters parametersIn(const ViewChange& view, const TraceParameters& parameters) {
  TraceParameters seen = parameters;
  seen.thickness_m *= view.scale;
  seen.max_distance_m *= view.scale;
  seen.step_m *= view.scale;
  return seen;
}

Job jobIn(const ViewChange& view, Job job) {
  for (TraceRequest& request : job.traces) {
    request.parameters = parametersIn(view, request.parameters);
  }
  for (auto& [name, image] : job.gbuffer) {
    image = imageIn(view, name, image);
  }
  if (job.gbuffer_camera) {
    job.gbuffer_camera = cameraIn(view, *job.gbuffer_camera);
  }
  return job;
}

}  // namespace ssrkit
