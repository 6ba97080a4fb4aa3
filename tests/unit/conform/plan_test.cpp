#include "conform/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace ssrkit {
namespace {

TestFile testFile(const std::string& id, std::vector<std::string> scenes) {
  TestFile test;
  test.id = id;
  test.scenes = std::move(scenes);
  test.sizes = {{64, 36}, {33, 17}};
  return test;
}

MatrixAxes axes() {
  return {
      .built_in_scenes = {"m1", "m2", "clutter"}, .scenes = {}, .devices = {"gl-a", "vk-b"}, .size = {8, 4}};
}

std::vector<std::string> idsOf(const std::vector<Cell>& cells) {
  std::vector<std::string> ids;
  std::ranges::transform(cells, std::back_inserter(ids), cellId);
  return ids;
}

// Two tests: 3 scenes and 1, two sizes, two devices.
std::vector<Cell> sixteenCells() {
  const std::vector<TestFile> tests = {testFile("a.bits", {"all"}), testFile("b.form", {"m1"})};
  return matrix(tests, axes());
}

TEST(Plan, CellsAreTestsTimesScenesTimesSizesTimesDevices) {
  const auto ids = idsOf(sixteenCells());
  ASSERT_EQ(16U, ids.size());
  EXPECT_EQ("a.bits/m1/64x36/gl-a", ids.front());
  EXPECT_EQ("a.bits/m1/64x36/vk-b", ids[1]);
  EXPECT_EQ("a.bits/m1/33x17/gl-a", ids[2]);
  EXPECT_EQ("b.form/m1/33x17/vk-b", ids.back());
  EXPECT_EQ(16U, std::set(ids.begin(), ids.end()).size());
}

TEST(Plan, ATestsOwnDevicesAndTheRunsSizeAndScenesAreKept) {
  TestFile test = testFile("t", {"all"});
  test.sizes.clear();
  test.devices = {"vk-b"};
  MatrixAxes some = axes();
  some.scenes = {"clutter", "mine"};
  const std::vector<TestFile> tests = {test, testFile("u", {"m1"})};
  EXPECT_EQ((std::vector<std::string>{"t/clutter/8x4/vk-b", "t/mine/8x4/vk-b"}), idsOf(matrix(tests, some)));
}

TEST(Plan, FiltersAddAndExcludesTakeAway) {
  const auto kept =
      select(sixteenCells(), {.filters = {"b.form", "*/clutter/33x17"}, .excludes = {"*/vk-b"}});
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(
      (std::vector<std::string>{"a.bits/clutter/33x17/gl-a", "b.form/m1/64x36/gl-a", "b.form/m1/33x17/gl-a"}),
      idsOf(*kept));
}

TEST(Plan, AGlobThatMatchesNothingIsAnErrorThatNamesTheNearest) {
  const auto filtered = select(sixteenCells(), {.filters = {"a.bits", "b.fonm"}});
  ASSERT_FALSE(filtered.has_value());
  EXPECT_NE(std::string::npos, sentence(filtered.error()).find("did you mean 'b.form'?"))
      << sentence(filtered.error());
  EXPECT_FALSE(select(sixteenCells(), {.excludes = {"nothing"}}).has_value());
  EXPECT_FALSE(select(sixteenCells(), {.excludes = {"*"}}).has_value()) << "no cell is left";
}

TEST(Plan, AShuffleIsTheSeedsAndKeepsGroupsTogether) {
  const auto plain = select(sixteenCells(), {});
  const auto first = select(sixteenCells(), {.shuffle_seed = 7});
  const auto again = select(sixteenCells(), {.shuffle_seed = 7});
  const auto other = select(sixteenCells(), {.shuffle_seed = 8});
  EXPECT_EQ(idsOf(*first), idsOf(*again));
  EXPECT_NE(idsOf(*first), idsOf(*other));
  EXPECT_NE(idsOf(*first), idsOf(*plain));
  EXPECT_EQ(8U, groupsOf(*first).size()) << "two devices each, side by side";
  auto sorted = idsOf(*first);
  auto sorted_plain = idsOf(*plain);
  std::ranges::sort(sorted);
  std::ranges::sort(sorted_plain);
  EXPECT_EQ(sorted_plain, sorted);
}

TEST(Plan, AShuffledPartKeepsTheOrderOfTheWhole) {
  auto whole = idsOf(*select(sixteenCells(), {.shuffle_seed = 7}));
  const auto part = idsOf(*select(sixteenCells(), {.filters = {"a.bits"}, .shuffle_seed = 7}));
  std::erase_if(whole, [](const std::string& id) { return id.starts_with("b."); });
  EXPECT_EQ(whole, part);
}

TEST(Plan, ShardsAreDisjointAndTogetherTheWhole) {
  std::vector<TestFile> tests;
  tests.reserve(40);
  for (int i = 0; i < 40; ++i) {
    tests.push_back(testFile("t" + std::to_string(i), {"all"}));
  }
  const auto cells = matrix(tests, axes());
  std::multiset<std::string> united;
  for (int index = 1; index <= 3; ++index) {
    const auto part = idsOf(cellsOfShard(cells, {index, 3}));
    EXPECT_GT(part.size(), cells.size() / 5) << "about a third each";
    united.insert(part.begin(), part.end());
  }
  const auto ids = idsOf(cells);
  EXPECT_EQ(std::multiset<std::string>(ids.begin(), ids.end()), united);
}

TEST(Plan, AnAddedTestMovesNoOtherCell) {
  const std::vector<TestFile> longer = {testFile("a.aaa", {"all"}), testFile("a.bits", {"all"}),
                                        testFile("b.form", {"m1"})};
  auto after = idsOf(cellsOfShard(matrix(longer, axes()), {1, 3}));
  std::erase_if(after, [](const std::string& id) { return id.starts_with("a.aaa"); });
  EXPECT_EQ(idsOf(cellsOfShard(sixteenCells(), {1, 3})), after);
}

}  // namespace
}  // namespace ssrkit
