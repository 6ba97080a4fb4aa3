// The blur's radius against the cone's geometry.
#include <cmath>

#include "blur_image.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

// How much wider than an even disc the kernel (1 - x^2)^2 must be for the same variance along an axis, by
// quadrature.
double kernelPerCircle() {
  double kernel = 0.0;
  double kernel_square = 0.0;
  double disc = 0.0;
  double disc_square = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const double x = (i + 0.5) / 200000.0;
    const double share = std::pow(1.0 - x * x, 2);
    const double chord = std::sqrt(1.0 - x * x);
    kernel += share;
    kernel_square += share * x * x;
    disc += chord;
    disc_square += chord * x * x;
  }
  return std::sqrt((disc_square / disc) / (kernel_square / kernel));
}

class BlurGuideTest : public PassTest {
 protected:
  // blur_guide's radius over a floor of columns of roughness and rows of t_m, -1 for a miss.
  Image guide(const std::string& shader, double max_radius_px) {
    begin();
    values_.set("px_scale", glm::dvec2(kBlurPxScale, -kBlurPxScale));
    values_.set("px_offset", glm::dvec2(kBlurSize.width / 2.0, kBlurSize.height / 2.0));
    values_.set("view_per_px", 1.0 / glm::dvec2(kBlurPxScale, -kBlurPxScale));
    values_.set("max_radius_px", max_radius_px);
    give("material", imageOf(kBlurSize, [](int x, int y) {
           return std::array{1.0, roughness(x), y == 46 ? 0.0 : 1.0, 1.0};
         }));
    give("dist_view",
         imageOf(
             kBlurSize, [](int, int) { return std::array<double, 4>{kBlurDist}; }, 1),
         Format::kR32f);
    giveIntegers("hit_texel",
                 imageOf(
                     kBlurSize,
                     [](int, int y) {
                       return std::array<double, 4>{y == 45 ? -1.0 : 3.0, 0.0};
                     },
                     2),
                 Format::kRg16i);
    give("hit_point", imageOf(kBlurSize, [](int, int y) {
           return std::array{0.0, 0.0, y == 45 ? -1.0 : t_m(y), 0.0};
         }));
    return draw(shader, kBlurSize, Format::kRg32f);
  }
  static double roughness(int x) { return x / 62.0; }
  static double t_m(int y) { return 0.1 * y * y; }
};

TEST_P(BlurGuideTest, TheRadiusIsTheConesCircleSeenInTheMirrorAnd0AtContact) {
  const double kernel_per_circle = kernelPerCircle();
  const auto check = [&](const std::string& shader) {
    const Image radius = guide(shader, 1e6);
    return difference(radius,
                      imageOf(
                          kBlurSize,
                          [kernel_per_circle](int x, int y) {
                            const double tangent = std::tan(2.0 * std::atan(roughness(x) * roughness(x)));
                            const double eye = std::hypot((x + 0.5 - 30.5) / kBlurPxScale,
                                                          (y + 0.5 - 23.5) / kBlurPxScale, 1.0);
                            const double h = t_m(y);
                            const double a = 2.0 * h * tangent;
                            const double circle_m =
                                h > 0.0 ? a * (std::sqrt(a * a + 4.0 * h * h) - a) / (4.0 * h) : 0.0;
                            // Dist_view of the mirrored hit, on the eye's ray prolonged by t_m.
                            const double mirrored = kBlurDist * (eye * kBlurDist + h) / (eye * kBlurDist);
                            const double per_m = tangent * (std::sqrt(1.0 + tangent * tangent) - tangent);
                            const double miss = kBlurPxScale * per_m * eye;
                            const double px = y == 45 ? miss : kBlurPxScale * circle_m / mirrored;
                            return std::array<double, 4>{kBlurDist, y == 46 ? -1.0 : kernel_per_circle * px};
                          },
                          2),
                      2e-4);
  };
  holdsAndKills(check, "blur_guide.frag", {"blur_constant"});
}

TEST_P(BlurGuideTest, TheRadiusGrowsWithRoughnessAndDistanceUpToItsCap) {
  const Image radius = guide("blur_guide.frag", 30.0);
  for (int y = 0; y < 46; ++y) {
    for (int x = 0; x < kBlurSize.width; ++x) {
      ASSERT_LE(radius.at(x, y, 1), 30.0F);
      ASSERT_GE(radius.at(x, y, 1), x > 0 ? radius.at(x - 1, y, 1) - 1e-3F : 0.0F) << x << " " << y;
      ASSERT_GE(radius.at(x, y, 1), y > 0 ? radius.at(x, y - 1, 1) - 1e-3F : 0.0F) << x << " " << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, BlurGuideTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
