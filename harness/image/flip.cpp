#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "image/separable_filter.h"

namespace ssrkit {

namespace {

using Colour = std::array<double, 3>;

constexpr double kPi = std::numbers::pi;

// Linear sRGB primaries and D65 as fractions, so that white is exactly (1, 1, 1) over the illuminant.
constexpr std::array<Colour, 3> kXyzFromRgb = {{
    {10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
    {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
    {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0},
}};

Colour times(const std::array<Colour, 3>& matrix, const Colour& v) {
  Colour product{};
  for (std::size_t row = 0; row < 3; ++row) {
    product[row] = matrix[row][0] * v[0] + matrix[row][1] * v[1] + matrix[row][2] * v[2];
  }
  return product;
}

// By cofactors: 1 / determinant times the cross products of the other rows.
std::array<Colour, 3> inverseOf(const std::array<Colour, 3>& m) {
  const auto cofactor = [&](std::size_t row, std::size_t column) {
    const std::size_t r1 = (row + 1) % 3;
    const std::size_t r2 = (row + 2) % 3;
    const std::size_t c1 = (column + 1) % 3;
    const std::size_t c2 = (column + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  std::array<Colour, 3> inverse{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      inverse[row][column] = cofactor(column, row) / determinant;
    }
  }
  return inverse;
}

const Colour& white() {
  static const Colour xyz = times(kXyzFromRgb, {1.0, 1.0, 1.0});
  return xyz;
}

Colour relativeXyz(const Colour& rgb) {
  Colour xyz = times(kXyzFromRgb, rgb);
  for (std::size_t i = 0; i < 3; ++i) {
    xyz[i] /= white()[i];
  }
  return xyz;
}

// A linear version of L*a*b*, in which the contrast sensitivity functions are known.
Colour opponentOf(const Colour& rgb) {
  const Colour xyz = relativeXyz(rgb);
  return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

Colour rgbOfOpponent(const Colour& opponent) {
  static const std::array<Colour, 3> rgb_from_xyz = inverseOf(kXyzFromRgb);
  const double y = (opponent[0] + 16.0) / 116.0;
  return times(rgb_from_xyz, {(y + opponent[1] / 500.0) * white()[0], y * white()[1],
                              (y - opponent[2] / 200.0) * white()[2]});
}

// CIE L*a*b* with Hunt's effect: colours fade with lightness.
Colour huntLabOf(const Colour& rgb) {
  constexpr double kKnee = 6.0 / 29.0;
  Colour f = relativeXyz(rgb);
  for (double& value : f) {
    value = value > kKnee * kKnee * kKnee ? std::cbrt(value) : value / (3.0 * kKnee * kKnee) + 4.0 / 29.0;
  }
  const double lightness = 116.0 * f[1] - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (f[0] - f[1]), 0.01 * lightness * 200.0 * (f[1] - f[2])};
}

// City-block in lightness, Euclidean in the hues: holds for large differences too.
double hyab(const Colour& a, const Colour& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// One of the sums of Gaussians that stand for a channel's contrast sensitivity, table 1.
struct Sensitivity {
  double a1;
  double b1;
  double a2;
  double b2;
};
constexpr Sensitivity kAchromatic = {1.0, 0.0047, 0.0, 1e-5};
constexpr Sensitivity kRedGreen = {1.0, 0.0053, 0.0, 1e-5};
constexpr Sensitivity kBlueYellow = {34.1, 0.04, 13.5, 0.025};

Plane seen(const Plane& channel, const Sensitivity& sensitivity, double pixels_per_degree) {
  const double radius = std::ceil(3.0 * std::sqrt(kBlueYellow.b1 / (2.0 * kPi * kPi)) * pixels_per_degree);
  const auto gaussian = [&](double b) {
    return kernelOf(static_cast<int>(radius), [&](double x) {
      const double degrees = x / pixels_per_degree;
      return std::exp(-kPi * kPi * degrees * degrees / b);
    });
  };
  const auto weightOf = [](double a, double b, const Kernel& kernel) {
    return a * std::sqrt(kPi / b) * kernel.sum() * kernel.sum();
  };
  const Kernel first = gaussian(sensitivity.b1);
  const double first_weight = weightOf(sensitivity.a1, sensitivity.b1, first);
  Plane result = filtered(channel, first.normalised(), first.normalised());
  if (sensitivity.a2 > 0.0) {
    const Kernel second = gaussian(sensitivity.b2);
    const double second_weight = weightOf(sensitivity.a2, sensitivity.b2, second);
    const Plane other = filtered(channel, second.normalised(), second.normalised());
    const double share = first_weight / (first_weight + second_weight);
    for (std::size_t i = 0; i < result.data.size(); ++i) {
      result.data[i] = static_cast<float>(share * result.data[i] + (1.0 - share) * other.data[i]);
    }
  }
  return result;
}

using Opponent = std::array<Plane, 3>;

Opponent opponentPlanes(const Image& linear) {
  const Plane empty{linear.size, std::vector<float>(linear.texelCount())};
  Opponent planes = {empty, empty, empty};
  const std::size_t channels = linear.channelCount();
  for (std::size_t texel = 0; texel < linear.texelCount(); ++texel) {
    Colour rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
      const float value = linear.data[texel * channels + (channels < 3 ? 0 : i)];
      rgb[i] = value > 0.0F ? std::min(static_cast<double>(value), 1.0) : 0.0;
    }
    const Colour opponent = opponentOf(rgb);
    for (std::size_t i = 0; i < 3; ++i) {
      planes[i].data[texel] = static_cast<float>(opponent[i]);
    }
  }
  return planes;
}

std::vector<Colour> seenColours(const Opponent& planes, double pixels_per_degree) {
  const Plane y = seen(planes[0], kAchromatic, pixels_per_degree);
  const Plane red_green = seen(planes[1], kRedGreen, pixels_per_degree);
  const Plane blue_yellow = seen(planes[2], kBlueYellow, pixels_per_degree);
  std::vector<Colour> colours(y.data.size());
  for (std::size_t i = 0; i < colours.size(); ++i) {
    Colour rgb = rgbOfOpponent({y.data[i], red_green.data[i], blue_yellow.data[i]});
    for (double& value : rgb) {
      value = std::clamp(value, 0.0, 1.0);
    }
    colours[i] = huntLabOf(rgb);
  }
  return colours;
}

// Section 4.1.3: the lower 40 % of the distances take 95 % of the range.
double colourError(double distance) {
  constexpr double kExponent = 0.7;
  constexpr double kKnee = 0.4;
  constexpr double kKneeError = 0.95;
  static const double largest =
      std::pow(hyab(huntLabOf({0.0, 1.0, 0.0}), huntLabOf({0.0, 0.0, 1.0})), kExponent);
  const double error = std::pow(distance, kExponent) / largest;
  return error < kKnee ? error * kKneeError / kKnee
                       : kKneeError + (error - kKnee) / (1.0 - kKnee) * (1.0 - kKneeError);
}

// How much of an edge (the first derivative of a Gaussian) or of a point (the second) there is at each texel.
struct Features {
  std::vector<double> edges;
  std::vector<double> points;
};

std::vector<double> lengthsOf(const Plane& along_x, const Plane& along_y) {
  std::vector<double> lengths(along_x.data.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = std::hypot(along_x.data[i], along_y.data[i]);
  }
  return lengths;
}

Features featuresOf(Plane y, double pixels_per_degree) {
  for (float& value : y.data) {
    value = (value + 16.0F) / 116.0F;
  }
  constexpr double kDetectorWidth = 0.082;  // degrees between peak and trough
  const double deviation = 0.5 * kDetectorWidth * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  const auto g = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
  const Kernel across = kernelOf(radius, g).normalised();
  const Kernel edge = kernelOf(radius, [&](double x) { return -x * g(x); }).balanced();
  const Kernel point =
      kernelOf(radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * g(x); }).balanced();
  return {lengthsOf(filtered(y, edge, across), filtered(y, across, edge)),
          lengthsOf(filtered(y, point, across), filtered(y, across, point))};
}

}  // namespace

Image flipMap(const Image& reference, const Image& test, double pixels_per_degree) {
  SSRKIT_CHECK(reference.size == test.size && reference.channels == test.channels && !test.data.empty());
  const Opponent expected = opponentPlanes(reference);
  const Opponent yours = opponentPlanes(test);
  const std::vector<Colour> expected_seen = seenColours(expected, pixels_per_degree);
  const std::vector<Colour> yours_seen = seenColours(yours, pixels_per_degree);
  const Features expected_features = featuresOf(expected[0], pixels_per_degree);
  const Features yours_features = featuresOf(yours[0], pixels_per_degree);
  Image map(test.size, {"flip"});
  for (std::size_t i = 0; i < map.data.size(); ++i) {
    const double colour = colourError(hyab(expected_seen[i], yours_seen[i]));
    const double feature = std::max(std::abs(expected_features.edges[i] - yours_features.edges[i]),
                                    std::abs(expected_features.points[i] - yours_features.points[i]));
    map.data[i] = static_cast<float>(std::pow(colour, 1.0 - std::sqrt(feature / std::numbers::sqrt2)));
  }
  return map;
}

}  // namespace ssrkit
