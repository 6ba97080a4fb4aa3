#include "report/mutation_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/text.h"

namespace ssrkit {
namespace {

MutantRun killed() {
  return {.mutant = {.name = "walks_backwards",
                     .about = "The ray runs backwards.",
                     .signature = "Every hit is on the other side.",
                     .killed_by = "oracle.walk",
                     .edit = {.file = "shaders/walk.frag"}},
          .noticed = {{"oracle.walk", true}, {"properties.finite", false}},
          .said = {{"oracle.walk", "12 rays on m1 64x64"}},
          .time_s = 1.5};
}

MutantRun survivor() {
  MutantRun run = killed();
  run.mutant.name = "survives";
  run.noticed["oracle.walk"] = false;
  run.said.clear();
  return run;
}

MutationReport report(std::vector<MutantRun> runs) {
  return {.kit_version = "1",
          .started = "2026-01-01T00:00:00Z",
          .command = {"./ssrkit", "mutate"},
          .runs = std::move(runs),
          .suite = {"oracle.walk", "properties.finite"},
          .is_whole = true,
          .time_s = 3.0};
}

TEST(MutationText, SaysWhoKilledWhatAndHow) {
  const std::string text = mutantText(killed());
  EXPECT_TRUE(text.starts_with("killed   walks_backwards\n")) << text;
  EXPECT_NE(text.find("by oracle.walk: 12 rays on m1 64x64"), std::string::npos) << text;
}

TEST(MutationText, NamesASurvivorWithItsMistake) {
  const std::string text = mutantText(survivor());
  EXPECT_TRUE(text.starts_with("SURVIVED survives\n")) << text;
  EXPECT_NE(text.find("The ray runs backwards."), std::string::npos);
  EXPECT_NE(text.find("foretold was oracle.walk"), std::string::npos);
}

TEST(MutationText, SaysWhenAnotherCheckWasForetold) {
  MutantRun run = killed();
  run.mutant.killed_by = "properties.finite";
  EXPECT_NE(mutantText(run).find("not by properties.finite, as was foretold"), std::string::npos);
}

TEST(MutationText, GivesTheScoreRoundedDown) {
  std::vector<MutantRun> runs(1999, killed());
  runs.push_back(survivor());
  const std::string text = mutationText(report(runs));
  EXPECT_NE(text.find("Score: 1999 of 2000 mutants killed (99.9 %), 0 of 0 wheats rejected"),
            std::string::npos)
      << text.substr(text.size() - 200);
  EXPECT_NE(text.find("Notice no mutant: properties.finite"), std::string::npos);
}

TEST(MutationText, FitsAHundredColumns) {
  MutantRun run = killed();
  run.mutant.about = std::string(40, 'a') + " " + std::string(50, 'b') + " " + std::string(30, 'c');
  run.noticed["oracle.walk"] = false;
  for (const std::string& line : split(mutantText(run) + mutationText(report({run, killed()})), '\n')) {
    EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(KillMatrixCsv, TellsNoticedHeldAndNotLookedAtApart) {
  MutantRun other = killed();
  other.mutant.name = "another";
  other.noticed = {{"oracle.walk", false}};
  EXPECT_EQ(killMatrixCsv(report({killed(), other})),
            "name,kind,file,oracle.walk,properties.finite\n"
            "another,mutant,shaders/walk.frag,0,\n"
            "walks_backwards,mutant,shaders/walk.frag,1,0\n");
}

TEST(MutationJson, HoldsTheScoreAndEveryRun) {
  const auto json = nlohmann::json::parse(mutationJson(report({killed(), survivor()})));
  EXPECT_EQ(json.at("schema"), "ssrkit-mutate");
  EXPECT_EQ(json.at("mutants"), 2);
  EXPECT_EQ(json.at("killed"), 1);
  EXPECT_EQ(json.at("survivors"), nlohmann::json({"survives"}));
  EXPECT_EQ(json.at("runs").at(1).at("complaints").at("oracle.walk"), "12 rays on m1 64x64");
  EXPECT_EQ(json.at("runs").at(0).at("passed"), false);
}

TEST(MutationJson, TakesArgumentsThatAreNoUtf8) {
  MutationReport odd = report({killed()});
  odd.command = {"./ssrkit", "mutate", "--out", "caf\xe9"};
  const auto json = nlohmann::json::parse(mutationJson(odd));
  EXPECT_EQ(json.at("command")[3], "caf\xef\xbf\xbd");
}

TEST(MutationHtml, EscapesWhatChecksSay) {
  MutantRun run = killed();
  run.said["oracle.walk"] = "<b> & \"c\"";
  const std::string html = mutationHtml(report({run}));
  EXPECT_EQ(html.find("<b> &"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;"), std::string::npos);
}

}  // namespace
}  // namespace ssrkit
