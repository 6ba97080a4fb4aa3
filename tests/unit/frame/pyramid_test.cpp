// Every texel of every level, in both layouts, against the least and greatest of its declared cover set.
#include "frame/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <random>
#include <string>

#include "../kit_shaders.h"
#include "frame/image_transfer.h"
#include "frame_device.h"
#include "infinity.h"

namespace ssrkit {
namespace {

struct Depths {
  float least = kInfinity;
  float greatest = 0.0F;
};

// A cell of level m covers the texels (x, y) with x >> m and y >> m equal to it; background has no column.
Depths coverSet(const Image& dist_view, int cell_x, int cell_y, int level) {
  Depths depths;
  for (int y = 0; y < dist_view.size.height; ++y) {
    for (int x = 0; x < dist_view.size.width; ++x) {
      const float dist = dist_view.at(x, y);
      if (x >> level == cell_x && y >> level == cell_y && !std::isinf(dist)) {
        depths.least = std::min(depths.least, dist);
        depths.greatest = std::max(depths.greatest, dist);
      }
    }
  }
  return depths;
}

Image randomDepths(Size size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> metres(0.5F, 50.0F);
  Image dist_view(size, {"Z"});
  for (float& dist : dist_view.data) {
    dist = metres(random);
    if (dist > 40.0F) {
      dist = kInfinity;
    }
  }
  // The nearest of all stands in the last row and column, where pyramids for even sizes lose it.
  dist_view.at(size.width - 1, size.height - 1) = 0.25F;
  return dist_view;
}

// As gbuffer.frag writes it.
Image rangesOf(const Image& dist_view) {
  Image ranges(dist_view.size, {"X", "Y"});
  for (std::size_t i = 0; i < dist_view.data.size(); ++i) {
    const float dist = dist_view.data[i];
    ranges.data[2 * i] = dist;
    ranges.data[2 * i + 1] = std::isinf(dist) ? 0.0F : dist;
  }
  return ranges;
}

// An atlas as the G-buffer's rasteriser leaves it: the base in its corner, and elsewhere what is of no use.
Image rasterisedAtlas(const Image& dist_view, int max_mip) {
  Image atlas(atlasSize(dist_view.size, max_mip), {"X", "Y"});
  std::ranges::fill(atlas.data, 55.0F);
  const Image ranges = rangesOf(dist_view);
  for (int y = 0; y < dist_view.size.height; ++y) {
    for (int x = 0; x < dist_view.size.width; ++x) {
      for (std::size_t channel = 0; channel < 2; ++channel) {
        atlas.at(x, y, channel) = ranges.at(x, y, channel);
      }
    }
  }
  return atlas;
}

Image uniformDepths(Size size) {
  Image dist_view(size, {"Z"});
  std::ranges::fill(dist_view.data, 77.0F);
  return dist_view;
}

class PyramidTest : public FrameDeviceTest {
 protected:
  void check(Size size, int max_mip, PyramidLayout layout) {
    const Image dist_view = randomDepths(size);
    check("dist_view", dist_view, std::nullopt, dist_view, max_mip, layout);
  }

  // Builds it from the image `source`, which holds `dist_view`, and holds it to the cover sets of `covered`.
  // With `rasterised` there is a `dist_range` with that for its base beside it.
  void check(const std::string& source, const Image& dist_view, const std::optional<Image>& rasterised,
             const Image& covered, int max_mip, PyramidLayout layout) {
    const Size size = dist_view.size;
    Programs programs(*device_, target_);
    const CompileSettings settings{.shader_root = kitShaders()};
    const auto base = programs.get(pyramidBasePass(), settings);
    const auto reduce = programs.get(pyramidReducePass(), settings);
    ASSERT_TRUE(base.has_value() && reduce.has_value());
    FrameImages images(*device_, size);
    const auto uploaded = images.get(source);
    ASSERT_TRUE(uploaded.has_value());
    ASSERT_TRUE(uploadImage(*device_, **uploaded, dist_view, {}).has_value());
    if (rasterised) {
      const Image atlas = rasterisedAtlas(*rasterised, max_mip);
      const auto range =
          images.getSized({.name = "dist_range", .format = Format::kRg32f, .size = atlas.size});
      ASSERT_TRUE(range.has_value());
      ASSERT_TRUE(uploadImage(*device_, **range, atlas, {}).has_value());
    }
    UniformValues values;
    values.set("size_px", glm::dvec2(size.width, size.height));
    values.set("texel_uv", 1.0 / glm::dvec2(size.width, size.height));
    const auto time = buildPyramid(*device_, {*base, *reduce}, layout, max_mip, source, images, values);
    ASSERT_TRUE(time.has_value()) << sentence(time.error());
    const Size padded = paddedSize(size, max_mip);
    for (int level = 0; level <= max_mip; ++level) {
      const bool is_atlas = layout == PyramidLayout::kAtlas;
      const auto bytes =
          device_->read(*images.find(pyramidImage(layout, max_mip, source, images)), is_atlas ? 0 : level);
      ASSERT_TRUE(bytes.has_value());
      const int row_length = is_atlas ? padded.width : padded.width >> level;
      const int first_row = is_atlas ? 2 * padded.height - (2 * padded.height >> level) : 0;
      for (int y = 0; y < padded.height >> level; ++y) {
        for (int x = 0; x < padded.width >> level; ++x) {
          float stored[2];
          std::memcpy(stored,
                      bytes->data() + 8 * (static_cast<std::size_t>(first_row + y) *
                                               static_cast<std::size_t>(row_length) +
                                           static_cast<std::size_t>(x)),
                      sizeof(stored));
          const Depths expected = coverSet(covered, x, y, level);
          ASSERT_EQ(stored[0], expected.least) << "level " << level << " cell " << x << ", " << y;
          ASSERT_EQ(stored[1], expected.greatest) << "level " << level << " cell " << x << ", " << y;
        }
      }
    }
  }
};

TEST_P(PyramidTest, CoversEveryTexelAtEverySize) {
  for (const Size size : {Size{1, 1}, {2, 2}, {3, 3}, {5, 7}, {16, 16}, {33, 17}, {127, 63}, {1, 40}}) {
    for (const PyramidLayout layout : {PyramidLayout::kMips, PyramidLayout::kAtlas}) {
      SCOPED_TRACE(testing::Message() << size.width << "x" << size.height);
      check(size, 0, layout);
      check(size, 3, layout);
      check(size, 6, layout);
    }
  }
}

// The padding of a size that is no whole number of cells is drawn all the same.
TEST_P(PyramidTest, TakesTheBaseThatTheGbufferRasterised) {
  for (const Size size : {Size{1, 1}, {8, 8}, {5, 7}, {16, 9}, {33, 16}}) {
    for (const PyramidLayout layout : {PyramidLayout::kMips, PyramidLayout::kAtlas}) {
      SCOPED_TRACE(testing::Message() << size.width << "x" << size.height);
      for (const int max_mip : {0, 3}) {
        check("dist_view", uniformDepths(size), randomDepths(size), randomDepths(size), max_mip, layout);
      }
    }
  }
}

TEST_P(PyramidTest, StandsWhereTheBaseIsIfThatIsAnAtlasOfItsLevels) {
  FrameImages images(*device_, {33, 17});
  ASSERT_TRUE(
      images.getSized({.name = "dist_range", .format = Format::kRg32f, .size = atlasSize({33, 17}, 4)}));
  EXPECT_EQ(pyramidImage(PyramidLayout::kAtlas, 4, "dist_view", images), "dist_range");
  EXPECT_EQ(pyramidImage(PyramidLayout::kAtlas, 3, "dist_view", images), "pyramid_atlas");
  EXPECT_EQ(pyramidImage(PyramidLayout::kAtlas, 4, "dist_unpacked", images), "pyramid_atlas");
  EXPECT_EQ(pyramidImage(PyramidLayout::kMips, 4, "dist_view", images), "pyramid");
}

TEST_P(PyramidTest, TakesNoRasterisedBaseForAnotherDepth) {
  const Size size{33, 17};
  check("dist_unpacked", randomDepths(size), uniformDepths(size), randomDepths(size), 3,
        PyramidLayout::kAtlas);
}

TEST_P(PyramidTest, RefusesAnAtlasOverTheLimitWithTheWayOut) {
  FrameImages images(*device_, {64, 9000});
  UniformValues values;
  const auto time = buildPyramid(*device_, {}, PyramidLayout::kAtlas, 3, "dist_view", images, values);
  ASSERT_FALSE(time.has_value());
  EXPECT_NE(sentence(time.error()).find("--param form=textbook"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Each, PyramidTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
