// The fitted exponent against laws that are known, and its standard error against its own spread.
#include "check/power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace ssrkit {
namespace {

std::vector<PowerLawPoint> pointsOf(double factor, double exponent, const std::vector<double>& xs) {
  std::vector<PowerLawPoint> points;
  points.reserve(xs.size());
  for (const double x : xs) {
    points.push_back({x, factor * std::pow(x, exponent)});
  }
  return points;
}

TEST(PowerLaw, ALawWithoutNoiseIsFoundExactly) {
  for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 2.0}) {
    const auto law = fitPowerLaw(pointsOf(3.5, exponent, {320.0, 640.0, 1280.0, 2560.0}));
    ASSERT_TRUE(law.has_value());
    EXPECT_NEAR(law->exponent, exponent, 1e-12);
    EXPECT_NEAR(law->factor, 3.5, 1e-10);
    EXPECT_NEAR(law->standard_error, 0.0, 1e-12);
  }
}

TEST(PowerLaw, ThreePointsByHand) {
  // Logarithms to base 2 of x: 0, 1, 2, of y: 0, 2, 1. Slope 1/2; residuals -1/2, 1, -1/2: their squares sum
  // to 3/2, over 1 degree of freedom and a spread of 2 that is an error of sqrt(3)/2.
  const std::vector<PowerLawPoint> points = {{1.0, 1.0}, {2.0, 4.0}, {4.0, 2.0}};
  const auto law = fitPowerLaw(points);
  ASSERT_TRUE(law.has_value());
  EXPECT_NEAR(law->exponent, 0.5, 1e-12);
  EXPECT_NEAR(law->standard_error, std::sqrt(3.0) / 2.0, 1e-12);
}

TEST(PowerLaw, TheStandardErrorIsTheSpreadOfTheExponent) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.1);
  double squares = 0.0;
  double mean_error = 0.0;
  constexpr int kTrials = 4000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<PowerLawPoint> points = pointsOf(2.0, 1.5, {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0});
    for (PowerLawPoint& point : points) {
      point.y *= std::exp(noise(random));
    }
    const PowerLaw law = fitPowerLaw(points).value();
    squares += (law.exponent - 1.5) * (law.exponent - 1.5) / kTrials;
    mean_error += law.standard_error * law.standard_error / kTrials;
  }
  EXPECT_NEAR(std::sqrt(mean_error) / std::sqrt(squares), 1.0, 0.05);
}

TEST(PowerLaw, TwoPointsAreMetByAnyLine) {
  const auto law = fitPowerLaw(pointsOf(1.0, 2.0, {1.0, 3.0}));
  ASSERT_TRUE(law.has_value());
  EXPECT_NEAR(law->exponent, 2.0, 1e-12);
  EXPECT_EQ(law->standard_error, 0.0);
}

TEST(PowerLaw, WhatHasNoLogarithmOrNoSpreadHasNoLaw) {
  EXPECT_FALSE(fitPowerLaw({}).has_value());
  EXPECT_FALSE(fitPowerLaw(pointsOf(1.0, 1.0, {2.0})).has_value());
  EXPECT_FALSE(fitPowerLaw(pointsOf(1.0, 1.0, {2.0, 2.0, 2.0})).has_value());
  EXPECT_FALSE(fitPowerLaw(std::vector<PowerLawPoint>{{1.0, 1.0}, {2.0, 0.0}}).has_value());
  EXPECT_FALSE(fitPowerLaw(std::vector<PowerLawPoint>{{0.0, 1.0}, {2.0, 1.0}}).has_value());
  EXPECT_FALSE(
      fitPowerLaw(std::vector<PowerLawPoint>{{1.0, 1.0}, {2.0, std::numeric_limits<double>::infinity()}})
          .has_value());
}

}  // namespace
}  // namespace ssrkit
