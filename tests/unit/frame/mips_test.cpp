// Mip chains by exact areas, and the lookup into them by the size of a cone.
#include <fmt/format.h>

#include <random>

#include "pass_test.h"

namespace ssrkit {
namespace {

const std::vector<Size> kMippedSizes = {{1, 1}, {2, 2}, {3, 3}, {1, 40}, {127, 63}, {161, 91}, {64, 32}};

// The share of the coarser texel's extent that the finer one covers, from the two intervals.
double overlap(int coarser, int coarser_size, int finer, int finer_size) {
  const double width = static_cast<double>(finer_size) / coarser_size;
  const double from = std::max(coarser * width, static_cast<double>(finer));
  const double to = std::min((coarser + 1) * width, finer + 1.0);
  return std::max(to - from, 0.0) / width;
}

// Each texel the mean over its area, in double precision.
Image reduced(const Image& finer) {
  const Size size{std::max(1, finer.size.width / 2), std::max(1, finer.size.height / 2)};
  return imageOf(size, [&](int x, int y) {
    std::array<double, 4> sum{};
    for (int fine_y = 0; fine_y < finer.size.height; ++fine_y) {
      const double weight_y = overlap(y, size.height, fine_y, finer.size.height);
      for (int fine_x = 0; weight_y > 0.0 && fine_x < finer.size.width; ++fine_x) {
        const double weight = weight_y * overlap(x, size.width, fine_x, finer.size.width);
        for (std::size_t channel = 0; weight > 0.0 && channel < 4; ++channel) {
          sum[channel] += weight * static_cast<double>(finer.at(fine_x, fine_y, channel));
        }
      }
    }
    return sum;
  });
}

Image randomImage(Size size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return imageOf(size, [&](int, int) { return std::array{unit(random), unit(random), unit(random), 1.0}; });
}

class MipsTest : public PassTest {
 protected:
  std::string isExactAreas(const std::string& shader, Size size) {
    begin();
    const std::vector<Image> mips = drawMips(shader, randomImage(size), Format::kRgba32f);
    for (std::size_t mip = 1; mip < mips.size(); ++mip) {
      const std::string off = difference(mips[mip], reduced(mips[mip - 1]), 1e-6);
      if (!off.empty()) {
        return fmt::format("{}x{} mip {}: {}", size.width, size.height, mip, off);
      }
    }
    return "";
  }
};

TEST_P(MipsTest, EachTexelIsTheMeanOverItsArea) {
  const auto check = [this](const std::string& shader) {
    for (const Size& size : kMippedSizes) {
      const std::string off = isExactAreas(shader, size);
      if (!off.empty()) {
        return off;
      }
    }
    return std::string();
  };
  holdsAndKills(check, "mips_reduce.frag", {"mips_drop_odd_rows"});
}

TEST_P(MipsTest, AConstantStaysItselfBitForBit) {
  for (const Size& size : kMippedSizes) {
    begin();
    const Image constant = imageOf(size, [](int, int) {
      return std::array{0.7998046875, 3.30078125, 0.0009765625, 1.0};
    });
    const std::vector<Image> mips = drawMips("mips_reduce.frag", constant, Format::kRgba16f);
    for (const Image& mip : mips) {
      for (std::size_t i = 0; i < mip.data.size(); ++i) {
        ASSERT_EQ(mip.data[i], constant.data[i % 4]) << size.width << "x" << size.height;
      }
    }
  }
}

// A texel that is cut counts as one colour on either side of the cut: each odd size moves a ramp by up to a
// sixteenth of its texels, and no more. Filters that drop odd rows move it by up to half of one.
TEST_P(MipsTest, ARampStaysStraightToASixteenthOfATexelPerOddSize) {
  for (const Size& size : {Size{161, 91}, Size{127, 63}, Size{128, 64}}) {
    begin();
    const auto ramp = [](const Size& of) {
      return imageOf(of, [&](int x, int y) {
        return std::array{(x + 0.5) / of.width, (y + 0.5) / of.height, 0.0, 1.0};
      });
    };
    double allowed = 1e-6;
    const std::vector<Image> mips = drawMips("mips_reduce.frag", ramp(size), Format::kRgba32f);
    for (std::size_t mip = 1; mip < mips.size(); ++mip) {
      const Size finer = mips[mip - 1].size;
      allowed += std::max(finer.width % 2 / (16.0 * finer.width), finer.height % 2 / (16.0 * finer.height));
      EXPECT_EQ(difference(mips[mip], ramp(mips[mip].size), allowed), "") << "mip " << mip;
    }
  }
}

double coneTangent(double roughness) {
  return std::tan(2.0 * std::atan(roughness * roughness));
}

// The circle's radius as the paper writes it, of an isosceles triangle of base a and height h.
double inscribedRadius(double a, double h) {
  return a * (std::sqrt(a * a + 4.0 * h * h) - a) / (4.0 * h);
}

double bilinear(const Image& mip, double u, double v, std::size_t channel) {
  const double x = u * mip.size.width - 0.5;
  const double y = v * mip.size.height - 0.5;
  const auto at = [&](double column, double row) {
    return static_cast<double>(mip.at(std::clamp(static_cast<int>(column), 0, mip.size.width - 1),
                                      std::clamp(static_cast<int>(row), 0, mip.size.height - 1), channel));
  };
  const double left = std::floor(x);
  const double top = std::floor(y);
  return std::lerp(std::lerp(at(left, top), at(left + 1, top), x - left),
                   std::lerp(at(left, top + 1), at(left + 1, top + 1), x - left), y - top);
}

double trilinear(const std::vector<Image>& mips, double u, double v, double mip, std::size_t channel) {
  const auto lower = std::min(static_cast<std::size_t>(mip), mips.size() - 1);
  const std::size_t upper = std::min(lower + 1, mips.size() - 1);
  return std::lerp(bilinear(mips[lower], u, v, channel), bilinear(mips[upper], u, v, channel),
                   mip - std::floor(mip));
}

TEST_P(MipsTest, ACamerasConeReadsTheMipOfItsCircleAndTheTexelItselfAtContact) {
  const Size size{161, 91};
  const double px_scale = 120.0;
  const auto roughness = [](int x) { return x / 160.0; };
  const auto t_m = [](int, int y) { return 0.05 * y; };
  const auto dist_hit = [](int x, int y) { return 2.0 + 0.01 * x + 0.02 * y; };
  const auto check = [&](const std::string& shader) {
    begin();
    const Image lit = randomImage(size);
    const std::vector<Image> mips = drawMips("mips_reduce.frag", lit, Format::kRgba32f, "lit_mips");
    values_.set("texel_uv", 1.0 / glm::dvec2(size.width, size.height));
    values_.set("px_scale", glm::dvec2(px_scale, -px_scale));
    give("lit", lit);
    giveIntegers("hit_texel",
                 imageOf(
                     size,
                     [&](int x, int y) {
                       return std::array<double, 4>{160.0 - x, 90.0 - y};
                     },
                     2),
                 Format::kRg16i);
    give("hit_point", imageOf(size, [&](int x, int y) { return std::array{0.0, 0.0, t_m(x, y), 0.0}; }));
    give("material", imageOf(size, [&](int x, int) { return std::array{1.0, roughness(x), 1.0, 1.0}; }));
    give("dist_view",
         imageOf(
             size, [&](int x, int y) { return std::array<double, 4>{dist_hit(x, y)}; }, 1),
         Format::kR32f);
    const Image reflection = draw(shader, size);
    for (int x = 0; x < size.width; ++x) {  // at contact, and of a mirror: the hit texel's own bits
      for (std::size_t channel = 0; channel < 3; ++channel) {
        if (reflection.at(x, 0, channel) != lit.at(160 - x, 90, channel)) {
          return fmt::format("the contact's texel {} is not the hit's", x);
        }
      }
    }
    const Image expected = imageOf(size, [&](int x, int y) {
      const double h = t_m(x, y);
      const double radius_m =
          h > 0.0 ? inscribedRadius(2.0 * h * coneTangent(std::min(roughness(x), 0.98)), h) : 0.0;
      const double mip = std::max(std::log2(2.0 * radius_m * px_scale / dist_hit(160 - x, 90 - y)), 0.0);
      const double spread = 0.5 * (std::exp2(mip) - 1.0);
      std::array<double, 4> sum{0.0, 0.0, 0.0, 1.0};
      for (std::size_t channel = 0; channel < 3; ++channel) {
        for (const double side_x : {-1.0, 1.0}) {
          for (const double side_y : {-1.0, 1.0}) {
            sum[channel] += 0.25 * trilinear(mips, (160.5 - x + side_x * spread) / size.width,
                                             (90.5 - y + side_y * spread) / size.height, mip, channel);
          }
        }
      }
      return sum;
    });
    return difference(reflection, expected, 1e-3);
  };
  holdsAndKills(check, "resolve_cone.frag", {"cone_without_distance"});
}

INSTANTIATE_TEST_SUITE_P(Each, MipsTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
