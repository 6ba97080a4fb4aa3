#include "frame/uniform_values.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace ssrkit {
namespace {

float floatAt(const std::vector<std::byte>& bytes, std::size_t offset) {
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

// layout(std140) { float a; vec3 b; mat4 m; vec4 list[2]; int n; }
UniformBlock std140Block() {
  return {
      .name = "Block",
      .binding = 0,
      .size_bytes = 144,
      .members = {{.name = "a", .offset_bytes = 0},
                  {.name = "b", .offset_bytes = 16, .rows = 3},
                  {.name = "m", .offset_bytes = 32, .rows = 4, .columns = 4, .matrix_stride_bytes = 16},
                  {.name = "list", .offset_bytes = 96, .rows = 4, .array_count = 2, .array_stride_bytes = 16},
                  {.name = "n", .type = ScalarType::kInt, .offset_bytes = 128}}};
}

UniformValues allValues() {
  UniformValues values;
  values.set("a", 1.5);
  values.set("b", glm::dvec3(1, 2, 3));
  glm::dmat4 matrix(0.0);
  matrix[3][1] = 7.0;  // column 3, row 1
  values.set("m", matrix);
  values.set("list", std::vector<glm::dvec4>{{1, 2, 3, 4}, {5, 6, 7, 8}});
  values.set("n", -3);
  return values;
}

TEST(UniformValues, StandAtTheOffsetsThatReflectionGives) {
  const auto bytes = allValues().pack(std140Block(), "a.frag");
  ASSERT_TRUE(bytes.has_value());
  ASSERT_EQ(bytes->size(), 144U);
  EXPECT_EQ(floatAt(*bytes, 0), 1.5F);
  EXPECT_EQ(floatAt(*bytes, 16 + 8), 3.0F);
  EXPECT_EQ(floatAt(*bytes, 32 + 3 * 16 + 4), 7.0F);
  EXPECT_EQ(floatAt(*bytes, 96 + 16 + 4), 6.0F);
  int whole = 0;
  std::memcpy(&whole, bytes->data() + 128, sizeof(whole));
  EXPECT_EQ(whole, -3);
}

TEST(UniformValues, FollowTheMembersWhenTheirOrderChanges) {
  UniformBlock swapped = std140Block();
  swapped.members[0].offset_bytes = 132;
  const auto bytes = allValues().pack(swapped, "a.frag");
  ASSERT_TRUE(bytes.has_value());
  EXPECT_EQ(floatAt(*bytes, 132), 1.5F);
}

TEST(UniformValues, GiveShadersALargeNumberForInfinity) {
  UniformValues values;
  values.set("a", std::numeric_limits<double>::infinity());
  const auto bytes = values.pack({.name = "B", .size_bytes = 16, .members = {{.name = "a"}}}, "a.frag");
  ASSERT_TRUE(bytes.has_value());
  EXPECT_EQ(floatAt(*bytes, 0), 1e30F);
}

TEST(UniformValues, RefuseAMemberThatNobodyKnows) {
  UniformBlock block = std140Block();
  block.members[0].name = "colour";
  const auto bytes = allValues().pack(block, "mine.frag");
  ASSERT_FALSE(bytes.has_value());
  EXPECT_EQ(sentence(bytes.error()),
            "mine.frag: could not fill the member 'colour' of the block 'Block': the kit has no value of "
            "that name; it "
            "offers a, b, list, m and n");
}

TEST(UniformValues, RefuseAMemberOfAnotherType) {
  UniformBlock block = std140Block();
  block.members[1].rows = 4;
  const auto bytes = allValues().pack(block, "mine.frag");
  ASSERT_FALSE(bytes.has_value());
  EXPECT_NE(sentence(bytes.error()).find("declared with 4x1 components, the kit's value has 3x1"),
            std::string::npos);
}

}  // namespace
}  // namespace ssrkit
