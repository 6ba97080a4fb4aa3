#include "check/signatures.h"

#include <gtest/gtest.h>

#include <functional>

#include "check/ray_pairs.h"
#include "made_answers.h"
#include "not_finite.h"

namespace ssrkit {
namespace {

constexpr Size kSignatureSize{16, 16};

// The id of the signature of a tracer that gives `mistake(x, y, truth)` where the truth is `truth(x, y)`.
using TruthAt = std::function<RayHit(int x, int y)>;
using MistakeAt = std::function<RayHit(int x, int y, const RayHit& truth)>;

struct Made {
  Bench bench;
  RayPairs pairs;

  Made(const TruthAt& truth, const MistakeAt& mistake, Size size = kSignatureSize) {
    RayRecord yours{size, {}};
    RayRecord expected{size, {}};
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        expected.rays.push_back(truth(x, y));
        yours.rays.push_back(mistake(x, y, expected.rays.back()));
      }
    }
    Answer& answer = bench.add("hiz", std::move(yours));
    bench.setOracle(answer, std::move(expected));
    bench.setWorld(answer, 4.0F);
  }
  [[nodiscard]] std::string signature() {
    const Answer& answer = bench.answers.front();
    pairs = pairRays(Subject{"test", "made", &answer, bench.answers, ""}, {TruthKind::kOracle, ""});
    std::vector<RayPair> wrong;
    for (const RayPair& pair : pairs.pairs) {
      if (!sameAnswer(*pair.yours, *pair.expected)) {
        wrong.push_back(pair);
      }
    }
    const Signature* found = matchSignature(SignatureInput{pairs.pairs, wrong, answer});
    return found == nullptr ? "none" : found->id;
  }
};

// Rays of the upper half hit downwards, those of the lower half upwards, 6 rows away.
RayHit bothWays(int x, int y) {
  return hitAt(x, y < 8 ? y + 6 : y - 6);
}

RayHit moved(const RayHit& hit, int dx, int dy) {
  return hitAt(hit.texel_x + dx, hit.texel_y + dy);
}

TEST(Signatures, EveryHitOneRowOffIsATexelCentre) {
  EXPECT_EQ(Made(bothWays, [](int, int, const RayHit& t) { return moved(t, 0, 1); }).signature(),
            "texel-centre");
}

TEST(Signatures, HitsOneTexelPastInEveryDirectionAreAnOvershoot) {
  const auto past = [](int, int y, const RayHit& t) { return moved(t, 0, y < 8 ? 1 : -1); };
  EXPECT_EQ(Made(bothWays, past).signature(), "overshoot");
  Made strided(bothWays, [](int, int y, const RayHit& t) { return moved(t, 0, y < 8 ? 4 : -4); });
  EXPECT_EQ(strided.signature(), "none");
  strided.bench.answers.front().parameters.stride_px = 4;
  EXPECT_EQ(strided.signature(), "overshoot");
}

TEST(Signatures, MirroredRowsAreAFlip) {
  const auto truth = [](int x, int y) { return hitAt(x, (y * 5 + 3) % 16); };
  EXPECT_EQ(
      Made(truth, [](int, int, const RayHit& t) { return hitAt(t.texel_x, 15 - t.texel_y); }).signature(),
      "y-flip");
  EXPECT_EQ(Made([](int x, int y) { return hitAt((x * 5 + 3) % 16, (y + 8) % 16); },
                 [](int, int, const RayHit& t) { return hitAt(15 - t.texel_x, t.texel_y); })
                .signature(),
            "x-flip");
}

TEST(Signatures, HitsOnTheOwnTexelAreSelfHits) {
  EXPECT_EQ(Made(bothWays, [](int x, int y, const RayHit&) { return hitAt(x, y); }).signature(), "self-hit");
}

TEST(Signatures, HitsOnBackgroundAreNamed) {
  Made made(bothWays, [](int x, int y, const RayHit& t) { return y == 3 ? hitAt(x, 15) : t; });
  EXPECT_NE(made.signature(), "background-hit");
  for (int x = 0; x < 16; ++x) {
    made.bench.images.front().at(x, 15) = kInfinity;
  }
  EXPECT_EQ(made.signature(), "background-hit");
}

TEST(Signatures, LostRaysTowardTheCameraAreAnIntervalThatIsNotSwapped) {
  const auto lost = [](int, int, const RayHit&) { return without(RayClass::kOffscreen); };
  Made facing(bothWays, lost);  // mirrors that face the camera send every ray back
  EXPECT_EQ(facing.signature(), "toward-camera");
  Made level(bothWays, lost);  // a floor sends them on
  Image& normals = level.bench.images[1];
  for (std::size_t i = 0; i < normals.data.size(); i += 3) {
    normals.data[i + 1] = 1.0F;
    normals.data[i + 2] = 0.0F;
  }
  EXPECT_EQ(level.signature(), "never-hits");
}

TEST(Signatures, BudgetsThatAreSpentOrTakenForHits) {
  EXPECT_EQ(Made(bothWays, [](int, int y, const RayHit& t) { return y < 3 ? without(RayClass::kBudget) : t; })
                .signature(),
            "budget");
  Made as_hit([](int, int) { return without(RayClass::kBudget, 50); },
              [](int x, int, const RayHit&) { return hitAt(x, 3, 50); });
  as_hit.bench.answers.front().parameters.lookup_budget = 50;
  EXPECT_EQ(as_hit.signature(), "budget-as-hit");
}

TEST(Signatures, EverythingHits) {
  EXPECT_EQ(Made([](int, int) { return without(RayClass::kOffscreen); },
                 [](int x, int y, const RayHit&) { return hitAt(x, (y + 1) % 16); })
                .signature(),
            "always-hits");
}

TEST(Signatures, OnlyTheLastRowOrColumnAtAnOddSizeIsThePyramid) {
  const Size odd{15, 15};
  const auto truth = [](int x, int y) { return hitAt(x, y == 14 ? 3 : y < 7 ? 14 : 1); };
  const auto lost = [](int x, int, const RayHit& t) {
    return t.texel_y == 14 && x % 2 == 0 ? without(RayClass::kOffscreen) : t;
  };
  Made made(truth, lost, odd);
  Image& normals = made.bench.images[1];
  for (std::size_t i = 0; i < normals.data.size(); i += 3) {  // a floor: no ray comes back
    normals.data[i + 1] = 1.0F;
    normals.data[i + 2] = 0.0F;
  }
  EXPECT_EQ(made.signature(), "last-row-or-column");
}

TEST(Signatures, HitsThatFallShortAreLinearDepth) {
  const auto truth = [](int x, int y) { return hitAt(x, y < 8 ? 15 : 0); };
  const auto half_way = [](int x, int y, const RayHit& t) {
    return hitAt(x, (y + t.texel_y + (y < 8 ? 0 : 1)) / 2);
  };
  EXPECT_EQ(Made(truth, half_way).signature(), "linear-depth");
}

TEST(Signatures, ScatteredMistakesHaveNoName) {
  const auto scattered = [](int x, int y, const RayHit&) {
    return hitAt((x * 7 + y * 3) % 16, (x * 5 + y * 11) % 16);
  };
  EXPECT_EQ(Made(bothWays, scattered).signature(), "none");
  EXPECT_EQ(Made(bothWays, [](int, int, const RayHit& t) { return t; }).signature(), "none");
}

TEST(Signatures, ThreeRaysAreTooFewToTell) {
  EXPECT_EQ(Made(bothWays, [](int x, int y, const RayHit& t) { return y == 0 && x < 3 ? moved(t, 0, 1) : t; })
                .signature(),
            "none");
}

TEST(FailureMessage, SaysWhereWhatHowWideWhyAndHowToSeeItAgain) {
  Made made(bothWays, [](int, int y, const RayHit& t) { return y >= 10 ? moved(t, 0, 1) : t; });
  const CheckResult result = made.bench.check(expectation("metric = \"different_rays\""));
  EXPECT_EQ(outcomeName(result), "fail");
  for (const char* part :
       {"fail: test.different_rays made 16x16 gl-osmesa hiz", "yours     different_rays = 96 rays",
        "expected  <= 0 rays, against oracle (made.toml:",
        "96 of 256 rays (37.5 %), columns 0 to 15, rows 10 to 15", "96 x expected HIT, yours HIT",
        "(0, 10)  HIT (0, 5)  HIT (0, 4)  (+0, +1) px", "... and 86 more",
        "likely    all hits are off by the same texel", "again     ./ssrkit run"}) {
    EXPECT_NE(result.message.find(part), std::string::npos) << part << "\nnot in\n" << result.message;
  }
}

}  // namespace
}  // namespace ssrkit
