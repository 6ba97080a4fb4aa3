// How rough reflections choose their rays, and what a ray weighs: statistics over many pixels against
// quadratures in double precision. The seeds are fixed, so a test that passes once passes always; the levels
// are those of statistics.h.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "../statistics.h"
#include "ggx_reference.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr Size kSamplingSize{256, 256};
constexpr int kWhite = 0;  // point_set of random.glsl
constexpr int kRounds = 4;
constexpr std::size_t kRiseCount = 16;
constexpr std::size_t kTurnCount = 16;

const std::vector<GgxView>& views() {
  static const std::vector<GgxView> list = [] {
    std::vector<GgxView> all;
    for (const double roughness : {0.125, 0.3125, 0.625, 1.0}) {
      for (const double degrees : {0.0, 35.0, 65.0, 80.0, 88.0}) {
        all.push_back({.cosine = std::cos(glm::radians(degrees)), .roughness = roughness});
      }
    }
    return all;
  }();
  return list;
}

std::string nameOf(const GgxView& view) {
  return fmt::format("roughness {}, {:.0f} degrees", view.roughness, glm::degrees(std::acos(view.cosine)));
}

// The eye is at +z; the surface is turned away from it by the view's angle, about an axis that favours none.
glm::dvec3 normalOf(const GgxView& view) {
  const double sine = std::sqrt(1.0 - view.cosine * view.cosine);
  return {0.6 * sine, 0.8 * sine, view.cosine};
}

Image constant(const std::array<double, 4>& texel, std::size_t channel_count = 4) {
  return imageOf(
      kSamplingSize, [&](int, int) { return texel; }, channel_count);
}

class RoughSamplingTest : public PassTest {
 protected:
  void giveSurface(const GgxView& view, double reflectance) {
    const glm::dvec3 normal = normalOf(view);
    give("normal_view", constant({normal.x, normal.y, normal.z, view.cosine}));
    give("material", constant({1.0, view.roughness, 1.0, 1.0}));
    give("albedo", constant({reflectance, reflectance, reflectance, 1.0}));
    give("dist_view", constant({1.0, 0.0, 0.0, 0.0}));
    give("blue_noise", constant({0.5, 0.5, 0.0, 0.0}));  // white points read none of it
    // Every pixel looks along -z.
    values_.set("px_offset", glm::dvec2(0.0));
    values_.set("view_per_px", glm::dvec2(0.0));
  }

  Image sampled(const std::string& shader, int index) {
    values_.set("sample_index", index);
    values_.set("sample_count", kRounds);
    values_.set("frame_index", 0);
    values_.set("point_set", kWhite);
    return draw(shader, kSamplingSize);
  }

  // Calls with every microfacet of every round, in the frame of the normal with the eye over the x axis.
  template <class Visit>
  void visitMicrofacets(const std::string& shader, const GgxView& view, const Visit& visit) {
    begin();
    giveSurface(view, 1.0);
    const glm::dvec3 z = normalOf(view);
    const glm::dvec3 x =
        view.cosine < 1.0 ? glm::normalize(glm::dvec3(0, 0, 1) - view.cosine * z) : glm::dvec3(1, 0, 0);
    const glm::dvec3 y = glm::cross(z, x);
    for (int round = 0; round < kRounds; ++round) {
      const Image microfacets = sampled(shader, round);
      for (std::size_t texel = 0; texel < microfacets.texelCount(); ++texel) {
        const float* m = &microfacets.data[4 * texel];
        const glm::dvec3 microfacet(m[0], m[1], m[2]);
        visit({glm::dot(microfacet, x), glm::dot(microfacet, y), glm::dot(microfacet, z)});
      }
    }
  }

  double meanReflected(const GgxView& view, double reflectance, const std::string& sampling,
                       const std::string& accumulating);
};

std::string visibleNormalsDiffer(const GgxView& view, const std::vector<double>& counts) {
  const double p = pearsonP(
      counts, visibleCellProbabilities(view, static_cast<int>(kRiseCount), static_cast<int>(kTurnCount)));
  return p < kFamilyLevel / static_cast<double>(views().size())
             ? fmt::format("{}: p = {:.3g} that the visible distribution gives such counts", nameOf(view), p)
             : "";
}

// The mean over all pixels of one sample of radiance 1 from everywhere.
double RoughSamplingTest::meanReflected(const GgxView& view, double reflectance, const std::string& sampling,
                                        const std::string& accumulating) {
  begin();
  giveSurface(view, reflectance);
  give("microfacet_normal", sampled(sampling, 0));
  give("lit", constant({1.0, 1.0, 1.0, 1.0}));
  give("reflected_sum", constant({0.0, 0.0, 0.0, 0.0}));
  // Half of the rays hit, half meet the sky.
  giveIntegers("hit_texel",
               imageOf(
                   kSamplingSize,
                   [](int x, int) {
                     return std::array{x % 2 - 1.0, 0.0, 0.0, 0.0};
                   },
                   2),
               Format::kRg16i);
  values_.set("up_view", normalOf(view));  // below it the sky is darker
  values_.set("sky_horizon", glm::dvec3(1.0));
  values_.set("sky_zenith", glm::dvec3(1.0));
  const Image reflected = draw(accumulating, kSamplingSize);
  double mean = 0.0;
  for (std::size_t texel = 0; texel < reflected.texelCount(); ++texel) {
    mean += reflected.data[4 * texel] / static_cast<double>(reflected.texelCount());
  }
  return mean;
}

TEST(StatisticsTest, TheChiSquaredTailIsTheTables) {
  // Upper 5 %, 1 % and 0.1 % points of printed tables.
  EXPECT_NEAR(chiSquaredP(43.773, 30), 0.05, 2e-4);
  EXPECT_NEAR(chiSquaredP(135.807, 100), 0.01, 1e-4);
  EXPECT_NEAR(chiSquaredP(149.449, 100), 0.001, 2e-5);
}

TEST(GgxReferenceTest, TheVisibleDistributionIsADistribution) {
  for (const GgxView& view : views()) {
    const auto cells =
        visibleCellProbabilities(view, static_cast<int>(kRiseCount), static_cast<int>(kTurnCount));
    EXPECT_NEAR(std::reduce(cells.begin(), cells.end()), 1.0, 1e-4) << nameOf(view);
  }
}

TEST(GgxReferenceTest, ASmoothSurfaceReflectsByFresnelAlone) {
  const double fresnel = 0.04 + 0.96 * std::pow(1.0 - 0.4, 5.0);
  EXPECT_NEAR(directionalAlbedo({.cosine = 0.4, .roughness = 0.02}, 0.04), fresnel, 1e-4);
}

TEST_P(RoughSamplingTest, MicrofacetsFollowTheVisibleDistribution) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const GgxView& view : views()) {
      std::vector<double> counts(kRiseCount * kTurnCount);
      std::size_t below = 0;
      visitMicrofacets(shader, view, [&](const glm::dvec3& microfacet) {
        const FacetPlace place = placeOf(microfacet, view.roughness * view.roughness);
        const auto rise = std::min(static_cast<std::size_t>(place.rise * kRiseCount), kRiseCount - 1);
        const auto turn = std::min(static_cast<std::size_t>(place.turn * kTurnCount), kTurnCount - 1);
        below += microfacet.z > 0.0 ? 0U : 1U;
        counts[rise * kTurnCount + turn] += 1.0;
      });
      const std::string complaint = visibleNormalsDiffer(view, counts);
      if (below > 0 || !complaint.empty()) {
        return below > 0 ? fmt::format("{}: {} microfacets below the surface", nameOf(view), below)
                         : complaint;
      }
    }
    return "";
  };
  holdsAndKills(check, "sample_microfacet.frag", {"all_normals_sampled", "same_point_everywhere"});
}

TEST_P(RoughSamplingTest, JitteredNormalsLeanNowhere) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const GgxView& view : views()) {
      glm::dvec2 sum(0.0);
      glm::dvec2 squares(0.0);
      visitMicrofacets(shader, view, [&](const glm::dvec3& normal) {
        sum += glm::dvec2(normal);
        squares += glm::dvec2(normal) * glm::dvec2(normal);
      });
      const glm::dvec2 z = sum / glm::sqrt(squares);
      const double p = std::min(twoSidedP(z.x), twoSidedP(z.y));
      if (!(p >= kFamilyLevel / (2.0 * static_cast<double>(views().size())))) {
        return fmt::format("{}: the mean leans {:.1f} and {:.1f} standard errors", nameOf(view), z.x, z.y);
      }
    }
    return "";
  };
  holdsAndKills(check, "jitter_normal.frag", {"octant_jitter"});
}

TEST_P(RoughSamplingTest, AWhiteFurnaceGivesTheDirectionalAlbedo) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const GgxView& view : views()) {
      for (const double reflectance : {1.0, 0.25}) {
        const double mean = meanReflected(view, reflectance, "sample_microfacet.frag", shader);
        const double albedo = directionalAlbedo(view, reflectance);
        if (!(std::abs(mean / albedo - 1.0) <= 0.01)) {
          return fmt::format("{}, reflectance {}: mean {:.5f} where the albedo is {:.5f}", nameOf(view),
                             reflectance, mean, albedo);
        }
      }
    }
    return "";
  };
  holdsAndKills(check, "accumulate_microfacet.frag", {"masking_left_out", "all_normals_weighed"});
}

// Without Fresnel the weights of all rays are, in the mean, what a white surface reflects.
TEST_P(RoughSamplingTest, WeightsWithoutFresnelGiveTheWhiteAlbedo) {
  const auto check = [&](const std::string& shader) -> std::string {
    for (const GgxView& view : views()) {
      begin();
      giveSurface(view, 1.0);
      give("microfacet_normal", sampled("sample_microfacet.frag", 0));
      give("lit", constant({0.5, 0.5, 0.5, 1.0}));
      give("reflected_sum", constant({0.0, 0.0, 0.0, 0.0}));
      give("weight_sum", constant({0.0, 0.0, 0.0, 0.0}, 1));
      giveIntegers("hit_texel", constant({0.0, 0.0, 0.0, 0.0}, 2), Format::kRg16i);
      const std::vector<Image> sums = drawAll(shader, kSamplingSize, {Format::kRgba32f, Format::kR32f});
      double colour = 0.0;
      double weight = 0.0;
      for (std::size_t texel = 0; texel < sums[1].texelCount(); ++texel) {
        colour += sums[0].data[4 * texel] / static_cast<double>(sums[1].texelCount());
        weight += sums[1].data[texel] / static_cast<double>(sums[1].texelCount());
      }
      const double albedo = directionalAlbedo(view, 1.0);
      if (!(std::abs(weight / albedo - 1.0) <= 0.01 && std::abs(colour / (0.5 * albedo) - 1.0) <= 0.01)) {
        return fmt::format("{}: weights of {:.5f} and light of {:.5f} in the mean where the albedo is {:.5f}",
                           nameOf(view), weight, colour, albedo);
      }
    }
    return "";
  };
  EXPECT_EQ(check("accumulate_arriving.frag"), "");
}

// Of 16 samples 4 hit something of (0.5, 1, 2), or weights of 8 in all hit with 4 of them.
TEST_P(RoughSamplingTest, AnAverageOfHitsIsTheirColourAndTheirShare) {
  const Size size{2, 2};
  const auto all = [&](std::array<double, 4> texel) {
    return imageOf(size, [=](int, int) { return texel; });
  };
  give("reflected_sum", all({2.0, 4.0, 8.0, 4.0}));
  values_.set("sample_count", 16);
  EXPECT_EQ(difference(draw("average_hits.frag", size), all({0.5, 1.0, 2.0, 0.25}), 0.0), "");
  give("weight_sum", all({8.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(difference(draw("average_arriving.frag", size), all({0.5, 1.0, 2.0, 0.5}), 0.0), "");
  give("reflection", all({0.25, 0.5, 1.0, 0.5}));
  EXPECT_EQ(difference(draw("unpremultiply.frag", size), all({0.5, 1.0, 2.0, 0.5}), 0.0), "");
}

INSTANTIATE_TEST_SUITE_P(Each, RoughSamplingTest, testing::Values("gl-osmesa", "vk-lavapipe"),
                         deviceTestName);

}  // namespace
}  // namespace ssrkit
