// The hash that all noise is made of (random.glsl), by what a hash must do.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>

#include "base/atomic_file.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr int kInputCount = 1024;
constexpr int kInputBits = 3 * 32;
constexpr int kOutputBits = 16;  // the upper ones: noise is made of the upper 24

// A column an input, a row one of its bits: which upper bits of the three outputs change with that bit.
constexpr const char* kChangedBits = R"(#version 450
#include "random.glsl"
layout(location = 0) out vec4 changed;
void main() {
  uint i = uint(gl_FragCoord.x);
  int bit = int(gl_FragCoord.y);
  uvec3 v = uvec3(i * 2654435761u, i * 40503u + 7u, i * i * 97u + 3u);
  uvec3 other = v;
  other[bit / 32] ^= 1u << uint(bit % 32);
  changed = vec4(vec3((hash_pcg3d(v) ^ hash_pcg3d(other)) >> 16u), 0.0);
}
)";

class RandomTest : public PassTest {};

// A fair coin for each pair of bits would change within 0.42 and 0.58 of 1024 inputs; what is asked is only
// that no bit is out of reach: a product brings bits up, never down.
TEST_P(RandomTest, EveryBitOfTheInputReachesEveryUpperBitOfTheHash) {
  const std::filesystem::path shader =
      std::filesystem::temp_directory_path() / fmt::format("ssrkit-changed-bits-{}.frag", getpid());
  ASSERT_TRUE(writeFileAtomically(shader, kChangedBits).has_value());
  begin();
  const Image changed = draw(shader.string(), {kInputCount, kInputBits});
  std::filesystem::remove(shader);
  for (int input_bit = 0; input_bit < kInputBits; ++input_bit) {
    for (int output_bit = 0; output_bit < 3 * kOutputBits; ++output_bit) {
      int count = 0;
      for (int i = 0; i < kInputCount; ++i) {
        const float word = changed.at(i, input_bit, static_cast<std::size_t>(output_bit / kOutputBits));
        count += static_cast<int>(static_cast<std::uint32_t>(word) >> (output_bit % kOutputBits) & 1U);
      }
      EXPECT_GT(count, kInputCount / 10) << "bit " << input_bit << " hardly changes bit " << output_bit;
      EXPECT_LT(count, kInputCount - kInputCount / 10) << "bit " << input_bit << ", bit " << output_bit;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Each, RandomTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
