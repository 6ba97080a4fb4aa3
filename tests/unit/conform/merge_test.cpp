#include "conform/merge.h"

#include <gtest/gtest.h>

#include "../temporary_folder.h"
#include "conform/cell_store.h"
#include "made_records.h"

namespace ssrkit {
namespace {

class Merge : public ::testing::Test {
 protected:
  // A folder with the cells of one of two shards, but for those left out.
  std::filesystem::path shard(const std::string& name, int index, const std::string& left_out = "") {
    const CellStore store(folder_.path() / name);
    const Manifest manifest = madeManifest({index, 2});
    EXPECT_TRUE(store.write(manifest).has_value());
    for (const std::string& id : ownCells(manifest)) {
      if (id != left_out) {
        EXPECT_TRUE(store.write(madeRecord(id, index == 1 ? Outcome::kPass : Outcome::kFail)).has_value());
      }
    }
    return folder_.path() / name;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Merge, TwoShardsAreTheWholeInThePlansOrder) {
  const std::vector<std::filesystem::path> folders = {shard("two", 2), shard("one", 1)};
  const auto merged = merge(folders);
  ASSERT_TRUE(merged.has_value()) << sentence(merged.error());
  EXPECT_TRUE(merged->notes.empty());
  EXPECT_EQ((Shard{1, 1}), merged->manifest.shard);
  EXPECT_EQ(merged->manifest.cells, ownCells(merged->manifest));
  ASSERT_EQ(4U, merged->records.size());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(merged->manifest.cells[i], merged->records[i].id);
  }
  EXPECT_EQ(Outcome::kPass, outcomeOf(merged->records[0]));
  EXPECT_EQ(Outcome::kFail, outcomeOf(merged->records[1]));
}

TEST_F(Merge, AMissingShardIsNamedAndItsCellsAreMissing) {
  const std::vector<std::filesystem::path> folders = {shard("one", 1)};
  const auto merged = merge(folders);
  ASSERT_TRUE(merged.has_value());
  ASSERT_EQ(1U, merged->notes.size());
  EXPECT_EQ("shard 2/2 is missing, with 2 cells", merged->notes[0]);
  EXPECT_EQ(Outcome::kMissing, outcomeOf(merged->records[1]));
  EXPECT_EQ("gl-a", merged->records[1].checks[0].device);
  EXPECT_EQ((Size{64, 36}), merged->records[1].checks[0].size);
  EXPECT_EQ(Outcome::kPass, outcomeOf(merged->records[3]));
}

TEST_F(Merge, AnUnfinishedCellIsMissingAndItsShardNamed) {
  const std::vector<std::filesystem::path> folders = {shard("one", 1), shard("two", 2, "t/m3/64x36/gl-a")};
  const auto merged = merge(folders);
  ASSERT_TRUE(merged.has_value());
  ASSERT_EQ(1U, merged->notes.size());
  EXPECT_NE(std::string::npos, merged->notes[0].find("shard 2/2"));
  EXPECT_NE(std::string::npos, merged->notes[0].find("1 of its 2 cells"));
  EXPECT_EQ(Outcome::kMissing, outcomeOf(merged->records[2]));
}

TEST_F(Merge, ADamagedCellIsMissingWithItsFile) {
  const std::vector<std::filesystem::path> folders = {shard("one", 1), shard("two", 2)};
  const auto file = CellStore(folders[1]).fileOf("t/m3/64x36/gl-a");
  std::filesystem::resize_file(file, 10);
  const auto merged = merge(folders);
  ASSERT_TRUE(merged.has_value());
  EXPECT_EQ(Outcome::kMissing, outcomeOf(merged->records[2]));
  EXPECT_NE(std::string::npos, merged->records[2].checks[0].message.find(file.string()));
}

TEST_F(Merge, AShardThatComesTwiceIsRefusedWithBothFolders) {
  const std::vector<std::filesystem::path> folders = {shard("one", 1), shard("again", 1)};
  const auto merged = merge(folders);
  ASSERT_FALSE(merged.has_value());
  const std::string text = sentence(merged.error());
  EXPECT_NE(std::string::npos, text.find("shard 1/2 comes twice"));
  EXPECT_NE(std::string::npos, text.find(folders[0].string()));
  EXPECT_NE(std::string::npos, text.find(folders[1].string()));
}

TEST_F(Merge, FoldersOfDifferentPlansAreRefused) {
  const auto one = shard("one", 1);
  const auto other = shard("other", 2);
  Manifest manifest = madeManifest({2, 2});
  manifest.cells[3] = "t/m5/64x36/gl-a";
  ASSERT_TRUE(CellStore(other).write(manifest).has_value());
  const std::vector<std::filesystem::path> folders = {one, other};
  const auto merged = merge(folders);
  ASSERT_FALSE(merged.has_value());
  EXPECT_EQ(other.string(), merged.error().where);
  EXPECT_FALSE(merge({}).has_value());
}

TEST_F(Merge, ACellUnderTwoShardsNamesIsTakenFromItsOwn) {
  const std::vector<std::filesystem::path> folders = {shard("one", 1), shard("two", 2)};
  // A stray result of an older run of more cells.
  ASSERT_TRUE(CellStore(folders[0]).write(madeRecord("t/m2/64x36/gl-a", Outcome::kPass)).has_value());
  EXPECT_EQ(Outcome::kFail, outcomeOf(merge(folders)->records[1]));
}

TEST_F(Merge, FailedCellsAreTheFailedAndTheUnfinished) {
  EXPECT_EQ((std::vector<std::string>{}), *failedCells(shard("one", 1)));
  EXPECT_EQ((std::vector<std::string>{"t/m2/64x36/gl-a", "t/m3/64x36/gl-a"}), *failedCells(shard("two", 2)));
  EXPECT_EQ((std::vector<std::string>{"t/m4/64x36/gl-a"}), *failedCells(shard("part", 1, "t/m4/64x36/gl-a")));
  EXPECT_FALSE(failedCells(folder_.path() / "nowhere").has_value());
}

}  // namespace
}  // namespace ssrkit
