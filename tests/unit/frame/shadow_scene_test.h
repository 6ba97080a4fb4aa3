// What the tests of shadows share: a scene drawn into the G-buffer and the shadow map, for the pass to read.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "frame/programs.h"
#include "pass_test.h"
#include "plane_scene.h"
#include "spaces/camera.h"

namespace ssrkit {

// f = 2, looking along -z, turned up by `pitch_rad`.
[[nodiscard]] Camera shadowCamera(const glm::dvec3& position, double pitch_rad, Size size);

// The way of light that comes from `elevation` over the horizon; azimuth 0 travels along -z.
[[nodiscard]] glm::dvec3 lightFrom(double elevation_deg, double azimuth_deg);

// "" when every pixel has the value, else how many have not.
[[nodiscard]] std::string allAre(const Image& shadow, float value);

class ShadowTest : public PassTest {
 protected:
  // Draws the G-buffer and the shadow map, and gives them to the pass.
  void giveScene(const Scene& scene, const Camera& camera);

  [[nodiscard]] Image shadow(const std::string& shader = "shadow.frag") {
    return PassTest::draw(shader, size_, Format::kR32f);
  }

  [[nodiscard]] bool isBackground(int x, int y) const { return std::isinf(dist_view_.at(x, y)); }
  [[nodiscard]] glm::dvec3 normalView(int x, int y) const {
    return {normal_view_.at(x, y, 0), normal_view_.at(x, y, 1), normal_view_.at(x, y, 2)};
  }

  Size size_;
  Image dist_view_;
  Image normal_view_;
  Image material_;
  Image dist_range_;

 private:
  std::unique_ptr<Programs> scene_programs_;
};

}  // namespace ssrkit
