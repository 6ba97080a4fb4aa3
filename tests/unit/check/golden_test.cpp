#include "check/golden.h"

#include <gtest/gtest.h>

#include "../temporary_folder.h"
#include "base/atomic_file.h"
#include "check/judge.h"
#include "made_answers.h"

namespace ssrkit {
namespace {

const GoldenKey kKey = {.rasteriser = "llvmpipe",
                        .api = "OpenGL 4.5 core",
                        .driver = "llvmpipe (LLVM 15.0.6, 256 bits)",
                        .version = "Mesa 22.3.6",
                        .cpu_features = {"avx2"}};

Golden golden() {
  Golden made;
  made.note.subject = {
      .test = "t", .scene = "m1", .size = {2, 1}, .stage = "hiz", .case_name = "t_1m", .buffer = "composite"};
  made.note.key = kKey;
  made.note.who = "somebody";
  made.note.when = "2026-01-31T12:00:00Z";
  made.note.why = "the first one";
  made.note.hashes = {{"scene", "00ff"}};
  made.note.metrics = {{"t.finite", "0 pixels"}};
  made.image = Image({2, 1}, {"R", "G", "B"});
  made.image.data = {0.1F, 0.2F, 0.3F, 1e-8F, 65504.0F, -0.0F};
  return made;
}

class GoldenFiles : public ::testing::Test {
 protected:
  std::string refusal() {
    const auto loaded = loadGoldens(folder_.path(), "t", "m1");
    return loaded ? "" : sentence(loaded.error());
  }
  test::TemporaryFolder folder_;
};

TEST_F(GoldenFiles, ComeBackAsTheyWereWritten) {
  ASSERT_TRUE(writeGolden(folder_.path(), golden()));
  const auto loaded = loadGoldens(folder_.path(), "t", "m1");
  ASSERT_TRUE(loaded) << sentence(loaded.error());
  ASSERT_EQ(loaded->size(), 1U);
  const Golden& back = loaded->front();
  EXPECT_EQ(back.note.subject, golden().note.subject);
  EXPECT_EQ(back.note.key, kKey);
  EXPECT_EQ(back.note.why, "the first one");
  EXPECT_EQ(back.note.hashes, golden().note.hashes);
  EXPECT_EQ(back.note.metrics, golden().note.metrics);
  EXPECT_EQ(back.image.channels, golden().image.channels);  // not sorted, as EXR sorts them
  EXPECT_EQ(back.image.data, golden().image.data);
}

TEST_F(GoldenFiles, AreNamedByWhatTheyAreOf) {
  const std::filesystem::path file = goldenFile("root", golden().note);
  EXPECT_EQ(file.parent_path(), "root/t/m1/2x1");
  EXPECT_EQ(file.filename().string().substr(0, 28), "hiz.t_1m.composite.llvmpipe-");
}

TEST_F(GoldenFiles, NoneIsNoError) {
  const auto loaded = loadGoldens(folder_.path(), "t", "m1");
  ASSERT_TRUE(loaded) << sentence(loaded.error());
  EXPECT_TRUE(loaded->empty());
}

TEST_F(GoldenFiles, AnImageThatWasNotBlessedIsRefused) {
  ASSERT_TRUE(writeGolden(folder_.path(), golden()));
  Golden other = golden();
  other.image.data[0] = 0.5F;
  other.note.subject.buffer = "other";
  ASSERT_TRUE(writeGolden(folder_.path(), other));
  std::filesystem::copy_file(goldenFile(folder_.path(), other.note),
                             goldenFile(folder_.path(), golden().note),
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_NE(refusal().find("not the one that was blessed"), std::string::npos) << refusal();
}

TEST_F(GoldenFiles, ADamagedSidecarIsNamed) {
  ASSERT_TRUE(writeGolden(folder_.path(), golden()));
  const std::filesystem::path sidecar = goldenFile(folder_.path(), golden().note).replace_extension(".json");
  const std::string whole = *readFile(sidecar);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return text.replace(text.find(from), from.size(), to);
  };
  for (const auto& [damaged, word] :
       {std::pair(whole.substr(0, whole.size() / 2), "parse error"),
        std::pair(replaced("\"why\"", "\"wyh\""), "'wyh'"),
        std::pair(replaced("\"schema_version\": 1", "\"schema_version\": 9"), "schema"),
        std::pair(replaced("\"2x1\"", "\"2x\""), "size"), std::pair(replaced("\"2x1\"", "\"4x1\""), "4"),
        std::pair(replaced("\"who\": \"somebody\"", "\"who\": 7"), "type"),
        std::pair(std::string("[]"), "")}) {
    ASSERT_TRUE(writeFileAtomically(sidecar, damaged));
    const std::string text = refusal();
    EXPECT_NE(text.find(word), std::string::npos) << text;
    EXPECT_NE(text.find("hiz.t_1m.composite"), std::string::npos) << text;
  }
}

TEST(ChooseGolden, TakesTheVeryKeyFirst) {
  Golden kin = golden();
  kin.note.key.api = "Vulkan 1.3";
  const std::vector<Golden> goldens = {kin, golden()};
  EXPECT_EQ(chooseGolden(goldens, golden().note.subject, kKey, true), &goldens[1]);
  EXPECT_EQ(chooseGolden(goldens, golden().note.subject, kKey, false), &goldens[1]);
}

TEST(ChooseGolden, TakesTheSameRasterisersOnlyWhereThatWillDo) {
  const std::vector<Golden> goldens = {golden()};
  GoldenKey other = kKey;
  other.cpu_features = {"avx2", "avx512f"};
  EXPECT_EQ(chooseGolden(goldens, golden().note.subject, other, true), goldens.data());
  EXPECT_EQ(chooseGolden(goldens, golden().note.subject, other, false), nullptr);
  other.rasteriser = "swiftshader";
  EXPECT_EQ(chooseGolden(goldens, golden().note.subject, other, true), nullptr);
}

TEST(ChooseGolden, TakesNoOtherBuffers) {
  const std::vector<Golden> goldens = {golden()};
  const auto differs = [&](auto change) {
    GoldenSubject subject = golden().note.subject;
    change(subject);
    return chooseGolden(goldens, subject, kKey, true) == nullptr;
  };
  EXPECT_TRUE(differs([](GoldenSubject& subject) { subject.test = "u"; }));
  EXPECT_TRUE(differs([](GoldenSubject& subject) { subject.scene = "m2"; }));
  EXPECT_TRUE(differs([](GoldenSubject& subject) { subject.size.width = 1; }));
  EXPECT_TRUE(differs([](GoldenSubject& subject) { subject.stage = "dda"; }));
  EXPECT_TRUE(differs([](GoldenSubject& subject) { subject.case_name = ""; }));
  EXPECT_TRUE(differs([](GoldenSubject& subject) { subject.buffer = "lit"; }));
}

TEST(GoldenTruth, AKeyIsAnotherWhereAnythingThatMattersIs) {
  for (std::string GoldenKey::*part : {&GoldenKey::api, &GoldenKey::driver, &GoldenKey::version}) {
    GoldenKey other = kKey;
    other.*part += "x";
    EXPECT_NE(keyText(other), keyText(kKey));
  }
  GoldenKey other = kKey;
  other.cpu_features.clear();
  EXPECT_NE(keyText(other), keyText(kKey));
}

// A test of one frame's buffer "lit" against its golden, and the only check that it gives.
CheckResult judged(float drawn, const Answer* blessed) {
  const auto test = readExpectations(
      "[test]\nid = \"t\"\nabout = \"a\"\nscenes = [\"all\"]\n[[expect]]\nmetric = \"absolute_error\"\n"
      "buffer = \"lit\"\ntruth = \"golden\"\nmax = 0.1\n",
      "made.toml");
  EXPECT_TRUE(test) << sentence(test.error());
  Bench bench;
  Answer& frame = bench.add("", {{2, 2}, {}});
  frame.record = nullptr;
  bench.setImage(frame, "lit", drawn);
  const auto checks = judge(
      *test, "m1", bench.answers, [](const Answer&) { return ""; },
      [&](const Expectation&, const Answer&) { return blessed; });
  EXPECT_EQ(checks.size(), 1U);
  return checks.front();
}

TEST(GoldenTruth, IsHeldToItsTolerance) {
  Bench bench;
  Answer& blessed = bench.add("", {{2, 2}, {}});
  bench.setImage(blessed, "lit", 1.0F);
  EXPECT_EQ(outcomeName(judged(1.05F, &blessed)), "pass");
  EXPECT_EQ(outcomeName(judged(1.2F, &blessed)), "fail");
}

TEST(GoldenTruth, AMissingGoldenFailsAndSaysHowToBlessOne) {
  const CheckResult result = judged(1.0F, nullptr);
  EXPECT_EQ(outcomeName(result), "missing");
  EXPECT_TRUE(isFailure(result.outcome));
  EXPECT_NE(result.message.find("./ssrkit bless t --scene m1 --device gl-osmesa --why"), std::string::npos)
      << result.message;
}

TEST(GoldenTruth, BitsNeedAGoldenOfTheVeryKey) {
  EXPECT_FALSE(sameRasteriserWillDo(expectation("metric = \"identical\"\ntruth = \"golden\"\n")));
  EXPECT_TRUE(
      sameRasteriserWillDo(expectation("metric = \"hit_position_px\"\ntruth = \"golden\"\nmax = 0.01\n")));
}

}  // namespace
}  // namespace ssrkit
