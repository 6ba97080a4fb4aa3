// What a peer reads, in each form, against its closed form.
#include <limits>

#include "frame/peer.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

constexpr Size kPeerInputsSize{2, 1};
constexpr double kNear = 0.5;
constexpr double kFar = 64.0;
constexpr double kSurfaceDist = 4.0;  // of the first texel; the second is background

class PeerInputsTest : public PassTest {
 protected:
  std::vector<Image> inputs(PeerDepth depth, PeerNormal normal) {
    begin();
    values_.set("near_m", kNear);
    values_.set("far_m", kFar);
    values_.set("peer_depth_form", static_cast<int>(depth));
    values_.set("peer_normal_form", static_cast<int>(normal));
    const double background = std::numeric_limits<double>::infinity();
    give("dist_view",
         imageOf(
             kPeerInputsSize,
             [&](int x, int) { return std::array<double, 4>{x == 0 ? kSurfaceDist : background}; }, 1),
         Format::kR32f);
    give("normal_view", imageOf(kPeerInputsSize, [](int, int) {
           return std::array<double, 4>{0.0, -0.6, 0.8, 0.5};
         }));
    return drawAll("peer_inputs.frag", kPeerInputsSize, {Format::kR32f, Format::kRgba32f});
  }
};

TEST_P(PeerInputsTest, DepthIsToldInEveryForm) {
  const double window = kFar / (kFar - kNear) * (1.0 - kNear / kSurfaceDist);
  const auto holds = [&](PeerDepth depth, double surface, double background) {
    const Image told = inputs(depth, PeerNormal::kSigned).front();
    EXPECT_NEAR(told.data[0], surface, 1e-6);
    EXPECT_EQ(told.data[1], static_cast<float>(background));
  };
  holds(PeerDepth::kDistView, kSurfaceDist, std::numeric_limits<double>::infinity());
  holds(PeerDepth::kViewZ, -kSurfaceDist, -1e30);
  holds(PeerDepth::kWindow, window, 1.0);
  holds(PeerDepth::kWindowReversed, 1.0 - window, 0.0);
  holds(PeerDepth::kLinear01, kSurfaceDist / kFar, 1.0);
}

TEST_P(PeerInputsTest, NormalIsToldInEveryForm) {
  const auto holds = [&](PeerNormal normal, double y, double z) {
    const Image told = inputs(PeerDepth::kDistView, normal).back();
    EXPECT_NEAR(told.data[1], y, 1e-6);
    EXPECT_NEAR(told.data[2], z, 1e-6);
  };
  holds(PeerNormal::kSigned, -0.6, 0.8);
  holds(PeerNormal::kUnsigned, 0.2, 0.9);
  holds(PeerNormal::kForward, -0.6, -0.8);
}

INSTANTIATE_TEST_SUITE_P(Each, PeerInputsTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
