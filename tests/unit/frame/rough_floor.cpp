#include "rough_floor.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "ggx_reference.h"
#include "oracle/oracle.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr int kSide = kFloorSize.width;
constexpr double kWallDistance = 8.0;

bool isFloor(int y) {
  return y >= kFirstFloorRow;
}

double distAt(int y) {
  return isFloor(y) ? 2.0 / ((y + 0.5) / (0.5 * kSide) - 1.0) : kWallDistance;
}

glm::dvec3 pointAt(int x, int y) {
  const PixelProjection projection = pixelProjection(floorCamera());
  const glm::dvec2 slope = (glm::dvec2(x + 0.5, y + 0.5) - projection.px_offset) / projection.px_scale;
  return distAt(y) * glm::dvec3(slope, -1.0);
}

// A wall that is bright on its right half; the floor's own light is never seen in the floor.
double litAt(int x) {
  return x < kSide / 2 ? 0.125 : 1.0;
}

// The floor's frame with the eye over its x axis, and the direction to the eye.
struct Place {
  glm::dvec3 along;
  glm::dvec3 aside;
  glm::dvec3 to_eye;
  [[nodiscard]] glm::dvec3 inView(const glm::dvec3& d) const {
    return d.x * along + d.y * aside + d.z * glm::dvec3(0, 1, 0);
  }
};

Place placeAt(int x, int y) {
  const glm::dvec3 to_eye = -glm::normalize(pointAt(x, y));
  const glm::dvec3 along = glm::normalize(to_eye - to_eye.y * glm::dvec3(0, 1, 0));
  return {.along = along, .aside = glm::cross(glm::dvec3(0, 1, 0), along), .to_eye = to_eye};
}

// The lit texel hit, else the sky's gradient, by the horizon's square root.
double radianceOf(const RayHit& hit, const glm::dvec3& direction) {
  return hit.ray_class == RayClass::kHit && !isFloor(hit.texel_y) ? litAt(hit.texel_x)
         : hit.ray_class == RayClass::kHit
             ? 0.0
             : glm::mix(kFloorHorizon.x, kFloorZenith.x, std::sqrt(std::max(direction.y, 0.0)));
}

}  // namespace

const Camera& floorCamera() {
  static const Camera the_camera{.size = kFloorSize,
                                 .clip_from_view = perspective(2.0 * std::atan(0.5), 1.0, 0.1, 100.0),
                                 .view_from_world = glm::dmat4(1.0),
                                 .near_m = 0.1,
                                 .far_m = 100.0};
  return the_camera;
}

std::map<std::string, Image> floorGbuffer(const RoughnessOf& roughness_of) {
  std::map<std::string, Image> images;
  images["dist_view"] = imageOf(
      kFloorSize,
      [](int, int y) {
        return std::array{distAt(y), 0.0, 0.0, 0.0};
      },
      1);
  images["normal_view"] = imageOf(kFloorSize, [](int, int y) {
    return isFloor(y) ? std::array{0.0, 1.0, 0.0, 1.0} : std::array{0.0, 0.0, 1.0, 1.0};
  });
  images["material"] = imageOf(
      kFloorSize,
      [&](int x, int y) {
        return std::array{1.0, roughness_of(x), isFloor(y) ? 1.0 : 0.0, 0.0};
      },
      3);
  images["albedo"] = imageOf(
      kFloorSize,
      [](int, int) {
        return std::array{1.0, 1.0, 1.0, 1.0};
      },
      3);
  images["lit"] = imageOf(
      kFloorSize,
      [](int x, int y) {
        const double lit = isFloor(y) ? 0.0 : litAt(x);
        return std::array{lit, lit, lit, 1.0};
      },
      3);
  return images;
}

double floorCosine(int x, int y) {
  return placeAt(x, y).to_eye.y;
}

std::vector<FloorPixel> floorIntegrals(const RoughnessOf& roughness_of) {
  constexpr int kRises = 96;
  constexpr int kTurns = 48;
  auto images = floorGbuffer(roughness_of);
  Image& normals = images.at("normal_view");
  Image mask(kFloorSize, {"B"});
  std::vector<FloorPixel> pixels;
  for (int y = kFirstFloorRow; y < kSide; y += 3) {
    for (int x = 2; x < kSide; x += 4) {
      pixels.push_back({x, y, 0.0, 0.0});
      mask.at(x, y) = 1.0F;
    }
  }
  for (int node = 0; node < kRises * kTurns; ++node) {
    std::vector<VisibleFacet> facets;
    const int rise = node / kTurns;
    const int turn = node % kTurns;
    for (const FloorPixel& pixel : pixels) {
      const Place place = placeAt(pixel.x, pixel.y);
      facets.push_back(visibleFacet({.cosine = place.to_eye.y, .roughness = roughness_of(pixel.x)}, 1.0,
                                    (rise + 0.5) / kRises, (turn + 0.5) / kTurns));
      const glm::vec3 normal(place.inView(facets.back().direction));
      std::copy_n(&normal.x, 3, &normals.at(pixel.x, pixel.y));
    }
    const auto traced = traceOracle({.camera = &floorCamera(),
                                     .dist_view = &images.at("dist_view"),
                                     .normal_view = &normals,
                                     .mask = &mask,
                                     .parameters = {}},
                                    1);
    SSRKIT_CHECK(traced.has_value());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Place place = placeAt(pixels[i].x, pixels[i].y);
      const glm::dvec3 reflected = glm::reflect(-place.to_eye, place.inView(facets[i].direction));
      const double sample =
          facets[i].weight * radianceOf(traced->record.at(pixels[i].x, pixels[i].y), reflected);
      pixels[i].mean += facets[i].density * sample / (kRises * kTurns);
      pixels[i].variance += facets[i].density * sample * sample / (kRises * kTurns);
    }
  }
  for (FloorPixel& pixel : pixels) {
    pixel.variance -= pixel.mean * pixel.mean;
  }
  return pixels;
}

}  // namespace ssrkit
