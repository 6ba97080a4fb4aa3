#include "shader/glsl_text.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

TEST(GlslText, CommentsBecomeBlanksAndEveryColumnStays) {
  EXPECT_EQ(blankComments("a/*b*/c//d\ne"), "a     c   \ne");
  EXPECT_EQ(blankComments("/*a\nb*/c"), "   \n   c");
}

TEST(GlslText, ACommentThatIsNeverClosedBlanksTheRest) {
  EXPECT_EQ(blankComments("x/*yz"), "x    ");
}

TEST(GlslText, ALineCommentRunsOnAfterABackslash) {
  EXPECT_EQ(blankComments("//a\\\nb\nc"), "    \n \nc");
}

TEST(GlslText, ASlashAloneIsNoComment) {
  EXPECT_EQ(blankComments("a/b /"), "a/b /");
}

TEST(GlslText, IncludesAreFoundWithTheirLines) {
  const auto includes =
      findIncludeLines("#version 450\n  # include <a.glsl>\n\n#include \"b/c.glsl\" // why");
  ASSERT_EQ(includes.size(), 2U);
  EXPECT_EQ(includes[0].name, "a.glsl");
  EXPECT_EQ(includes[0].line, 2);
  EXPECT_EQ(includes[1].name, "b/c.glsl");
  EXPECT_EQ(includes[1].line, 4);
}

TEST(GlslText, WhatOnlyLooksLikeAnIncludeIsNone) {
  EXPECT_TRUE(
      findIncludeLines("// #include \"a\"\n/*\n#include \"b\"\n*/\n#include FILE\n#include \"c\nx").empty());
}

TEST(GlslText, AColumnIsThatOfTheWholeWordOutsideComments) {
  EXPECT_EQ(findColumn("/* foo */ food + foo;", 1, "foo"), 18);
  EXPECT_EQ(findColumn("a\n  b += c;", 2, "+="), 5);
  EXPECT_EQ(findColumn("a", 1, "b"), std::nullopt);
  EXPECT_EQ(findColumn("a", 7, "a"), std::nullopt);
  EXPECT_EQ(findColumn("a", 1, ""), std::nullopt);
}

TEST(GlslText, AllLineEndsBecomeLineFeeds) {
  EXPECT_EQ(normaliseText("\xEF\xBB\xBF"
                          "a\r\nb\rc\n")
                .value(),
            "a\nb\nc\n");
}

TEST(GlslText, ControlBytesAreNoText) {
  const Expected<std::string> text = normaliseText(std::string("ab\0c", 4));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().problem, "byte 2 is 0x00, so it is no GLSL text");
}

}  // namespace
}  // namespace ssrkit
