#include "report/checks_html.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ssrkit {
namespace {

CheckResult check(Outcome outcome, const std::string& scene) {
  CheckResult result{
      .id = "t.finite", .scene = scene, .device = "gl-osmesa", .stage = "hiz", .size = {64, 32}};
  result.outcome = outcome;
  result.message = "what came out";
  return result;
}

std::string page(const RunReport& report) {
  const auto html = checksHtml(report);
  EXPECT_TRUE(html) << sentence(html.error());
  return html.value_or("");
}

nlohmann::json dataOf(const std::string& html) {
  const std::string begin = "id=\"data\">";
  const std::size_t first = html.find(begin) + begin.size();
  return nlohmann::json::parse(html.substr(first, html.find("</script>", first) - first));
}

// The value that a row has in a column.
std::string cell(const nlohmann::json& data, std::size_t row, const std::string& column) {
  const auto columns = data.at("columns").get<std::vector<std::string>>();
  const auto index = std::ranges::find(columns, column) - columns.begin();
  return data.at("strings").at(
      data.at("rows").at(row).at(static_cast<std::size_t>(index)).get<std::size_t>());
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(ChecksHtml, HoldsEveryCheckAndTheCounts) {
  RunReport report;
  report.checks = {check(Outcome::kPass, "m1"), check(Outcome::kFail, "m2"), check(Outcome::kPass, "m3")};
  report.checks[1].value = 0.5;
  report.checks[1].max = 0.25;
  report.checks[1].unit = "ulp";
  report.checks[1].repro = "./ssrkit run --scene m2";
  const std::string html = page(report);
  EXPECT_NE(html.find("2 passed, 1 failed"), std::string::npos);
  const nlohmann::json data = dataOf(html);
  ASSERT_EQ(data.at("rows").size(), 3U);
  EXPECT_EQ(cell(data, 1, "outcome"), "fail");
  EXPECT_EQ(cell(data, 1, "scene"), "m2");
  EXPECT_EQ(cell(data, 1, "value"), "0.5 ulp");
  EXPECT_EQ(cell(data, 1, "bound"), "<= 0.25 ulp");
  EXPECT_EQ(cell(data, 1, "message"), "what came out");
  EXPECT_EQ(cell(data, 1, "repro"), "./ssrkit run --scene m2");
  EXPECT_EQ(cell(data, 2, "scene"), "m3");
}

TEST(ChecksHtml, NothingInTheDataBecomesMarkup) {
  const std::string attack = "</script><img src=x onerror=alert(1)>\xFF\x1B";
  RunReport report;
  report.command = {attack};
  report.devices = {{.identity = {.id = attack, .driver = attack}}};
  report.checks = {check(Outcome::kFail, attack)};
  report.checks[0].id = attack;
  report.checks[0].message = attack;
  const std::string html = page(report);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(countOf(html, "</script>"), 2U);
  EXPECT_EQ(cell(dataOf(html), 0, "message"), "</script><img src=x onerror=alert(1)>\uFFFD\uFFFD");
}

TEST(ChecksHtml, NeedsNoNetworkAndNoOtherFile) {
  RunReport report;
  report.checks = {check(Outcome::kPass, "m1")};
  const std::string html = page(report);
  for (const char* const reference : {"http:", "https:", "src=\"", "href=", "@import", "url("}) {
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  }
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(ChecksHtml, FailuresCarryAPictureOfWhereTheyAre) {
  RunReport report;
  report.checks = {check(Outcome::kFail, "m1"), check(Outcome::kXfail, "m2")};
  for (CheckResult& each : report.checks) {
    each.finding_map = FindingMap{{2, 1}, {0, 255}};
  }
  const nlohmann::json data = dataOf(page(report));
  EXPECT_EQ(cell(data, 0, "picture").substr(0, 11), "iVBORw0KGgo");  // a PNG's first eight bytes
  EXPECT_EQ(cell(data, 1, "picture"), "");
}

TEST(ChecksHtml, EachTextIsHeldOnce) {
  RunReport report;
  report.checks.assign(1000, check(Outcome::kPass, "m1"));
  for (CheckResult& each : report.checks) {
    each.message = std::string(1000, 'x');
  }
  EXPECT_LT(page(report).size(), 100'000U);
}

}  // namespace
}  // namespace ssrkit
