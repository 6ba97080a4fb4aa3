// Each factor of the confidence against its closed form in double precision, alone, and all of them as a
// product.
#include <fmt/format.h>

#include <numbers>
#include <random>

#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr double kNone = 1e30;
constexpr Size kConfidenceSize{256, 4};

double smoothRise(double x) {
  const double in = std::clamp(x, 0.0, 1.0);
  return in * in * (3.0 - 2.0 * in);
}

// One ray a texel, as the test tells it.
struct Ray {
  std::array<double, 3> point{100.5, 2.5, 1.0};  // hit position in pixels, t_m
  std::array<int, 2> texel{100, 2};
  int lookups = 0;
  double towards_camera = -1.0;  // dir_view.z
};

struct Factors {
  double edge_fade_fraction = 0.0;
  double fade_distance_m = kNone;
  int rejects_back_faces = 0;
  double facing_fade_start = 2.0;
  double facing_fade_end = 3.0;
  double fade_lookups = kNone;
  double max_distance_m = kNone;  // the trace's own
  int lookup_budget = 65536;
};

class ConfidenceTest : public PassTest {
 protected:
  // Confidence of the ray that `ray_at` gives for each column; all four rows are alike. normals_hit is read
  // at the hits' texels.
  std::vector<double> confidences(const std::string& shader, const Factors& factors,
                                  const std::function<Ray(int x)>& ray_at) {
    begin();
    values_.set("size_px", glm::dvec2(kConfidenceSize.width, kConfidenceSize.height));
    // The eye looks straight along -z through every pixel: dir_view.z is set by the normal alone.
    values_.set("texel_uv", 1.0 / glm::dvec2(kConfidenceSize.width, kConfidenceSize.height));
    values_.set("px_offset", glm::dvec2(0.0));
    values_.set("view_per_px", glm::dvec2(0.0));
    values_.set("max_distance_m", factors.max_distance_m);
    values_.set("lookup_budget", factors.lookup_budget);
    values_.set("edge_fade_fraction", factors.edge_fade_fraction);
    values_.set("fade_distance_m", factors.fade_distance_m);
    values_.set("rejects_back_faces", factors.rejects_back_faces);
    values_.set("facing_fade_start", factors.facing_fade_start);
    values_.set("facing_fade_end", factors.facing_fade_end);
    values_.set("fade_lookups", factors.fade_lookups);
    give("reflection", imageOf(kConfidenceSize, [](int, int) { return std::array{0.25, 0.5, 0.75, 1.0}; }));
    give("hit_point", imageOf(kConfidenceSize, [&](int x, int) {
           const Ray ray = ray_at(x);
           return std::array{ray.point[0], ray.point[1], ray.point[2], 0.0};
         }));
    giveIntegers("hit_texel",
                 imageOf(
                     kConfidenceSize,
                     [&](int x, int) {
                       const Ray ray = ray_at(x);
                       return std::array<double, 4>{static_cast<double>(ray.texel[0]),
                                                    static_cast<double>(ray.texel[1])};
                     },
                     2),
                 Format::kRg16i);
    giveIntegers("ray_work",
                 imageOf(kConfidenceSize,
                         [&](int x, int) {
                           return std::array<double, 4>{2.0, static_cast<double>(ray_at(x).lookups)};
                         }),
                 Format::kRgba16ui);
    // Reflecting (0, 0, -1) at the normal (sin a, 0, cos a) gives dir_view.z = cos 2a.
    give("normal_view", imageOf(kConfidenceSize, [&](int x, int) {
           const double half = std::acos(ray_at(x).towards_camera) / 2.0;
           return std::array{std::sin(half), 0.0, std::cos(half), 1.0};
         }));
    const Image weighed = draw(shader, kConfidenceSize);
    std::vector<double> alphas;
    for (int x = 0; x < kConfidenceSize.width; ++x) {
      EXPECT_EQ(weighed.at(x, 1, 1), ray_at(x).texel[0] < 0 ? 0.0F : 0.5F) << "the radiance is left alone";
      alphas.push_back(static_cast<double>(weighed.at(x, 2, 3)));
    }
    return alphas;
  }

  // "" when the confidences are within `tolerance` of the formula.
  std::string follows(const std::string& shader, const Factors& factors,
                      const std::function<Ray(int x)>& ray_at, const std::function<double(int x)>& formula,
                      double tolerance) {
    const std::vector<double> got = confidences(shader, factors, ray_at);
    for (int x = 0; x < kConfidenceSize.width; ++x) {
      const double value = got[static_cast<std::size_t>(x)];
      if (!(std::abs(value - formula(x)) <= tolerance)) {
        return fmt::format("{} at step {} where {} is right", value, x, formula(x));
      }
    }
    return "";
  }
};

TEST_P(ConfidenceTest, NoFactorLeavesEveryHitAt1AndEveryMissAt0) {
  const auto every_third_misses = [](int x) {
    return x % 3 == 0 ? Ray{.point = {-1, -1, -1}, .texel = {-1, -1}} : Ray{.lookups = 10};
  };
  const auto hits = [](int x) { return x % 3 == 0 ? 0.0 : 1.0; };
  EXPECT_EQ(follows("confidence.frag", {}, every_third_misses, hits, 0.0), "");
}

TEST_P(ConfidenceTest, EdgesFadeByTheHitsPosition) {
  // Hits walk from the left border to the middle while the receivers walk over the whole image.
  const auto ray_at = [](int x) { return Ray{.point = {0.5 * x, 2.0, 1.0}}; };
  const auto check = [&](const std::string& shader) {
    return follows(
        shader, {.edge_fade_fraction = 0.125}, ray_at,
        [](int x) { return smoothRise(0.5 * x / (0.125 * 256)) * smoothRise(0.5 / 0.125); }, 1e-6);
  };
  holdsAndKills(check, "confidence.frag", {"edge_fade_by_receiver"});
  const std::vector<double> fade = confidences("confidence.frag", {.edge_fade_fraction = 0.125}, ray_at);
  EXPECT_EQ(fade[0], 0.0);
  EXPECT_EQ(fade[32], 0.5);
  EXPECT_EQ(fade[64], 1.0);
  for (std::size_t x = 1; x < fade.size(); ++x) {
    EXPECT_GE(fade[x], fade[x - 1]);
    // The steepest slope of the cubic is 1.5 over the width of the fade: 32 pixels.
    EXPECT_LE(fade[x] - fade[x - 1], 1.5 * 0.5 / 32.0 + 1e-6);
  }
}

TEST_P(ConfidenceTest, AllFourBordersFadeAlike) {
  const std::vector<std::array<double, 3>> points = {{16, 2, 1}, {240, 2, 1}, {128, 0.25, 1}, {128, 3.75, 1}};
  const std::vector<double> fade = confidences("confidence.frag", {.edge_fade_fraction = 0.125}, [&](int x) {
    return Ray{.point = points[static_cast<std::size_t>(x) % 4]};
  });
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(fade[i], 0.5) << "border " << i;
  }
}

TEST_P(ConfidenceTest, DistanceFadesByTheSquareOfItsShareOfTheReach) {
  const auto ray_at = [](int x) { return Ray{.point = {100.5, 2.5, 0.05 * x}}; };
  const auto check = [&](const std::string& shader) {
    return follows(
        shader, {.fade_distance_m = 10.0}, ray_at,
        [](int x) { return std::max(0.0, 1.0 - std::pow(0.05 * x / 10.0, 2)); }, 1e-6);
  };
  holdsAndKills(check, "confidence.frag", {"distance_fade_linear"});
}

TEST_P(ConfidenceTest, RaysTowardsTheCameraFade) {
  const auto cosine = [](int x) { return -1.0 + 2.0 * x / 255.0; };
  const auto ray_at = [&](int x) { return Ray{.towards_camera = cosine(x)}; };
  EXPECT_EQ(follows(
                "confidence.frag", {.facing_fade_start = 0.0, .facing_fade_end = 0.5}, ray_at,
                [&](int x) { return 1.0 - smoothRise(cosine(x) / 0.5); }, 2e-6),
            "");
}

TEST_P(ConfidenceTest, TheBudgetFadesByTheEighthPowerOfItsShare) {
  const auto ray_at = [](int x) { return Ray{.lookups = x}; };
  EXPECT_EQ(follows(
                "confidence.frag", {.fade_lookups = 200.0}, ray_at,
                [](int x) { return 1.0 - std::pow(std::min(x / 200.0, 1.0), 8); }, 1e-6),
            "");
}

TEST_P(ConfidenceTest, TheTracesOwnReachAndBudgetBoundTheConstants) {
  EXPECT_EQ(follows(
                "confidence.frag", {.fade_distance_m = 10.0, .max_distance_m = 5.0},
                [](int x) {
                  return Ray{.point = {100.5, 2.5, 0.05 * x}};
                },
                [](int x) { return std::max(0.0, 1.0 - std::pow(0.05 * x / 5.0, 2)); }, 1e-6),
            "");
  EXPECT_EQ(follows(
                "confidence.frag", {.fade_lookups = 200.0, .lookup_budget = 64},
                [](int x) { return Ray{.lookups = x}; },
                [](int x) { return 1.0 - std::pow(std::min(x / 64.0, 1.0), 8); }, 1e-6),
            "");
}

TEST_P(ConfidenceTest, AHitFromBehindItsSurfaceIsRejected) {
  // The receiver's normal is (sin a, 0, cos a), its ray (sin 2a, 0, cos 2a). Texel 0 looks at a hit at texel
  // 255, whose own normal is turned by a quarter: the cosine between ray and normal is positive there.
  const auto ray_at = [](int x) {
    Ray ray{.towards_camera = x < 128 ? -1.0 : std::cos(2.0 * std::numbers::pi / 3.0)};
    ray.texel = {x % 2 == 0 ? 200 : 20, 1};
    return ray;
  };
  const auto normal = [&](int x) {
    const double half = std::acos(ray_at(x).towards_camera) / 2.0;
    return std::array{std::sin(half), 0.0, std::cos(half)};
  };
  const auto formula = [&](int x) {
    const auto own = normal(x);
    const auto hit = normal(ray_at(x).texel[0]);
    // reflect((0, 0, -1), own)
    const double dir_x = 2.0 * own[2] * own[0];
    const double dir_z = -1.0 + 2.0 * own[2] * own[2];
    return dir_x * hit[0] + dir_z * hit[2] > 0.0 ? 0.0 : 1.0;
  };
  const auto check = [&](const std::string& shader) {
    return follows(shader, {.rejects_back_faces = 1}, ray_at, formula, 0.0);
  };
  holdsAndKills(check, "confidence.frag", {"back_faces_kept"});
}

TEST_P(ConfidenceTest, FactorsMultiply) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Ray> rays;
  rays.reserve(static_cast<std::size_t>(kConfidenceSize.width));
  for (int x = 0; x < kConfidenceSize.width; ++x) {
    rays.push_back({.point = {256.0 * unit(random), 4.0 * unit(random), 12.0 * unit(random)},
                    .texel = {100, 2},
                    .lookups = static_cast<int>(300.0 * unit(random)),
                    .towards_camera = 2.0 * unit(random) - 1.0});
  }
  const auto inwards = [](double at, double size) { return std::min(at, size - at) / (0.25 * size); };
  EXPECT_EQ(follows(
                "confidence.frag",
                {.edge_fade_fraction = 0.25,
                 .fade_distance_m = 10.0,
                 .facing_fade_start = 0.25,
                 .facing_fade_end = 0.75,
                 .fade_lookups = 256.0},
                [&](int x) { return rays[static_cast<std::size_t>(x)]; },
                [&](int x) {
                  const Ray& ray = rays[static_cast<std::size_t>(x)];
                  return smoothRise(inwards(ray.point[0], 256.0)) * smoothRise(inwards(ray.point[1], 4.0)) *
                         std::max(0.0, 1.0 - std::pow(ray.point[2] / 10.0, 2)) *
                         (1.0 - smoothRise((ray.towards_camera - 0.25) / 0.5)) *
                         (1.0 - std::pow(std::min(ray.lookups / 256.0, 1.0), 8));
                },
                4e-6),
            "");
}

INSTANTIATE_TEST_SUITE_P(Each, ConfidenceTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
