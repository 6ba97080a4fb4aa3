// The rooflines' passes return what follows from their loops: a compiler that left work out would change it.
#include "spaces/roofline.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr Size kRooflineSize{16, 4};

class RooflineTest : public PassTest {
 protected:
  // The pass over depths that `is_negative` somewhere, which no G-buffer is.
  Image drawn(const std::string& shader, int count, const std::function<bool(int x, int y)>& is_negative) {
    begin();
    values_.set("size_px", glm::dvec2(kRooflineSize.width, kRooflineSize.height));
    values_.set("texel_uv", 1.0 / glm::dvec2(kRooflineSize.width, kRooflineSize.height));
    values_.set("roofline_count", count);
    give("dist_view",
         imageOf(
             kRooflineSize,
             [&](int x, int y) { return std::array<double, 4>{is_negative(x, y) ? -1.0 : 5.0}; }, 1),
         Format::kR32f);
    return draw(shader, kRooflineSize, Format::kR32f);
  }

  Image arithmetic(double scale, double add, int count) {
    begin();
    values_.set("roofline_scale", scale);
    values_.set("roofline_add", add);
    values_.set("roofline_count", count);
    return draw("bench_alu.frag", kRooflineSize, Format::kR32f);
  }
};

bool nowhere(int, int) {
  return false;
}

bool atEveryThird(int x, int y) {
  return (x + y) % 3 == 0;
}

TEST_P(RooflineTest, FetchesAreCountedInAGbuffer) {
  for (const std::string shader : {"bench_dependent_fetch.frag", "bench_fetch.frag"}) {
    EXPECT_EQ(
        followsFormula(
            drawn(shader, kRooflineFetchCount, nowhere), [](int, int) { return kRooflineFetchCount; }, 0.0),
        "")
        << shader;
  }
}

TEST_P(RooflineTest, EachReadSendsTheNextOneOn) {
  const auto gone = [](int x, int y) {
    double total = 0.0;
    for (int i = 0; i < kRooflineFetchCount; ++i) {
      const int step = atEveryThird(x, y) ? 2 : 1;
      total += step;
      x = (x + step) % kRooflineSize.width;
    }
    return total;
  };
  EXPECT_EQ(followsFormula(drawn("bench_dependent_fetch.frag", kRooflineFetchCount, atEveryThird), gone, 0.0),
            "");
}

TEST_P(RooflineTest, EveryReadIsMade) {
  const auto found = [](int x, int y) {
    double total = 0.0;
    for (int i = 0; i < kRooflineFetchCount; ++i) {
      total += atEveryThird((x + i) % kRooflineSize.width, y) ? 0.0 : 1.0;
    }
    return total;
  };
  EXPECT_EQ(followsFormula(drawn("bench_fetch.frag", kRooflineFetchCount, atEveryThird), found, 0.0), "");
}

TEST_P(RooflineTest, EveryMultiplyAddIsMade) {
  EXPECT_EQ(
      followsFormula(
          arithmetic(1.0, 0.25, kRooflineAluCount), [](int, int) { return 0.25 * kRooflineAluCount; }, 0.0),
      "");
  // A geometric series: 1 + 1/2 + ... + 2^-9.
  EXPECT_EQ(followsFormula(
                arithmetic(0.5, 1.0, 10), [](int, int) { return 2.0 - std::exp2(-9.0); }, 0.0),
            "");
}

TEST_P(RooflineTest, TheWriteIsTheRecordOfNoRay) {
  begin();
  const std::vector<Image> written =
      drawAll("bench_write.frag", kRooflineSize, {Format::kRg16i, Format::kRgba32f, Format::kRgba16ui});
  // The point, whose first channels are -1; images of integers are not read back here.
  EXPECT_EQ(followsFormula(
                written[1], [](int, int) { return -1.0; }, 0.0),
            "");
}

INSTANTIATE_TEST_SUITE_P(Each, RooflineTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
