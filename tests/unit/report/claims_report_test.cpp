#include "report/claims_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/text.h"

namespace ssrkit {
namespace {

ClaimFigure figure(const std::string& name, const std::string& device, double value, ClaimVerdict verdict) {
  ClaimFigure made;
  made.check.id = "cheap_rays." + name;
  made.check.scene = "clutter";
  made.check.device = device;
  made.check.stage = "hiz";
  made.check.size = {640, 360};
  made.check.metric = "mean_lookups";
  made.check.unit = "lookups per ray";
  made.check.value = value;
  made.check.max = 10.0;
  made.check.outcome = verdict == ClaimVerdict::kConfirmed ? Outcome::kPass : Outcome::kFail;
  made.refuting.above = 20.0;
  made.verdict = verdict;
  return made;
}

ClaimReport refuted() {
  ClaimReport report;
  report.claim.name = "cheap_rays";
  report.claim.source = "somebody, 2020";
  report.claim.says = "rays are cheap";
  report.claim.if_refuted = "They are not.";
  report.claim.if_confirmed = "They are.";
  report.claim.finding = ClaimVerdict::kRefuted;
  report.claim.test.id = "cheap_rays";
  report.claim.test.about = "a ray makes at most 10 lookups";
  report.result.verdict = ClaimVerdict::kRefuted;
  report.result.figures = {figure("cost", "gl-osmesa", 5.0, ClaimVerdict::kConfirmed),
                           figure("cost", "vk-lavapipe", 25.25, ClaimVerdict::kRefuted)};
  report.again = "./ssrkit compare --claim cheap_rays";
  return report;
}

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(VerdictText, NamesTheFigureThatSettlesItAndWhy) {
  EXPECT_EQ(
      verdictText(refuted()),
      "refuted: cost = 25.25 lookups per ray (confirmed at <= 10, refuted at >= 20), clutter 640x360 hiz on "
      "vk-lavapipe. They are not.");
}

TEST(VerdictText, CountsTheFiguresThatConfirm) {
  ClaimReport report = refuted();
  report.result.figures[1] = figure("cost", "vk-lavapipe", 6.0, ClaimVerdict::kConfirmed);
  report.result.verdict = ClaimVerdict::kConfirmed;
  EXPECT_EQ(verdictText(report),
            "confirmed by all 2 figures that decide, as by cost = 5 lookups per ray (confirmed at <= 10, "
            "refuted at >= 20), "
            "clutter 640x360 hiz on gl-osmesa. They are.");
}

TEST(VerdictText, TellsWhyNothingIsKnown) {
  ClaimReport report = refuted();
  ClaimFigure crash = figure("runs", "gl-osmesa", 0.0, ClaimVerdict::kNotMeasured);
  crash.check.value.reset();
  crash.check.max.reset();
  crash.check.message = "the worker died";
  report.result = {ClaimVerdict::kNotMeasured, {crash}};
  const std::string text = verdictText(report);
  EXPECT_TRUE(holds(text, "not measured: runs")) << text;
  EXPECT_TRUE(holds(text, "the worker died.")) << text;
}

TEST(ClaimText, FitsItsWidthAndShowsEachFigure) {
  ClaimReport report = refuted();
  report.claim.says = std::string(40, 'x') + " " + std::string(40, 'y') + " " + std::string(40, 'z');
  const std::string text = claimText(report, {.colour = false, .width = 100});
  for (const std::string& line : split(text, '\n')) {
    EXPECT_LE(line.size(), 100U) << line;
  }
  EXPECT_TRUE(holds(text, "cheap_rays: refuted\n")) << text;
  EXPECT_TRUE(holds(text, "confirmed at <= 10, refuted at >= 20")) << text;
  EXPECT_TRUE(holds(text, "25.25")) << text;
  EXPECT_TRUE(holds(text, "./ssrkit compare --claim cheap_rays")) << text;
  EXPECT_FALSE(holds(text, "\033")) << text;
  EXPECT_FALSE(holds(text, "noted")) << text;
  EXPECT_TRUE(holds(claimText(report, {.colour = true, .width = 100}), "\033[33mrefuted\033[0m"));
}

TEST(ClaimText, JoinsDevicesThatSayTheSame) {
  ClaimReport report = refuted();
  report.result.figures[1] = figure("cost", "vk-lavapipe", 5.0, ClaimVerdict::kConfirmed);
  EXPECT_TRUE(holds(claimText(report, {}), "gl-osmesa vk-lavapipe"));
}

TEST(ClaimText, SaysWhereTheFileNotesSomethingElse) {
  ClaimReport report = refuted();
  report.claim.finding = ClaimVerdict::kConfirmed;
  EXPECT_TRUE(holds(claimText(report, {}), "the claim's file says confirmed"));
}

TEST(ClaimsJson, HoldsEveryFigureWithBothBounds) {
  ClaimsReport report;
  report.claims = {refuted()};
  report.claims[0].result.figures[1].check.interval = {24.0, 26.0};
  report.claims[0].result.figures[1].check.histogram = {{"again", 3}};
  report.claims[0].result.figures[0].decides = false;
  const auto json = nlohmann::json::parse(claimsJson(report));
  EXPECT_EQ(json["schema"], "ssrkit-claims");
  EXPECT_EQ(json["summary"], "1 refuted");
  const auto& claim = json["claims"][0];
  EXPECT_EQ(claim["verdict"], "refuted");
  EXPECT_EQ(claim["noted"], "refuted");
  EXPECT_EQ(claim["hypothesis"], "a ray makes at most 10 lookups");
  const auto& shown = claim["figures"][0];
  EXPECT_TRUE(shown["verdict"].is_null());
  EXPECT_TRUE(shown["interval"].is_null());
  const auto& settles = claim["figures"][1];
  EXPECT_EQ(settles["value"], 25.25);
  EXPECT_EQ(settles["confirmed"]["max"], 10.0);
  EXPECT_TRUE(settles["confirmed"]["min"].is_null());
  EXPECT_EQ(settles["refuted"]["above"], 20.0);
  EXPECT_EQ(settles["interval"][1], 26.0);
  EXPECT_EQ(settles["histogram"][0]["count"], 3);
}

TEST(ClaimsHtml, NeedsNothingFromANetworkAndEscapesWhatItIsGiven) {
  ClaimsReport report;
  report.claims = {refuted()};
  report.claims[0].claim.says = "a < b & \"c\" <script>";
  const std::string html = claimsHtml(report);
  EXPECT_TRUE(holds(html, "a &lt; b &amp; &quot;c&quot; &lt;script&gt;")) << html;
  EXPECT_FALSE(holds(html, "<script"));
  EXPECT_FALSE(holds(html, "http"));
  EXPECT_FALSE(holds(html, "src="));
  EXPECT_TRUE(html.ends_with("</html>\n"));
  EXPECT_TRUE(holds(html, "verdict refuted"));
}

// The bar of 25.25 is the longest: 1.05 times it is the scale of 420 units from 330 on.
TEST(ClaimsHtml, DrawsBarsAndBoundsOnOneScale) {
  ClaimsReport report;
  report.claims = {refuted()};
  const std::string html = claimsHtml(report);
  EXPECT_TRUE(holds(html, "width=\"400.0\"")) << html;  // 420 / 1.05
  EXPECT_TRUE(holds(html, "width=\"79.2\"")) << html;   // 5 / 25.25 of it
  EXPECT_TRUE(holds(html, "M488.4 ")) << html;          // 10: 330 + 420 * 10 / (25.25 * 1.05)
  EXPECT_TRUE(holds(html, "M646.8 ")) << html;          // 20
}

TEST(ClaimsHtml, ExplainsTheClassesOfADistribution) {
  ClaimsReport report;
  report.claims = {refuted()};
  report.claims[0].result.figures[0].check.histogram = {{"again", 1}, {"1 on", 3}};
  const std::string html = claimsHtml(report);
  EXPECT_TRUE(holds(html, ">again</text>")) << html;
  EXPECT_TRUE(holds(html, "<title>1 on: 75 %</title>")) << html;
}

TEST(ClaimsHtml, DrawsNoLineForABoundBelowTheScale) {
  ClaimsReport report;
  report.claims = {refuted()};
  for (ClaimFigure& figure : report.claims[0].result.figures) {
    figure.check.max.reset();
    figure.check.min = 0.0;
    figure.refuting = {std::nullopt, -0.05};
  }
  const std::string html = claimsHtml(report);
  EXPECT_TRUE(holds(html, "confirmed from 0<")) << html;
  EXPECT_FALSE(holds(html, "refuted up to")) << html;
}

TEST(ClaimsHtml, DrawsAFigureThatCouldNotBeMeasured) {
  ClaimsReport report;
  report.claims = {refuted()};
  report.claims[0].result.figures[1].check.value.reset();
  EXPECT_TRUE(holds(claimsHtml(report), "not measured</text>"));
}

}  // namespace
}  // namespace ssrkit
