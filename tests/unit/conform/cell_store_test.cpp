#include "conform/cell_store.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "../temporary_folder.h"
#include "made_records.h"

namespace ssrkit {
namespace {

CheckResult fullCheck() {
  CheckResult check = madeCheck("t.rays", Outcome::kFail);
  check.case_name = "t_0.3m";
  check.value = 0.1 + 0.2;  // needs all 17 digits
  check.min = -std::numeric_limits<double>::infinity();
  check.interval = {1.0 / 3.0, std::numeric_limits<double>::infinity()};
  check.compared = 12345678901;
  check.parameters = TraceParameters{.thickness_m = 0.1, .max_mip = -1, .form = TracerForm::kTextbook};
  check.remark = "two\nlines, \"quoted\"";
  check.histogram = {{"HIT", 3}, {"OFFSCREEN", 0}};
  check.message = "fail: \xC3\xA9";
  check.repro = "./ssrkit conform --filter t";
  check.finding_map = FindingMap{{3, 2}, {0, 255, 10, 9, 16, 171}};
  return check;
}

TEST(CellRecord, SurvivesItsJsonWithEveryBit) {
  const CellRecord record{
      .id = "t/m1/64x36/gl-a", .inputs = "ab12", .time_s = 1.0 / 7.0, .attempts = 3, .checks = {fullCheck()}};
  const auto read = readCellRecord(toJson(record), "file");
  ASSERT_TRUE(read.has_value()) << sentence(read.error());
  EXPECT_EQ(toJson(record), toJson(*read));
  EXPECT_EQ(record.time_s, read->time_s);
  const CheckResult& check = read->checks.at(0);
  EXPECT_EQ(0.1 + 0.2, check.value);
  EXPECT_EQ(-std::numeric_limits<double>::infinity(), check.min);
  EXPECT_EQ(0.0, check.max);
  ASSERT_TRUE(check.interval.has_value());
  EXPECT_EQ(1.0 / 3.0, check.interval->first);
  EXPECT_EQ(12345678901U, check.compared);
  EXPECT_EQ("two\nlines, \"quoted\"", check.remark);
  EXPECT_EQ("OFFSCREEN", check.histogram.at(1).label);
  EXPECT_EQ((Size{64, 36}), check.size);
  EXPECT_EQ("t_0.3m", check.case_name);
  EXPECT_EQ(fullCheck().parameters, check.parameters);
  ASSERT_TRUE(check.finding_map.has_value());
  EXPECT_EQ((Size{3, 2}), check.finding_map->size);
  EXPECT_EQ((std::vector<std::uint8_t>{0, 255, 10, 9, 16, 171}), check.finding_map->dots);
}

TEST(CellRecord, AMapOfAnotherSizeIsDamage) {
  const CellRecord record{.id = "t/m1/64x36/gl-a", .checks = {fullCheck()}};
  for (const char* const dots : {"00ff0a0910", "00ff0a0910abcd", "00ff0a0910ag", "00ff0a0910a"}) {
    std::string json = toJson(record);
    json.replace(json.find("00ff0a0910ab"), 12, dots);
    EXPECT_FALSE(readCellRecord(json, "file").has_value()) << dots;
  }
}

TEST(CellRecord, ARunKeepsTheMapsOfItsFirstHundredFailures) {
  std::size_t kept = 98;
  CellRecord record{.id = "t/m1/64x36/gl-a",
                    .checks = {fullCheck(), madeCheck("t.b", Outcome::kPass), fullCheck(), fullCheck()}};
  dropMaps(record, kept);
  EXPECT_TRUE(record.checks[2].finding_map.has_value());
  EXPECT_FALSE(record.checks[3].finding_map.has_value());
}

TEST(CellRecord, KeepsItsLedger) {
  LedgerEntry entry;
  entry.compared = 100;
  entry.identical = 60;
  entry.flips = 1;
  entry.ulps[0] = 60;
  entry.ulps[ulpBin(7)] = 39;
  entry.max_ulps = 7;
  entry.max_relative = 1.0 / 3.0;
  CellRecord record = madeRecord("t/m1/64x36/gl-a", Outcome::kPass);
  record.ledger[{.device = "gl-b", .other = "gl-a", .input = "gl-b", .stage = "", .buffer = "hit"}] = entry;
  const auto read = readCellRecord(toJson(record), "file");
  ASSERT_TRUE(read.has_value()) << sentence(read.error());
  EXPECT_EQ(record.ledger, read->ledger);
}

TEST(CellRecord, ANotANumberStaysOne) {
  CellRecord record = madeRecord("t/m1/64x36/gl-a", Outcome::kFail);
  record.checks[0].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(readCellRecord(toJson(record), "file")->checks.at(0).value.value()));
}

TEST(CellRecord, AnythingElseIsRefusedWithItsFile) {
  const std::string good = toJson(madeRecord("t/m1/64x36/gl-a", Outcome::kPass));
  std::string other_version = good;
  other_version.replace(other_version.find("\"schema_version\": 3"), 19, "\"schema_version\": 9");
  std::string bad_outcome = good;
  bad_outcome.replace(bad_outcome.rfind("\"pass\""), 6, "\"fine\"");
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("[]"), good.substr(0, good.size() / 2), other_version,
        bad_outcome, std::string("{\"schema\": 3}")}) {
    const auto read = readCellRecord(text, "some/file.json");
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_EQ("some/file.json", read.error().where);
  }
}

TEST(CellRecord, OutcomeIsTheGravest) {
  using enum Outcome;
  CellRecord record{.id = "t", .checks = {madeCheck("a", kPass), madeCheck("b", kSkip)}};
  EXPECT_EQ(kPass, outcomeOf(record));
  for (const Outcome graver : {kXfail, kFlake, kFail, kTimeout, kCrash}) {
    record.checks.push_back(madeCheck("c", graver));
    EXPECT_EQ(graver, outcomeOf(record));
  }
  EXPECT_EQ(kMissing, outcomeOf(CellRecord{.id = "t"}));
}

TEST(CellStore, KeepsOneFileACell) {
  const test::TemporaryFolder folder;
  const CellStore store(folder.path());
  const CellRecord record = madeRecord("t/m1/64x36/gl-a", Outcome::kPass);
  ASSERT_TRUE(store.write(record).has_value());
  EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / "cells/t/m1/64x36/gl-a.json"));
  const auto found = store.find(record.id);
  ASSERT_TRUE(found.has_value());
  ASSERT_TRUE(found->has_value());
  EXPECT_EQ(toJson(record), toJson(**found));
  EXPECT_FALSE(store.find("t/m2/64x36/gl-a")->has_value()) << "never finished";
}

TEST(CellStore, AResultOfOtherInputsIsNotFinished) {
  const test::TemporaryFolder folder;
  const CellStore store(folder.path());
  const CellRecord record = madeRecord("t/m1/64x36/gl-a", Outcome::kPass);
  ASSERT_TRUE(store.write(record).has_value());
  EXPECT_TRUE(store.finished(record.id, record.inputs).has_value());
  EXPECT_FALSE(store.finished(record.id, "other").has_value());
}

TEST(CellStore, ADamagedResultIsNotFinishedAndAnErrorToReaders) {
  const test::TemporaryFolder folder;
  const CellStore store(folder.path());
  const CellRecord record = madeRecord("t/m1/64x36/gl-a", Outcome::kPass);
  ASSERT_TRUE(store.write(record).has_value());
  std::filesystem::resize_file(store.fileOf(record.id), 100);
  EXPECT_FALSE(store.finished(record.id, record.inputs).has_value());
  EXPECT_FALSE(store.find(record.id).has_value());
}

TEST(CellStore, AResultUnderAnothersNameIsAnError) {
  const test::TemporaryFolder folder;
  const CellStore store(folder.path());
  ASSERT_TRUE(store.write(madeRecord("t/m1/64x36/gl-a", Outcome::kPass)).has_value());
  std::filesystem::copy_file(store.fileOf("t/m1/64x36/gl-a"), store.fileOf("t/m1/64x36/gl-b"));
  EXPECT_FALSE(store.find("t/m1/64x36/gl-b").has_value());
}

TEST(CellStore, RemovingTakesTheRecordAndItsPicturesAlone) {
  const test::TemporaryFolder folder;
  const CellStore store(folder.path());
  for (const char* id : {"t/m1/64x36/gl-a", "t/m1/64x36/gl-ab"}) {
    ASSERT_TRUE(store.write(madeRecord(id, Outcome::kFail)).has_value());
    std::ofstream(store.pictureOf(id, "hiz")) << "picture";
  }
  ASSERT_TRUE(store.remove("t/m1/64x36/gl-a").has_value());
  EXPECT_FALSE(std::filesystem::exists(store.fileOf("t/m1/64x36/gl-a")));
  EXPECT_FALSE(std::filesystem::exists(store.pictureOf("t/m1/64x36/gl-a", "hiz")));
  EXPECT_TRUE(std::filesystem::exists(store.fileOf("t/m1/64x36/gl-ab")));
  EXPECT_TRUE(std::filesystem::exists(store.pictureOf("t/m1/64x36/gl-ab", "hiz")));
  EXPECT_TRUE(store.remove("t/never/64x36/gl-a").has_value());
}

TEST(CellStore, PlansSurvive) {
  const test::TemporaryFolder folder;
  const CellStore store(folder.path());
  const Manifest manifest = madeManifest({2, 2});
  ASSERT_TRUE(store.write(manifest).has_value());
  const auto read = store.manifest();
  ASSERT_TRUE(read.has_value()) << sentence(read.error());
  EXPECT_EQ(toJson(manifest), toJson(*read));
  EXPECT_EQ((std::vector<std::string>{"t/m2/64x36/gl-a", "t/m3/64x36/gl-a"}), ownCells(*read));
}

}  // namespace
}  // namespace ssrkit
