// A second oracle that shares nothing with the first: it moves along the ray in metres, projects with the
// matrix and finds every texel border by bisection. Slow, and right on random images.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "analytic_scene.h"

namespace ssrkit::testing {

namespace {

constexpr std::array<int, 2> kOutside = {-1, -1};

struct Crossing {
  std::array<int, 2> texel;
  double t_in_m;
  double t_out_m;
};

class SlowOracle {
 public:
  SlowOracle(const AnalyticScene& scene, const TraceParameters& parameters)
      : scene_(scene), parameters_(parameters) {}

  RayHit trace(int x, int y) {
    RayHit hit;
    if (std::isinf(scene_.dist_view.at(x, y))) {
      hit.ray_class = RayClass::kBackground;
      return hit;
    }
    if (scene_.mask.at(x, y) == 0.0F) {
      return hit;
    }
    if (!aim(x, y)) {
      hit.ray_class = RayClass::kIntoSurface;
      return hit;
    }
    if (texelAt(0.0) == kOutside) {
      hit.ray_class = RayClass::kOffscreen;
      return hit;
    }
    const double t_end = std::min(parameters_.max_distance_m, 1e9);
    crossings_.clear();
    crossings_.push_back({texelAt(0.0), 0.0, 0.0});
    split(0.0, texelAt(0.0), t_end, texelAt(t_end));
    crossings_.back().t_out_m = t_end;
    std::array<int, 2> before = crossings_.front().texel;
    for (const Crossing& crossing : crossings_) {
      if (crossing.texel == kOutside) {
        hit.ray_class = RayClass::kOffscreen;
        return hit;
      }
      if (crossing.texel == std::array{x, y}) {
        continue;
      }
      if (static_cast<int>(hit.lookups) == parameters_.lookup_budget) {
        hit.ray_class = RayClass::kBudget;
        return hit;
      }
      // A jump over a corner passes through a texel beside it.
      const int edges = std::abs(crossing.texel[0] - before[0]) + std::abs(crossing.texel[1] - before[1]);
      hit.lookups += static_cast<std::uint32_t>(std::max(edges, 1));
      before = crossing.texel;
      if (const double t_m = hitTime(crossing); t_m >= 0.0) {
        hit.ray_class = RayClass::kHit;
        hit.texel_x = crossing.texel[0];
        hit.texel_y = crossing.texel[1];
        hit.t_m = static_cast<float>(t_m);
        return hit;
      }
    }
    hit.ray_class = RayClass::kRange;
    return hit;
  }

 private:
  bool aim(int x, int y) {
    const glm::dmat4 view_from_clip = glm::inverse(scene_.camera.clip_from_view);
    const glm::dvec4 ndc(2.0 * (x + 0.5) / scene_.camera.size.width - 1.0,
                         1.0 - 2.0 * (y + 0.5) / scene_.camera.size.height, 0.5, 1.0);
    const glm::dvec4 unprojected = view_from_clip * ndc;
    const glm::dvec3 way = glm::dvec3(unprojected) / unprojected.w;
    const double dist = scene_.dist_view.at(x, y);
    const glm::dvec3 p_view = way * (dist / -way.z);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(
        scene_.normal_view.at(x, y, 0), scene_.normal_view.at(x, y, 1), scene_.normal_view.at(x, y, 2)));
    dir_ = glm::reflect(glm::normalize(p_view), normal);
    origin_ = p_view + parameters_.origin_bias * dist * normal;
    return glm::dot(dir_, normal) >= 0.0 && scene_.normal_view.at(x, y, 3) >= 0.0F;
  }

  [[nodiscard]] double distAt(double t_m) const { return -(origin_.z + t_m * dir_.z); }

  [[nodiscard]] glm::dvec2 pxAt(double t_m) const {
    const glm::dvec4 clip = scene_.camera.clip_from_view * glm::dvec4(origin_ + t_m * dir_, 1.0);
    return {0.5 * scene_.camera.size.width * (1.0 + clip.x / clip.w),
            0.5 * scene_.camera.size.height * (1.0 - clip.y / clip.w)};
  }

  [[nodiscard]] std::array<int, 2> texelAt(double t_m) const {
    if (distAt(t_m) < scene_.camera.near_m) {
      return kOutside;
    }
    const glm::dvec2 px = pxAt(t_m);
    const Size size = scene_.camera.size;
    if (!(px.x >= 0.0 && px.y >= 0.0 && px.x < size.width && px.y < size.height)) {
      return kOutside;
    }
    return {static_cast<int>(px.x), static_cast<int>(px.y)};
  }

  // Texels are convex: a stretch that begins and ends in one texel lies in it.
  void split(double t_a, std::array<int, 2> texel_a, double t_b, std::array<int, 2> texel_b) {
    if (texel_a == texel_b) {
      return;
    }
    const double t_middle = 0.5 * (t_a + t_b);
    if (!(t_a < t_middle && t_middle < t_b) || t_b - t_a < 1e-12 * t_b) {
      crossings_.back().t_out_m = t_a;
      crossings_.push_back({texel_b, t_b, t_b});
      return;
    }
    const std::array<int, 2> middle = texelAt(t_middle);
    split(t_a, texel_a, t_middle, middle);
    split(t_middle, middle, t_b, texel_b);
  }

  // Metres to where the ray enters the column's overlap, -1 when it does not.
  [[nodiscard]] double hitTime(const Crossing& crossing) const {
    const double front = scene_.dist_view.at(crossing.texel[0], crossing.texel[1]);
    if (std::isinf(front)) {
      return -1.0;
    }
    const double back = front + parameters_.thickness_m + parameters_.thickness_rel * front;
    const double dist_in = distAt(crossing.t_in_m);
    const double dist_out = distAt(crossing.t_out_m);
    if (std::max(dist_in, dist_out) < front || std::min(dist_in, dist_out) >= back) {
      return -1.0;
    }
    if (dist_in >= front && dist_in < back) {
      return crossing.t_in_m;
    }
    const double wanted = dist_in < front ? front : back;
    return (wanted + origin_.z) / -dir_.z;
  }

  const AnalyticScene& scene_;
  TraceParameters parameters_;
  glm::dvec3 origin_{0.0};
  glm::dvec3 dir_{0.0};
  std::vector<Crossing> crossings_;
};

struct Tally {
  int rays = 0;
  int hits = 0;
  int ambiguous = 0;
};

class RandomImages {
 public:
  explicit RandomImages(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  AnalyticScene scene(Size size) {
    AnalyticScene scene = flatScene(size);
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        scene.dist_view.at(x, y) = static_cast<float>(uniform(1.0, 10.0));
        if (uniform(0.0, 1.0) < 0.1) {
          scene.dist_view.at(x, y) = std::numeric_limits<float>::infinity();
        }
        const glm::dvec3 normal =
            glm::normalize(glm::dvec3(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-0.1, 1.0)));
        for (int axis = 0; axis < 3; ++axis) {
          scene.normal_view.at(x, y, static_cast<std::size_t>(axis)) = static_cast<float>(normal[axis]);
        }
      }
    }
    return scene;
  }

  TraceParameters parameters() {
    TraceParameters parameters;
    if (uniform(0.0, 1.0) < 0.7) {
      parameters.thickness_m = uniform(0.0, 2.0);
      parameters.thickness_rel = uniform(0.0, 1.0) < 0.5 ? 0.0 : uniform(0.0, 0.3);
    }
    if (uniform(0.0, 1.0) < 0.4) {
      parameters.max_distance_m = uniform(0.1, 12.0);
    }
    if (uniform(0.0, 1.0) < 0.4) {
      parameters.origin_bias = uniform(0.0, 0.05);
    }
    if (uniform(0.0, 1.0) < 0.3) {
      parameters.lookup_budget = static_cast<int>(uniform(0.0, 20.0));
    }
    return parameters;
  }

 private:
  std::mt19937 random_;
};

void compare(const AnalyticScene& scene, const TraceParameters& parameters, Tally& tally) {
  const OracleResult result = trace(scene, parameters);
  SlowOracle slow(scene, parameters);
  for (int y = 0; y < scene.camera.size.height; ++y) {
    for (int x = 0; x < scene.camera.size.width; ++x) {
      const RayHit& fast = result.record.at(x, y);
      const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.camera.size.width) +
                         static_cast<std::size_t>(x);
      ++tally.rays;
      if (result.ambiguity[index] != Ambiguity::kNone) {
        ++tally.ambiguous;
        continue;
      }
      const RayHit truth = slow.trace(x, y);
      ASSERT_EQ(fast.ray_class, truth.ray_class) << x << "," << y;
      ASSERT_EQ(fast.texel_x, truth.texel_x) << x << "," << y;
      ASSERT_EQ(fast.texel_y, truth.texel_y) << x << "," << y;
      // A ray that leaves the image by its corner, or ends on an edge, may count one cell more or less.
      const bool is_miss = truth.ray_class == RayClass::kOffscreen || truth.ray_class == RayClass::kRange;
      ASSERT_NEAR(fast.lookups, truth.lookups, is_miss ? 1.0 : 0.0) << x << "," << y;
      if (truth.ray_class == RayClass::kHit) {
        ++tally.hits;
        ASSERT_NEAR(fast.t_m, truth.t_m, 1e-5 * (1.0 + truth.t_m));
      }
    }
  }
}

}  // namespace

TEST(OracleSecondOpinion, BisectionInMetresFindsTheSameHitsOnRandomImages) {
  RandomImages images(20240607);
  Tally tally;
  for (int image = 0; image < 150; ++image) {
    const Size size{1 + static_cast<int>(images.uniform(0.0, 40.0)),
                    1 + static_cast<int>(images.uniform(0.0, 30.0))};
    compare(images.scene(size), images.parameters(), tally);
  }
  EXPECT_GT(tally.rays, 30000);
  EXPECT_GT(tally.hits, 10000);
  EXPECT_LE(tally.ambiguous, 0.015 * tally.rays);
  RecordProperty("ambiguous", tally.ambiguous);
}

TEST(OracleSecondOpinion, BisectionInMetresFindsTheSameHitsInTheScenesOfTheClosedForms) {
  Tally tally;
  TraceParameters thin;
  thin.thickness_m = 0.3;
  for (const AnalyticScene& scene :
       {sceneM1({40, 36}), sceneM2({51, 45}), sceneM3({33, 60}), sceneM4({60, 41})}) {
    compare(scene, {}, tally);
    compare(scene, thin, tally);
  }
  EXPECT_GT(tally.hits, 2000);
}

}  // namespace ssrkit::testing
