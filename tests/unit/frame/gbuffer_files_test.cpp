#include "frame/gbuffer_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "image/exr.h"
#include "spaces/camera_json.h"

namespace ssrkit {
namespace {

class GbufferFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("ssrkit-gbuffer-" + std::to_string(getpid()) + "-" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    camera_ = {.size = {4, 3},
               .clip_from_view = perspective(1.0, 4.0 / 3.0, 0.1, 100.0),
               .view_from_world = glm::dmat4(1.0),
               .near_m = 0.1,
               .far_m = 100.0};
    dist_view_ = Image(camera_.size, {"Z"});
    std::fill(dist_view_.data.begin(), dist_view_.data.end(), 5.0F);
    normal_view_ = Image(camera_.size, {"R", "G", "B"});
    for (std::size_t texel = 0; texel < normal_view_.texelCount(); ++texel) {
      normal_view_.data[3 * texel + 2] = 1.0F;
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write() const {
    ASSERT_TRUE(writeFileAtomically(folder_ / "camera.json", toJson(camera_)).has_value());
    ASSERT_TRUE(writeExr(folder_ / "dist_view.exr", dist_view_).has_value());
    ASSERT_TRUE(writeExr(folder_ / "normal_view.exr", normal_view_).has_value());
  }
  // The sentence that reading ends with; empty on success.
  [[nodiscard]] std::string refusal() const {
    const auto files = readGbuffer(folder_);
    return files ? "" : sentence(files.error());
  }

  std::filesystem::path folder_;
  Camera camera_;
  Image dist_view_;
  Image normal_view_;
};

TEST_F(GbufferFilesTest, NeedOnlyDepthAndNormals) {
  dist_view_.at(1, 2) = std::numeric_limits<float>::infinity();
  write();
  const auto files = readGbuffer(folder_);
  ASSERT_TRUE(files.has_value()) << sentence(files.error());
  EXPECT_EQ(files->name, folder_.filename().string());
  EXPECT_EQ(files->camera.size, camera_.size);
  EXPECT_EQ(files->images.size(), 2U);
  EXPECT_TRUE(std::isinf(files->images.at("dist_view").at(1, 2)));
}

TEST_F(GbufferFilesTest, AreFoundInTheFolderGbufferToo) {
  write();
  std::filesystem::create_directories(folder_ / "gbuffer");
  std::filesystem::rename(folder_ / "dist_view.exr", folder_ / "gbuffer" / "dist_view.exr");
  EXPECT_EQ(refusal(), "");
}

TEST_F(GbufferFilesTest, TakeNormalsUnderTheNamesXYZ) {
  normal_view_.channels = {"X", "Y", "Z"};
  write();
  EXPECT_EQ(refusal(), "");
}

TEST_F(GbufferFilesTest, RefuseAMissingFolder) {
  const auto files = readGbuffer(folder_ / "nowhere");
  ASSERT_FALSE(files.has_value());
  EXPECT_NE(sentence(files.error()).find("there is no such folder"), std::string::npos);
}

TEST_F(GbufferFilesTest, RefuseWithoutACamera) {
  write();
  std::filesystem::remove(folder_ / "camera.json");
  EXPECT_NE(refusal().find("camera.json is missing"), std::string::npos);
}

TEST_F(GbufferFilesTest, RefuseWithoutDepth) {
  write();
  std::filesystem::remove(folder_ / "dist_view.exr");
  EXPECT_NE(refusal().find("dist_view.exr is missing"), std::string::npos);
}

TEST_F(GbufferFilesTest, RefuseAnotherSizeThanTheCameras) {
  dist_view_ = Image({5, 3}, {"Z"});
  write();
  EXPECT_NE(refusal().find("5 x 3"), std::string::npos) << refusal();
}

TEST_F(GbufferFilesTest, RefuseChannelsThatAreNoNormal) {
  normal_view_ = Image(camera_.size, {"U", "V"});
  write();
  EXPECT_NE(refusal().find("the image has the channels U and V"), std::string::npos) << refusal();
}

TEST_F(GbufferFilesTest, NameTheTexelOfABadDepth) {
  for (const float bad : {0.0F, -2.0F, std::nanf("")}) {
    dist_view_.at(3, 1) = bad;
    write();
    EXPECT_NE(refusal().find("at texel (3, 1)"), std::string::npos) << refusal();
  }
}

TEST_F(GbufferFilesTest, NameTheTexelOfANormalWithoutLength) {
  normal_view_.at(2, 0, 2) = 0.0F;
  write();
  EXPECT_NE(refusal().find("normal_view has length 0 at texel (2, 0)"), std::string::npos) << refusal();
}

TEST_F(GbufferFilesTest, LetBackgroundHaveNoNormal) {
  normal_view_.at(2, 0, 2) = 0.0F;
  dist_view_.at(2, 0) = std::numeric_limits<float>::infinity();
  write();
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace ssrkit
