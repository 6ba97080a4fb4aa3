// The room that reprojection and accumulation are held to closed forms in, m1: camera one metre above a
// mirror floor, wall eight metres ahead, f = 2, 256 x 256, so px_scale = (256, -256) and the floor begins at
// row 160.
#pragma once

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "pass_test.h"

namespace ssrkit {

inline constexpr Size kRoomSize{256, 256};
inline constexpr double kScalePx = 256.0;
inline constexpr double kWallM = 8.0;
inline constexpr int kFloorRow = 160;
inline constexpr double kRoomTolerance = 3e-6;  // of colours up to 1: 8e-4 px

inline bool isFloorRow(int y) {
  return y >= kFloorRow;
}

// Metres along the view axis of what the texel's centre shows, with the wall `further_m` further away.
inline double roomDistAt(int y, double further_m = 0.0) {
  return isFloorRow(y) ? kScalePx / (y + 0.5 - 128.0) : kWallM + further_m;
}

inline glm::dvec2 roomPxOf(const glm::dvec3& p_view) {
  return {128.0 + kScalePx * p_view.x / -p_view.z, 128.0 - kScalePx * p_view.y / -p_view.z};
}

inline glm::dvec3 roomViewOf(const glm::dvec2& p_px, double dist) {
  return {dist * (p_px.x - 128.0) / kScalePx, -dist * (p_px.y - 128.0) / kScalePx, -dist};
}

// The wall texel that a floor texel shows: its mirror image about the row 160 (docs/spaces.md).
inline std::array<double, 4> hitOf(int x, int y) {
  return isFloorRow(y) ? std::array<double, 4>{1.0 * x, 319.0 - y} : std::array<double, 4>{-1.0, -1.0};
}

// How the camera moved since the previous frame: to the right, and ahead.
struct Step {
  double right_m = 0.0;
  double ahead_m = 0.0;
};

inline glm::dvec3 previousView(const glm::dvec3& p_view, const Step& step) {
  return p_view + glm::dvec3(step.right_m, 0.0, -step.ahead_m);
}

inline glm::dvec2 cameraMotion(int x, int y, const Step& step) {
  const glm::dvec3 p_view = roomViewOf({x + 0.5, y + 0.5}, roomDistAt(y));
  return roomPxOf(p_view) - roomPxOf(previousView(p_view, step));
}

class TemporalTest : public PassTest {
 protected:
  // The room of m1 and how it moved; `own_px` is added to the motion of every wall texel.
  void giveRoom(const Step& step, const glm::dvec2& own_px = {}) {
    begin();
    values_.set("previous_view_from_view",
                glm::translate(glm::dmat4(1.0), glm::dvec3(step.right_m, 0.0, -step.ahead_m)));
    values_.set("size_px", glm::dvec2(kRoomSize.width, kRoomSize.height));
    values_.set("px_scale", glm::dvec2(kScalePx, -kScalePx));
    values_.set("px_offset", glm::dvec2(128.0));
    values_.set("view_per_px", glm::dvec2(1.0 / kScalePx, -1.0 / kScalePx));
    values_.set("texel_uv", glm::dvec2(1.0 / 256.0));
    values_.set("near_m", 0.1);
    values_.set("disocclusion_rel", 0.02);
    values_.set("max_history_length", 9.0);
    values_.set("is_straight_alpha", 1);
    give("dist_view",
         imageOf(
             kRoomSize, [](int, int y) { return std::array<double, 4>{roomDistAt(y)}; }, 1),
         Format::kR32f);
    give("normal_view", imageOf(kRoomSize, [](int, int y) {
           return isFloorRow(y) ? std::array{0.0, 1.0, 0.0, 1.0} : std::array{0.0, 0.0, 1.0, 1.0};
         }));
    give("material", imageOf(kRoomSize, [](int, int y) {
           return std::array{1.0, 0.0, isFloorRow(y) ? 1.0 : 0.0, 1.0};
         }));
    give("motion",
         imageOf(
             kRoomSize,
             [&](int x, int y) {
               const glm::dvec2 motion =
                   cameraMotion(x, y, step) + (isFloorRow(y) ? glm::dvec2(0.0) : own_px);
               return std::array<double, 4>{motion.x, motion.y};
             },
             2),
         Format::kRg32f);
    give("previous_dist_view",
         imageOf(
             kRoomSize, [&](int, int y) { return std::array<double, 4>{roomDistAt(y, step.ahead_m)}; }, 1),
         Format::kR32f);
    giveIntegers("hit_texel", imageOf(kRoomSize, hitOf, 2), Format::kRg16i);
    // Along the ray's own line the wall's mirror image lies at the wall's depth.
    give("hit_point", imageOf(kRoomSize, [](int x, int y) {
           const double dist = roomDistAt(y);
           const double t_m = isFloorRow(y)
                                  ? glm::length(roomViewOf({x + 0.5, y + 0.5}, dist)) * (kWallM / dist - 1.0)
                                  : -1.0;
           return std::array{x + 0.5, 319.5 - y, t_m, 0.0};
         }));
  }

  // An image whose red and green are the texel's position over the image's size.
  void giveRamp(const std::string& name) {
    give(name, imageOf(kRoomSize, [](int x, int y) {
           return std::array{(x + 0.5) / 256.0, (y + 0.5) / 256.0, 0.0, 1.0};
         }));
  }

  // The first floor texel whose red and green are not those of a ramp at the position that the formula gives.
  // Texels within two of the image's edge or of the wall's foot are left out: there a tap is on another
  // surface.
  static std::string followsRamp(const Image& got,
                                 const std::function<glm::dvec2(int x, int y)>& position_px) {
    for (int y = kFloorRow + 2; y < kRoomSize.height - 2; ++y) {
      for (int x = 0; x < kRoomSize.width; ++x) {
        const glm::dvec2 position = position_px(x, y);
        const bool is_inside = position.x > 2 && position.x < 254 && position.y > 2 && position.y < 254 &&
                               std::abs(position.y - kFloorRow) > 2;
        const double off = std::max(std::abs(got.at(x, y, 0) - position.x / 256.0),
                                    std::abs(got.at(x, y, 1) - position.y / 256.0));
        if (is_inside && !(off <= kRoomTolerance)) {
          return fmt::format("texel {}, {} is the ramp at {}, {} where {}, {} is right", x, y,
                             256 * got.at(x, y, 0), 256 * got.at(x, y, 1), position.x, position.y);
        }
      }
    }
    return "";
  }
};

}  // namespace ssrkit
