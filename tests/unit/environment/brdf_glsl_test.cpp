// The shaders' text of the BRDF, compiled as C++ with GLM, against formulas in double precision written apart
// from it.
#include <glm/glm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glsl {
using glm::clamp;
using glm::mat4;
using glm::max;
using glm::min;
using glm::mix;
using glm::sqrt;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "brdf_ggx.glsl"
}  // namespace glsl

namespace ssrkit {
namespace {

const double kPi = static_cast<double>(std::numbers::pi_v<long double>);

TEST(BrdfGlsl, DistributionIntegratesToOne) {
  for (const double alpha : {0.0225, 0.1, 0.5, 1.0}) {
    double sum = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      const double t = (static_cast<double>(i) + static_cast<double>(0.5F)) / kSteps;
      const double tangent = alpha * t / (1 - t);
      const double cosine = 1 / std::sqrt(1 + tangent * tangent);
      const double width = alpha / ((1 - t) * (1 - t)) * cosine * cosine / kSteps;
      const float density = glsl::ggx_distribution(static_cast<float>(cosine), static_cast<float>(alpha));
      sum += static_cast<double>(density) * cosine * (tangent * cosine) * width * 2 * kPi;
    }
    EXPECT_NEAR(sum, 1, 2e-4) << alpha;
  }
}

TEST(BrdfGlsl, VisibilityIsHeightCorrelatedSmith) {
  for (const double alpha : {0.0225, 0.25, 1.0}) {
    for (const double cos_light : {0.01, 0.3, 0.9, 1.0}) {
      for (const double cos_view : {0.01, 0.4, 1.0}) {
        const auto lambda = [&](double cosine) {
          const double tangent2 = 1 / (cosine * cosine) - 1;
          return (std::sqrt(1 + alpha * alpha * tangent2) - 1) / 2;
        };
        const double masking = 1 / (1 + lambda(cos_light) + lambda(cos_view));
        const double expected = masking / (4 * cos_light * cos_view);
        const float computed = glsl::smith_visibility(
            static_cast<float>(cos_light), static_cast<float>(cos_view), static_cast<float>(alpha));
        EXPECT_NEAR(static_cast<double>(computed) / expected, 1, 1e-5)
            << alpha << " " << cos_light << " " << cos_view;
      }
    }
  }
}

TEST(BrdfGlsl, AMetalOfF0OneReflectsAllAndBlackNothing) {
  for (const float single : {0.32F, 0.8F, 1.0F}) {
    const glm::vec2 scale_bias(0.9F * single, 0.1F * single);
    EXPECT_NEAR(glsl::specular_albedo(glm::vec3(1.0F), scale_bias).g, 1.0F, 1e-6F);
    EXPECT_EQ(glsl::specular_albedo(glm::vec3(0.0F), scale_bias), glm::vec3(0.0F));
    for (const float f0 : {0.02F, 0.04F, 0.3F, 0.9F}) {
      const float albedo = glsl::specular_albedo(glm::vec3(f0), scale_bias).r;
      EXPECT_GT(albedo, 0.0F);
      EXPECT_LT(albedo, 1.0F);
    }
  }
}

// All that light from every side brings to the lobe, summed direction by direction, is its albedo: direct
// light and the environment agree.
TEST(BrdfGlsl, LightFromEverySideReflectsTheSpecularAlbedo) {
  for (const float roughness : {0.3F, 0.6F, 1.0F}) {
    for (const float cos_view : {0.2F, 0.7F, 1.0F}) {
      const glm::vec3 to_eye(std::sqrt(1.0F - cos_view * cos_view), 0.0F, cos_view);
      const auto reflected = [&](glm::vec3 f0, glm::vec3 diffuse, glm::vec2 scale_bias) {
        const glsl::GgxSurface surface{glm::vec3(0, 0, 1),    to_eye, cos_view, roughness * roughness, f0,
                                       glsl::fresnel_f90(f0), diffuse};
        double sum = 0;
        constexpr int kSteps = 700;
        for (int i = 0; i < kSteps; ++i) {
          const float cosine = (static_cast<float>(i) + 0.5F) / kSteps;
          const float sine = std::sqrt(1.0F - cosine * cosine);
          for (int j = 0; j < kSteps; ++j) {
            const float azimuth = 2.0F * std::numbers::pi_v<float> * (static_cast<float>(j) + 0.5F) / kSteps;
            const glm::vec3 to_light(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine);
            sum += static_cast<double>(glsl::ggx_brdf(surface, to_light, cosine, scale_bias).r * cosine);
          }
        }
        return sum * 2 * kPi / (kSteps * kSteps);
      };
      // Scale and bias themselves, from the same sum: without compensation while they add to 1.
      const double all = reflected(glm::vec3(1.0F), glm::vec3(0.0F), glm::vec2(1.0F, 0.0F));
      const double at_half = reflected(glm::vec3(0.5F), glm::vec3(0.0F), glm::vec2(1.0F, 0.0F));
      const double bias = 2 * at_half - all;
      const glm::vec2 scale_bias(static_cast<float>(all - bias), static_cast<float>(bias));
      EXPECT_NEAR(reflected(glm::vec3(1.0F), glm::vec3(0.0F), scale_bias), 1, 1e-4)
          << roughness << " " << cos_view;
      EXPECT_NEAR(reflected(glm::vec3(0.04F), glm::vec3(1.0F), scale_bias), 1, 1e-4)
          << roughness << " " << cos_view;
    }
  }
}

}  // namespace
}  // namespace ssrkit
