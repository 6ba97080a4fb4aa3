#include "base/text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace ssrkit {
namespace {

const std::vector<std::string> kStages = {"naive", "refined", "dda", "hiz", "walk"};

TEST(NearestName, FindsOneSlipOfTheKeyboard) {
  EXPECT_EQ(nearestName("hzi", kStages), "hiz");
  EXPECT_EQ(nearestName("HIZ", kStages), "hiz");
  EXPECT_EQ(nearestName("refned", kStages), "refined");
  EXPECT_EQ(nearestName("thickness", std::vector<std::string>{"thickness_m", "jitter"}), "thickness_m");
}

TEST(NearestName, SuggestsNothingForAnUnrelatedWord) {
  EXPECT_EQ(nearestName("cone", kStages), std::nullopt);
  EXPECT_EQ(nearestName("", kStages), std::nullopt);
  EXPECT_EQ(nearestName("x", std::vector<std::string>{"y"}), std::nullopt);
  EXPECT_EQ(nearestName("hiz", {}), std::nullopt);
}

TEST(NearestName, PrefersTheSmallerDistance) {
  EXPECT_EQ(nearestName("step_n", std::vector<std::string>{"step_cm", "step_m"}), "step_m");
}

TEST(JoinNames, PutsAndBeforeTheLast) {
  EXPECT_EQ(joinNames({}), "");
  EXPECT_EQ(joinNames(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(joinNames(std::vector<std::string>{"a", "b"}), "a and b");
  EXPECT_EQ(joinNames(std::vector<std::string>{"a", "b", "c"}), "a, b and c");
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_EQ(split("a,,b,", ','), (std::vector<std::string>{"a", "", "b", ""}));
  EXPECT_EQ(split("", ','), std::vector<std::string>{""});
}

TEST(ParseNumber, TakesWholeFiniteAndInfiniteNumbers) {
  EXPECT_EQ(parseNumber("0.3"), 0.3);
  EXPECT_EQ(parseNumber("-1e-3"), -0.001);
  EXPECT_EQ(parseNumber("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parseNumber("-Infinity"), -std::numeric_limits<double>::infinity());
}

TEST(ParseNumber, RefusesWhatIsNoNumberOrNotOnlyOne) {
  for (const char* text : {"", " 1", "1 ", "1.0f", "0x10", "nan", "1,5", "one", "1e999", "+1", "--1"}) {
    EXPECT_EQ(parseNumber(text), std::nullopt) << "'" << text << "'";
  }
}

// The published test vectors of FNV-1a, 64 bit (Fowler, Noll, Vo).
TEST(HashBytes, IsFnv1a) {
  EXPECT_EQ(hashBytes(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(hashBytes("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(hashBytes("foobar"), 0x85944171f73967e8ULL);
}

}  // namespace
}  // namespace ssrkit
