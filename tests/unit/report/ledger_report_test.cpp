#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "report/ledger_json.h"
#include "report/ledger_table.h"

namespace ssrkit {
namespace {

LedgerEntry entryOf(std::size_t identical, std::size_t off_by_ten, std::size_t flips) {
  LedgerEntry entry;
  entry.compared = identical + off_by_ten + flips;
  entry.identical = identical;
  entry.flips = flips;
  entry.ulps[0] = identical;
  entry.ulps[ulpBin(10)] = off_by_ten;
  entry.max_ulps = off_by_ten > 0 ? 10 : 0;
  entry.max_relative = off_by_ten > 0 ? 1.5e-6 : 0.0;
  return entry;
}

Ledger ledger() {
  return {{{"gl-osmesa", "vk-lavapipe", "", "hiz", "hit"}, entryOf(900, 99, 1)},
          {{"gl-osmesa", "vk-lavapipe", "", "dda", "hit"}, entryOf(1000, 0, 0)},
          {{"gl-osmesa", "vk-lavapipe", "", "", "lit"}, entryOf(100, 0, 0)},
          {{"gl-osmesa", "gl-egl", "", "", "lit"}, entryOf(1000, 0, 0)},
          {{"gl-osmesa", "gl-egl", "", "hiz", "hit"}, entryOf(1000, 0, 0)}};
}

TEST(LedgerTable, ShowsWhatDiffersAndSumsUpWhatDoesNot) {
  const std::string table = ledgerTable(ledger());
  EXPECT_NE(table.find("gl-osmesa : gl-egl: 2 buffers are bit-identical (2000 texels)\n"), std::string::npos)
      << table;
  std::istringstream lines(table);
  std::string line;
  std::string hit;
  while (std::getline(lines, line)) {
    EXPECT_LE(line.size(), 100U) << line;
    hit = line.find("hit") != std::string::npos ? line : hit;
  }
  std::istringstream words(hit);
  std::vector<std::string> cells;
  for (std::string word; words >> word;) {
    cells.push_back(word);
  }
  EXPECT_EQ(cells, (std::vector<std::string>{"gl-osmesa", ":", "vk-lavapipe", "hit", "2000", "95.00", "0",
                                             "10", "10", "1.5e-06", "1"}))
      << table;
  EXPECT_EQ(table.find(" lit"), std::string::npos) << table;  // not one texel differs
  EXPECT_EQ(ledgerTable({}), "");
}

TEST(LedgerJson, ReadsBackWhatItWrote) {
  const auto back = ledgerFromJson(ledgerJson(ledger()), "here");
  ASSERT_TRUE(back) << sentence(back.error());
  EXPECT_EQ(*back, ledger());
}

TEST(LedgerJson, SaysTheFigures) {
  const Json json = ledgerJson({{{"a", "b", "c", "hiz", "hit"}, entryOf(900, 99, 1)}}).front();
  EXPECT_EQ(json.at("other"), "b");
  EXPECT_EQ(json.at("input"), "c");
  EXPECT_EQ(json.at("compared"), 1000);
  EXPECT_EQ(json.at("p50_ulps"), 0);
  EXPECT_EQ(json.at("p99_ulps"), 10);
  EXPECT_EQ(json.at("ulps"), Json::parse("[[0, 900], [16, 99]]"));
}

TEST(LedgerJson, WhatIsNoLedgerIsRefusedWithItsPlace) {
  Json json = ledgerJson(ledger());
  json.front().erase("flips");
  const auto back = ledgerFromJson(json, "shard.json");
  ASSERT_FALSE(back);
  EXPECT_NE(sentence(back.error()).find("shard.json"), std::string::npos);
  EXPECT_NE(sentence(back.error()).find("flips"), std::string::npos);
}

}  // namespace
}  // namespace ssrkit
