#include "report/plain_utf8.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

TEST(PlainUtf8, TextStaysAsItIs) {
  const std::string text = "a\tb\r\n \xC3\xA9 \xE2\x89\xA4 \xF0\x9F\x9A\x80 <&>\"";  // é ≤ and a rocket
  EXPECT_EQ(plainUtf8(text), text);
  EXPECT_EQ(plainUtf8(""), "");
}

TEST(PlainUtf8, ControlCharactersAreReplaced) {
  EXPECT_EQ(plainUtf8(std::string_view("a\0b\x1B[0m\x7F", 8)), "a\uFFFDb\uFFFD[0m\uFFFD");
}

TEST(PlainUtf8, BytesThatAreNoUtf8AreReplacedOneByOne) {
  EXPECT_EQ(plainUtf8("\xFF!"), "\uFFFD!");
  EXPECT_EQ(plainUtf8("\x80"), "\uFFFD");                            // a byte that continues nothing
  EXPECT_EQ(plainUtf8("\xC3"), "\uFFFD");                            // cut at the end
  EXPECT_EQ(plainUtf8("\xC3(x"), "\uFFFD(x");                        // not continued
  EXPECT_EQ(plainUtf8("\xC0\xAF"), "\uFFFD\uFFFD");                  // '/' in two bytes
  EXPECT_EQ(plainUtf8("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");        // half of a surrogate pair
  EXPECT_EQ(plainUtf8("\xEF\xBF\xBF"), "\uFFFD\uFFFD\uFFFD");        // U+FFFF, which XML forbids
  EXPECT_EQ(plainUtf8("\xF4\x90\x80\x80").size(), std::size_t{12});  // beyond U+10FFFF
}

}  // namespace
}  // namespace ssrkit
