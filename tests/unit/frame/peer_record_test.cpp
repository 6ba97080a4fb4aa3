// What becomes of a peer's answer: where there is no ray, or one into its surface, its hit counts for
// nothing.
#include <limits>

#include "frame/peer.h"
#include "pass_test.h"

namespace ssrkit {
namespace {

// One row: a mirror, one whose shading normal is bent so far that its ray runs below the surface, a surface
// that mirrors nothing, and background.
constexpr Size kPeerRecordSize{4, 1};

class PeerRecordTest : public PassTest {
 protected:
  // hit_texel, hit_point, ray_work of a peer that says: hit in the middle of the third texel, after 7
  // lookups.
  std::vector<Image> recordOfHits() {
    begin();
    values_.set("size_px", glm::dvec2(kPeerRecordSize.width, kPeerRecordSize.height));
    values_.set("px_scale", glm::dvec2(2.0, -2.0));
    values_.set("px_offset", glm::dvec2(2.0, 0.5));
    values_.set("view_per_px", glm::dvec2(0.5, -0.5));
    values_.set("near_m", 0.1);
    values_.set("thickness_m", 1e30);
    values_.set("thickness_rel", 0.0);
    values_.set("max_distance_m", 1e30);
    values_.set("origin_bias", 0.0);
    values_.set("lookup_budget", 60000);
    values_.set("peer_answer_form", static_cast<int>(PeerAnswer::kTexel));
    values_.set("peer_hit_channel", 3);
    values_.set("peer_lookups_channel", 2);
    give("dist_view",
         imageOf(
             kPeerRecordSize,
             [](int x, int) {
               return std::array<double, 4>{x == 3 ? std::numeric_limits<double>::infinity() : 4.0};
             },
             1),
         Format::kR32f);
    give("normal_view", imageOf(kPeerRecordSize, [](int x, int) {
           return std::array{0.0, 0.6, 0.8, x == 1 ? -0.1 : 0.8};
         }));
    give("material", imageOf(kPeerRecordSize, [](int x, int) {
           return std::array{1.0, 0.0, x == 2 ? 0.0 : 1.0, 0.0};
         }));
    give("peer_answer", imageOf(kPeerRecordSize, [](int, int) { return std::array{2.0, 0.0, 7.0, 1.0}; }));
    return drawAll("peer_record.frag", kPeerRecordSize,
                   {Format::kRg16i, Format::kRgba32f, Format::kRgba16ui});
  }
};

TEST_P(PeerRecordTest, AHitCountsOnlyWhereTheKitHasARay) {
  const std::vector<Image> record = recordOfHits();
  const auto holds = [&](int x, RayClass ray_class, float hit_x, float lookups) {
    EXPECT_EQ(record[2].at(x, 0, 0), static_cast<float>(ray_class)) << x;
    EXPECT_EQ(record[0].at(x, 0, 0), hit_x) << x;
    EXPECT_EQ(record[1].at(x, 0, 0), hit_x < 0.0F ? -1.0F : hit_x + 0.5F) << x;
    EXPECT_EQ(record[2].at(x, 0, 1), lookups) << x;
  };
  holds(0, RayClass::kHit, 2.0F, 7.0F);
  holds(1, RayClass::kIntoSurface, -1.0F, 0.0F);
  holds(2, RayClass::kMasked, -1.0F, 0.0F);
  holds(3, RayClass::kBackground, -1.0F, 0.0F);
}

INSTANTIATE_TEST_SUITE_P(Each, PeerRecordTest, testing::Values("gl-osmesa", "vk-lavapipe"), deviceTestName);

}  // namespace
}  // namespace ssrkit
