#include "report/table_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace ssrkit {
namespace {

TEST(PercentText, NeverRoundsUpToAHundred) {
  EXPECT_EQ(percentText(1.0, 2), "100.00");
  EXPECT_EQ(percentText(0.999999, 2), "99.99");
  EXPECT_EQ(percentText(0.29, 0), "29");
  EXPECT_EQ(percentText(0.0, 1), "0.0");
}

TEST(CountText, StaysWithinFiveCharacters) {
  EXPECT_EQ(countText(0), "0");
  EXPECT_EQ(countText(99'999), "99999");
  EXPECT_EQ(countText(230'400), "230k");
  EXPECT_EQ(countText(8'294'400), "8.3M");
  EXPECT_EQ(countText(268'435'456), "268M");
}

TEST(MeasureText, KeepsAboutThreeDigitsAndNoExponent) {
  EXPECT_EQ(measureText(0.0), "0");
  EXPECT_EQ(measureText(0.0421), "0.042");
  EXPECT_EQ(measureText(1.234), "1.23");
  EXPECT_EQ(measureText(9.996), "10.0");
  EXPECT_EQ(measureText(99.96), "100");
  EXPECT_EQ(measureText(1234.5), "1234");
  EXPECT_EQ(measureText(std::numeric_limits<double>::infinity()), "inf");
}

TEST(CellText, CountsCodePointsAndTamesControlCharacters) {
  EXPECT_EQ(cellText("gl-osmesa", 9), "gl-osmesa");
  EXPECT_EQ(cellText("vk-swiftshader", 8), "vk-swi..");
  EXPECT_EQ(cellText("straße", 6), "straße");
  EXPECT_EQ(cellText("straßen", 6), "stra..");
  EXPECT_EQ(cellText("a\x1b[31m\n", 10), "a?[31m?");
  EXPECT_EQ(cellText("abc", 1), ".");
  EXPECT_EQ(columnsOf("straße"), 6U);
}

}  // namespace
}  // namespace ssrkit
