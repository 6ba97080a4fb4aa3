#include "mutation/text_edit.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

TextEdit edit(const std::string& replace, const std::string& with) {
  return {.file = "shaders/a.frag", .replace = replace, .with = with};
}

TEST(TextEdit, ChangesTheOnePlaceAndNothingElse) {
  EXPECT_EQ(applyEdit("a < b;\nc <= d;\n", edit("c <= d", "c < d"), "").value(), "a < b;\nc < d;\n");
  EXPECT_EQ(applyEdit("one\ntwo\nthree\n", edit("two\n", ""), "").value(), "one\nthree\n");
}

TEST(TextEdit, MustFitExactlyOnce) {
  const auto nowhere = applyEdit("a < b", edit("a > b", "a"), "m.toml");
  ASSERT_FALSE(nowhere);
  EXPECT_NE(sentence(nowhere.error()).find("0 times"), std::string::npos);
  EXPECT_NE(sentence(nowhere.error()).find("m.toml"), std::string::npos);
  const auto twice = applyEdit("a < b, a < c", edit("a <", "a >"), "m.toml");
  ASSERT_FALSE(twice);
  EXPECT_NE(sentence(twice.error()).find("2 times"), std::string::npos);
}

TEST(TextEdit, PlacesThatOverlapAreTwo) {
  EXPECT_FALSE(applyEdit("aaa", edit("aa", "b"), ""));
}

TEST(TextEdit, OfNothingIsRefused) {
  EXPECT_FALSE(applyEdit("abc", edit("", "b"), ""));
}

}  // namespace
}  // namespace ssrkit
