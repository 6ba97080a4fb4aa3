#include "frame/given_gbuffer.h"

#include "base/check.h"
#include "frame/gbuffer_source.h"
#include "frame/image_transfer.h"
#include "frame/shadow_map.h"

namespace ssrkit {

const Scene& sceneOfGiven() {
  static const Scene scene = [] {
    Scene lit;
    lit.directional_lights = {
        {.direction_world = glm::normalize(glm::dvec3(-0.4, -0.8, -0.45)), .radiance = glm::vec3(3.0F)}};
    return lit;
  }();
  return scene;
}

Expected<std::vector<std::string>> uploadGiven(Device& device, const Job& job, FrameImages& images,
                                               UniformValues& values) {
  const Camera& camera = *job.gbuffer_camera;
  setCameraUniforms(values, camera);
  setLightUniforms(values, sceneOfGiven(), camera.view_from_world);
  // Nothing casts a shadow: there is one empty cascade.
  SSRKIT_CHECK_EQ(setShadowUniforms(values, sceneOfGiven(), camera), 1);
  if (const auto uploaded = uploadGbuffer(device, job.gbuffer, camera, images); !uploaded) {
    return tl::make_unexpected(uploaded.error());
  }
  std::vector<std::string> given;
  for (const std::string name : {"lit", "lit_base"}) {
    const auto found = job.gbuffer.find(name);
    if (found == job.gbuffer.end()) {
      continue;
    }
    const auto image = images.get(name);
    const auto done = image ? uploadImage(device, **image, found->second, {0, 0, 0, 1})
                            : tl::make_unexpected(image.error());
    if (!done) {
      return tl::make_unexpected(done.error());
    }
    given.push_back(name);
  }
  return given;
}

}  // namespace ssrkit
