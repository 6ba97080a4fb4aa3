// Lighting and composite together in a white furnace: surfaces that lose nothing show nothing but the
// furnace.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lit_surfaces.h"
#include "white_furnace.h"

namespace ssrkit {
namespace {

// Columns by angle to the viewer, 0 to 85 degrees; rows by roughness, 0 to 1.
std::vector<LitSurface> whiteSurfaces(double metallic, double albedo) {
  std::vector<LitSurface> surfaces;
  for (int y = 0; y < kLitSize.height; ++y) {
    for (int x = 0; x < kLitSize.width; ++x) {
      const double angle = x / 15.0 * 85.0 / 180.0 * std::numbers::pi;
      const glm::dvec3 to_eye = -glm::normalize(rayOf(x, y));
      const glm::dvec3 side = glm::normalize(glm::cross(to_eye, glm::dvec3(0, 1, 0)));
      surfaces.push_back({.albedo = glm::dvec3(albedo),
                          .metallic = metallic,
                          .roughness = y / 7.0,
                          .normal = std::cos(angle) * to_eye + std::sin(angle) * side});
    }
  }
  return surfaces;
}

class FurnaceTest : public LitTest {
 protected:
  void SetUp() override {
    LitTest::SetUp();
    auto maps = environmentMaps(
        {.file = {}, .horizon = glm::vec3(static_cast<float>(kFurnace)), .zenith = {}, .is_constant = true});
    ASSERT_TRUE(maps.has_value());
    maps_ = std::move(*maps);
  }

  // Lights the surfaces, gives each ray the furnace's radiance by this confidence, and composites.
  struct Pictures {
    Image lit;
    Image composite;
  };
  Pictures composed(const std::string& composite, const std::vector<LitSurface>& surfaces, double confidence,
                    double arriving = kFurnace) {
    begin();
    giveSurfaces(surfaces, {});
    give(maps_);
    const std::vector<Image> lit = drawAll("light_ggx.frag", kLitSize, {Format::kRgba32f, Format::kRgba32f});
    give("lit", lit[0]);
    give("lit_base", lit[1]);
    give("reflection", imageOf(kLitSize, [&](int, int) {
           return std::array{arriving, arriving, arriving, confidence};
         }));
    return {lit[0], draw(composite, kLitSize)};
  }

  // "" when every texel is the furnace to within the tolerance.
  static std::string isFurnace(const Image& image, double tolerance) {
    return followsFormula(
        image, [](int, int) { return kFurnace; }, tolerance * kFurnace);
  }

  EnvironmentMaps maps_;
};

TEST_P(FurnaceTest, ReplaceKeepsItOnWhiteSurfacesAtEveryConfidence) {
  const auto check = [&](const std::string& composite) -> std::string {
    for (const double metallic : {0.0, 1.0}) {
      for (const double confidence : {0.0, 0.25, 1.0}) {
        const Pictures pictures = composed(composite, whiteSurfaces(metallic, 1.0), confidence);
        const std::string wrong = isFurnace(pictures.composite, 1e-4);
        if (!wrong.empty()) {
          return fmt::format("metallic {}, confidence {}: {}", metallic, confidence, wrong);
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "composite_replace.frag",
                {"replace_adds_to_the_environment", "replace_metallic_twice", "replace_single_scattering"});
}

// What single scattering alone would lose, by the split sum's table: the figure of docs/techniques.md.
TEST_P(FurnaceTest, SingleScatteringWouldLoseUpToTwoThirds) {
  const std::size_t last = maps_.split_sum.size() - 2;  // roughness 1, seen along the normal
  EXPECT_NEAR(1.0F - maps_.split_sum[last] - maps_.split_sum[last + 1], std::numbers::ln2_v<float>, 1e-4F);
}

TEST_P(FurnaceTest, ABlackFloorReflectsNothing) {
  const Pictures pictures = composed("composite_replace.frag", whiteSurfaces(1.0, 0.0), 1.0, 5.0);
  EXPECT_EQ(followsFormula(
                pictures.composite, [](int, int) { return 0.0; }, 0.0),
            "");
}

TEST_P(FurnaceTest, ReplacePutsAFullReflectionInTheEnvironmentsPlace) {
  const std::vector<LitSurface> surfaces = whiteSurfaces(1.0, 1.0);
  const Pictures pictures = composed("composite_replace.frag", surfaces, 1.0, 3.0);
  EXPECT_EQ(followsFormula(
                pictures.composite, [](int, int) { return 3.0; }, 1e-3),
            "");
  const Pictures half = composed("composite_replace.frag", surfaces, 0.5, 3.0);
  EXPECT_EQ(followsFormula(
                half.composite, [](int, int) { return 0.5 * (3.0 + kFurnace); }, 1e-3),
            "");
}

TEST_P(FurnaceTest, ReplaceLeavesMaskedAndMissedTexelsAsTheyWereBitByBit) {
  std::vector<LitSurface> surfaces = manySurfaces();
  const Pictures missed = composed("composite_replace.frag", surfaces, 0.0, 3.0);
  EXPECT_EQ(difference(missed.composite, missed.lit, 0.0), "");
  for (LitSurface& surface : surfaces) {
    surface.is_traced = false;
  }
  const Pictures masked = composed("composite_replace.frag", surfaces, 1.0, 3.0);
  EXPECT_EQ(difference(masked.composite, masked.lit, 0.0), "");
}

INSTANTIATE_TEST_SUITE_P(Each, FurnaceTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
