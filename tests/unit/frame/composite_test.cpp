// The composites against their formulas, in a white furnace and on random images; Fresnel against Schlick's
// equation in double precision and against the exact equations.
#include <fmt/format.h>

#include <complex>
#include <numbers>
#include <random>

#include "composite_image.h"
#include "white_furnace.h"

namespace ssrkit {
namespace {

double radians(int degrees) {
  return degrees * std::numbers::pi / 180.0;
}

double schlick(double f0, double cosine) {
  return f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5);
}

// Unpolarised reflectance of a plane surface with the refractive index n - ik, from vacuum.
double exactReflectance(std::complex<double> index, double cosine) {
  const double sine_squared = 1.0 - cosine * cosine;
  const std::complex<double> inner =
      std::sqrt(index * index - sine_squared);  // index times the refracted cosine
  const std::complex<double> s = (cosine - inner) / (cosine + inner);
  const std::complex<double> p = (index * index * cosine - inner) / (index * index * cosine + inner);
  return (std::norm(s) + std::norm(p)) / 2.0;
}

class CompositeTest : public PassTest {
 protected:
  // The mirror composite: the eye looks along -z, column x has its normal x degrees away. The mirrored
  // direction leans towards +x, where up is, so that the sky is never the ground.
  Image mirror(const std::string& shader, double lit, double sky, double f0, double mask,
               const std::function<double(int y)>& alpha) {
    begin();
    values_.set("texel_uv", 1.0 / glm::dvec2(kCompositeSize.width, kCompositeSize.height));
    values_.set("px_offset", glm::dvec2(0.0));
    values_.set("view_per_px", glm::dvec2(0.0));
    values_.set("up_view", glm::dvec3(1.0, 0.0, 0.0));
    values_.set("sky_horizon", glm::dvec3(sky));
    values_.set("sky_zenith", glm::dvec3(sky));
    give("lit", uniformImage(lit, lit, lit, 1.0));
    give("reflection", imageOf(kCompositeSize, [&](int, int y) {
           const double found = alpha(y) > 0.0 ? kFurnace : 0.0;
           return std::array{found, found, found, alpha(y)};
         }));
    give("albedo", uniformImage(f0, f0, f0, 1.0));
    give("material", uniformImage(1.0, 0.0, mask, 1.0));
    give("normal_view", imageOf(kCompositeSize, [](int x, int) {
           return std::array{std::sin(radians(x)), 0.0, std::cos(radians(x)), 1.0};
         }));
    give("dist_view", uniformImage(5.0, 0.0, 0.0, 0.0));
    return draw(shader, kCompositeSize);
  }
};

TEST_P(CompositeTest, FresnelIsSchlicksAt0To90Degrees) {
  for (const double f0 : {0.02, 0.04, 0.17, 0.5, 0.91, 1.0}) {
    const auto check = [&](const std::string& shader) {
      const Image composite = mirror(shader, 0.0, 0.0, f0, 1.0, [](int) { return 1.0; });
      return followsFormula(
          composite, [&](int x, int) { return kFurnace * schlick(f0, std::cos(radians(x))); }, 1e-6);
    };
    holdsAndKills(check, "composite.frag", {"fresnel_sine_squared"});
  }
}

// What docs/techniques.md says of Schlick's approximation: the largest deviation, and where.
TEST_P(CompositeTest, SchlickIsWithinItsStatedDeviationOfTheExactEquations) {
  struct Material {
    const char* name;
    std::complex<double> index;
    double largest;  // of |Schlick - exact|, measured
  };
  for (const Material& material :
       {Material{"glass", {1.5, 0.0}, 0.0357}, Material{"water", {1.33, 0.0}, 0.0599},
        Material{"diamond", {2.42, 0.0}, 0.0753}, Material{"like gold in red light", {0.19, -3.39}, 0.0185},
        Material{"like aluminium in green light", {0.96, -6.69}, 0.0915},
        Material{"like iron in green light", {2.93, -3.08}, 0.1786}}) {
    const double f0 = exactReflectance(material.index, 1.0);
    const Image composite = mirror("composite.frag", 0.0, 0.0, f0, 1.0, [](int) { return 1.0; });
    double largest = 0.0;
    for (int degrees = 0; degrees <= 90; ++degrees) {
      const double exact = exactReflectance(material.index, std::cos(radians(degrees)));
      largest = std::max(largest, std::abs(static_cast<double>(composite.at(degrees, 0)) / kFurnace - exact));
    }
    EXPECT_NEAR(largest, material.largest, 5e-4) << material.name;
  }
}

TEST_P(CompositeTest, MirrorGainsFresnelInAFurnace) {
  const auto check = [&](const std::string& shader) {
    const Image composite = mirror(shader, kFurnace, kFurnace, 0.04, 0.5, shareOfRow);
    return followsFormula(
        composite, [](int x, int) { return kFurnace * (1.0 + 0.5 * schlick(0.04, std::cos(radians(x)))); },
        1e-6);
  };
  holdsAndKills(check, "composite.frag", {"probe_left_in"});
}

TEST_P(CompositeTest, MirrorKeepsAFurnaceOnAPerfectMetal) {
  // Its own share is nothing, and all that arrives leaves: L for hits, misses, and everything between.
  EXPECT_EQ(followsFormula(
                mirror("composite.frag", 0.0, kFurnace, 1.0, 1.0, shareOfRow),
                [](int, int) { return kFurnace; }, 1e-7),
            "");
}

TEST_P(CompositeTest, BackgroundAndMaskedTexelsStayAsLit) {
  EXPECT_EQ(
      followsFormula(
          mirror("composite.frag", 0.3, kFurnace, 1.0, 0.0, shareOfRow), [](int, int) { return 0.3; }, 1e-7),
      "");
}

TEST_P(CompositeTest, MetallicGainsItsOwnShareInAFurnace) {
  const auto check = [&](const std::string& shader) {
    begin();
    give("lit", uniformImage(kFurnace, kFurnace, kFurnace, 1.0));
    give("reflection", uniformImage(kFurnace, kFurnace, kFurnace, 1.0));
    give("material", imageOf(kCompositeSize, [](int, int y) {
           return std::array{shareOfRow(y), 0.0, 1.0, 1.0};
         }));
    return followsFormula(
        draw(shader, kCompositeSize), [](int, int y) { return kFurnace * (1.0 + shareOfRow(y)); }, 1e-6);
  };
  holdsAndKills(check, "composite_metallic.frag", {"metallic_twice"});
}

TEST_P(CompositeTest, MaskedBlendsByMetalnessFresnelAndTheHitsDistanceFromTheCentre) {
  values_.set("size_px", glm::dvec2(kCompositeSize.width, kCompositeSize.height));
  values_.set("px_offset", glm::dvec2(0.0));
  values_.set("view_per_px", glm::dvec2(0.0));
  give("lit", uniformImage(0.2, 0.2, 0.2, 1.0));
  give("reflection", uniformImage(0.9, 0.9, 0.9, 0.8));
  give("hit_point", imageOf(kCompositeSize, [](int x, int) { return std::array{90.0 - x, 1.5, 1.0, 0.0}; }));
  give("albedo", uniformImage(0.5, 0.5, 0.5, 1.0));
  give("material", imageOf(kCompositeSize, [](int, int y) {
         return std::array{shareOfRow(y), 0.0, 1.0, 1.0};
       }));
  give("normal_view", imageOf(kCompositeSize, [](int x, int) {
         return std::array{std::sin(radians(x)), 0.0, std::cos(radians(x)), 1.0};
       }));
  const auto formula = [&](int x, int y) {
    const double u = 2.0 * (90.0 - x) / kCompositeSize.width - 1.0;
    const double v = 2.0 * 1.5 / kCompositeSize.height - 1.0;
    const double centre = (1.0 - std::pow(u, 4)) * (1.0 - std::pow(v, 4));
    const double f0 = 0.04 + (0.5 - 0.04) * shareOfRow(y);
    const double weight = shareOfRow(y) * centre * 0.8 * schlick(f0, std::cos(radians(x)));
    return 0.2 + weight * (0.9 - 0.2);
  };
  EXPECT_EQ(followsFormula(draw("composite_masked.frag", kCompositeSize), formula, 1e-6), "");
}

TEST_P(CompositeTest, MetalMaskEndsRaysExactlyWhereMetallicIs0) {
  give("material", imageOf(kCompositeSize, [](int x, int y) {
         return std::array{shareOfRow(y), 0.01 * x, x % 2 == 0 ? 1.0 : 0.0, 1.0};
       }));
  const Image masked = draw("metal_mask.frag", kCompositeSize);
  EXPECT_EQ(
      difference(masked,
                 imageOf(kCompositeSize,
                         [](int x, int y) {
                           return std::array{shareOfRow(y), 0.01 * x, x % 2 == 0 && y > 0 ? 1.0 : 0.0, 1.0};
                         }),
                 0.0),
      "");
}

INSTANTIATE_TEST_SUITE_P(Each, CompositeTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
