#include "environment/equirect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/exr.h"
#include "temporary_folder.h"

namespace ssrkit {
namespace {

class EquirectFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::string refusal(const Image& image) const {
    EXPECT_TRUE(writeExr(file(), image));
    const auto read = readEquirect(file());
    return read ? "" : sentence(read.error());
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "sky.exr"; }

  test::TemporaryFolder folder_;
};

Image rgb(Size size, float value = 0.5F) {
  Image image(size, {"R", "G", "B"});
  std::fill(image.data.begin(), image.data.end(), value);
  return image;
}

TEST_F(EquirectFile, IsReadWithTwiceTheWidthOfItsHeight) {
  EXPECT_EQ(refusal(rgb({8, 4})), "");
  EXPECT_EQ(refusal(rgb({2, 1})), "");
}

TEST_F(EquirectFile, OfAnotherShapeIsRefused) {
  EXPECT_NE(refusal(rgb({8, 8}))
                .find("sky.exr: could not read the environment: it is 8 x 8 texels, not twice as wide "
                      "as high; give an equirectangular map"),
            std::string::npos)
      << refusal(rgb({8, 8}));
}

TEST_F(EquirectFile, TooLargeIsRefusedBeforeItIsDecoded) {
  EXPECT_NE(
      refusal(rgb({kMaxEquirectWidth + 2, kMaxEquirectWidth / 2 + 1})).find("and the kit reads up to 8192"),
      std::string::npos);
}

TEST_F(EquirectFile, WithABadTexelIsRefusedAtItsPlace) {
  for (const auto& [value, words] :
       {std::pair{std::numeric_limits<float>::quiet_NaN(), "is nan; radiance must be finite"},
        {std::numeric_limits<float>::infinity(), "is inf; radiance must be finite"},
        {-0.25F, "is -0.25; radiance must be finite and not negative"},
        {70000.0F, "is 70000, and the frame's images hold radiance up to 65504"}}) {
    Image image = rgb({8, 4});
    image.at(3, 2, 1) = value;
    EXPECT_NE(refusal(image).find(std::string("G at texel (3, 2) ") + words), std::string::npos)
        << refusal(image);
  }
}

TEST_F(EquirectFile, WithOtherChannelsIsRefused) {
  EXPECT_NE(refusal(Image({8, 4}, {"Y"})).find("the channel 'R' is missing"), std::string::npos)
      << refusal(Image({8, 4}, {"Y"}));
}

TEST_F(EquirectFile, ThatIsNotThereOrNoExrIsRefused) {
  const auto missing = readEquirect(folder_ / "none.exr");
  ASSERT_FALSE(missing);
  EXPECT_NE(sentence(missing.error()).find("none.exr: could not read the environment"), std::string::npos)
      << sentence(missing.error());
  const auto folder = readEquirect(folder_.path());
  EXPECT_FALSE(folder);
}

TEST(Equirect, LooksWhereItSays) {
  const Size size{360, 180};
  const auto at = [&](glm::vec3 direction) { return equirectFromDirection(direction, size); };
  EXPECT_LT(glm::distance(at({0, 0, -1}), glm::vec2(180, 90)), 1e-3F);
  EXPECT_LT(glm::distance(at({1, 0, 0}), glm::vec2(270, 90)), 1e-3F);
  EXPECT_LT(glm::distance(at({-1, 0, 0}), glm::vec2(90, 90)), 1e-3F);
  EXPECT_NEAR(at({0, 1, 0}).y, 0.0F, 1e-3F);
  EXPECT_NEAR(at({0, -1, 0}).y, 180.0F, 1e-3F);
}

TEST(Equirect, IsContinuousAcrossItsSeam) {
  Image image({16, 8}, {"R", "G", "B"});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      image.at(x, y) = static_cast<float>(std::min(x, 15 - x));
    }
  }
  const glm::vec3 left = sampleEquirect(image, glm::normalize(glm::vec3(-1e-4F, 0.1F, 1.0F)));
  const glm::vec3 right = sampleEquirect(image, glm::normalize(glm::vec3(1e-4F, 0.1F, 1.0F)));
  EXPECT_NEAR(left.r, right.r, 1e-3F);
  EXPECT_NEAR(left.r, 0.0F, 1e-3F);
}

}  // namespace
}  // namespace ssrkit
