#include "report/ledger_json.h"

#include <nlohmann/json.hpp>

namespace ssrkit {

namespace {

Json entryJson(const LedgerKey& key, const LedgerEntry& entry) {
  Json ulps = Json::array();  // [at most this many ulps, texels], for each bin that holds any
  for (std::size_t bin = 0; bin < entry.ulps.size(); ++bin) {
    if (entry.ulps[bin] > 0) {
      ulps.push_back({mostUlpsOf(bin), entry.ulps[bin]});
    }
  }
  return {{"device", key.device},
          {"other", key.other},
          {"input", key.input},
          {"stage", key.stage},
          {"buffer", key.buffer},
          {"compared", entry.compared},
          {"identical", entry.identical},
          {"flips", entry.flips},
          {"p50_ulps", entry.percentile(0.5)},
          {"p99_ulps", entry.percentile(0.99)},
          {"max_ulps", entry.max_ulps},
          {"max_relative", numberOf(entry.max_relative)},
          {"ulps", std::move(ulps)}};
}

}  // namespace

Json ledgerJson(const Ledger& ledger) {
  Json list = Json::array();
  for (const auto& [key, entry] : ledger) {
    list.push_back(entryJson(key, entry));
  }
  return list;
}

Expected<Ledger> ledgerFromJson(const Json& json, const std::string& where) try {
  Ledger ledger;
  for (const Json& object : json) {
    LedgerEntry entry;
    object.at("compared").get_to(entry.compared);
    object.at("identical").get_to(entry.identical);
    object.at("flips").get_to(entry.flips);
    object.at("max_ulps").get_to(entry.max_ulps);
    object.at("max_relative").get_to(entry.max_relative);
    for (const Json& bin : object.at("ulps")) {
      entry.ulps.at(ulpBin(bin.at(0).get<std::uint64_t>())) += bin.at(1).get<std::size_t>();
    }
    ledger[{.device = object.at("device"),
            .other = object.at("other"),
            .input = object.at("input"),
            .stage = object.at("stage"),
            .buffer = object.at("buffer")}] += entry;
  }
  return ledger;
} catch (const std::exception& exception) {
  return inputError("read a ledger", exception.what(), where, "run the command that wrote it again");
}

}  // namespace ssrkit
