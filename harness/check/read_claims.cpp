#include "check/read_claims.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "check/field_reader.h"

namespace ssrkit {

namespace {

const std::vector<std::string> kClaimKeys = {"source", "says", "finding", "if_confirmed", "if_refuted"};
const ReadRules kRules = {
    .top_keys = {"claim"}, .expect_keys = {"refuted_above", "refuted_below"}, .needs_bounds = false};

Expected<void> readClaimSection(const TomlValue& table, const std::string& attempted, Claim& claim) {
  FieldReader fields(table, "[claim]", claim.test.file, attempted);
  fields.allowOnly(kClaimKeys);
  claim.source = fields.text("source");
  claim.says = fields.text("says");
  claim.if_confirmed = fields.optionalText("if_confirmed").value_or("");
  claim.if_refuted = fields.optionalText("if_refuted").value_or("");
  static const std::vector<std::string> findings = {"confirmed", "inconclusive", "refuted"};
  const std::string finding = fields.text("finding");
  fields.requireKnown("finding", finding, "finding", findings);
  claim.finding = claimVerdictFromName(finding).value_or(claim.finding);
  return fields.result();
}

// What refutes lies beyond what confirms: no value does both.
void requireOrder(FieldReader& fields, const Expectation& expectation, const RefutingBounds& refuting) {
  const auto require = [&](const char* key, bool is_given, const char* bound_key,
                           const std::optional<double>& bound, bool is_beyond) {
    if (is_given && !bound) {
      fields.complain(key, fmt::format("'{}' needs '{}', the bound that it lies beyond", key, bound_key),
                      fmt::format("add {} = ...", bound_key));
    } else if (is_given && !is_beyond) {
      fields.complain(key, fmt::format("'{}' does not lie beyond '{}': a value could confirm and refute", key,
                                       bound_key));
    }
  };
  require("refuted_above", refuting.above.has_value(), "max", expectation.max,
          refuting.above > expectation.max);
  require("refuted_below", refuting.below.has_value(), "min", expectation.min,
          refuting.below < expectation.min);
}

Expected<RefutingBounds> readRefuting(const TomlValue& table, const Expectation& expectation,
                                      const std::string& file, const std::string& attempted) {
  FieldReader fields(table, "[[expect]]", file, attempted);
  const RefutingBounds refuting{fields.number("refuted_above", -kUnlimited, kUnlimited),
                                fields.number("refuted_below", -kUnlimited, kUnlimited)};
  requireOrder(fields, expectation, refuting);
  const bool has_bounds = expectation.max || expectation.min;
  if (has_bounds && !refuting.above && !refuting.below) {
    fields.complain(
        "metric", fmt::format("nothing refutes '{}'", expectation.name),
        "add refuted_above = ... or refuted_below = ..., or leave max and min out to show the figure only");
  }
  return fields.ok() ? Expected<RefutingBounds>(refuting) : tl::make_unexpected(fields.result().error());
}

Expected<void> readAllRefuting(const TomlValue& document, const std::string& attempted, Claim& claim) {
  const std::vector<TomlValue>& sections = document.find("expect")->value.elements;
  bool decides = false;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const auto refuting = readRefuting(sections[i], claim.test.expectations[i], claim.test.file, attempted);
    if (!refuting) {
      return tl::make_unexpected(refuting.error());
    }
    claim.refuting.push_back(*refuting);
    decides = decides || claim.decides(i);
  }
  if (!decides) {
    return inputError(attempted, "no [[expect]] has a bound, so that nothing decides the claim",
                      claim.test.expectations.front().where, "add max or min, and what refutes it");
  }
  return {};
}

}  // namespace

Expected<Claim> readClaim(std::string_view content, const std::string& file, const KnownNames& known) {
  const std::string attempted = fmt::format("read the claim '{}'", file);
  const Expected<TomlValue> document = parseToml(content, file, attempted);
  if (!document) {
    return tl::make_unexpected(document.error());
  }
  auto test = readExpectations(*document, file, known, kRules);
  if (!test) {
    return tl::make_unexpected(test.error());
  }
  Claim claim;
  claim.name = test->id;
  claim.test = std::move(*test);
  const TomlEntry* section = document->find("claim");
  if (section == nullptr || section->value.kind != TomlValue::Kind::kTable) {
    return inputError(attempted, "the file has no [claim] section", placeText(file, document->place),
                      "add [claim] with source, says and finding");
  }
  auto read = readClaimSection(section->value, attempted, claim);
  read = read ? readAllRefuting(*document, attempted, claim) : read;
  return read ? Expected<Claim>(std::move(claim)) : tl::make_unexpected(read.error());
}

Expected<std::vector<Claim>> loadClaims(const std::filesystem::path& folder, const KnownNames& known) {
  const std::string attempted = fmt::format("read the claims in '{}'", folder.string());
  const auto files = tomlFiles(folder, attempted);
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  std::vector<Claim> claims;
  for (const std::filesystem::path& file : *files) {
    const Expected<std::string> content = readFile(file);
    auto claim = content ? readClaim(*content, file.string(), known) : tl::make_unexpected(content.error());
    if (!claim) {
      return tl::make_unexpected(claim.error());
    }
    if (claim->name != file.stem().string()) {
      return inputError(attempted, fmt::format("the claim '{}' is in a file of another name", claim->name),
                        file.string(), fmt::format("rename the file to {}.toml", claim->name));
    }
    claims.push_back(std::move(*claim));
  }
  return claims;
}

}  // namespace ssrkit
