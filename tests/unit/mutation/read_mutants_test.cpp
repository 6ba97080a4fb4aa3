#include "mutation/read_mutants.h"

#include <gtest/gtest.h>

namespace ssrkit {
namespace {

constexpr const char* kEdit = R"(about = "adds one"
signature = "all values are one too high"
killed_by = "SumTest.AddsUp"
file = "harness/check/sum.cpp"
replace = "a + b"
with = "a + b + 1"
)";

std::string complaint(const std::string& content, bool is_wheat = false) {
  const auto mutant = readMutant(content, "adds_one.toml", is_wheat);
  return mutant ? "read" : sentence(mutant.error());
}

std::string without(const std::string& key) {
  std::string text = kEdit;
  const std::size_t start = text.find(key + " = ");
  return text.erase(start, text.find('\n', start) + 1 - start);
}

TEST(ReadMutant, GivesWhatTheFileSays) {
  const Mutant mutant = readMutant(kEdit, "tests/mutants/adds_one.toml", false).value();
  EXPECT_EQ(mutant.name, "adds_one");
  EXPECT_EQ(mutant.killed_by, "SumTest.AddsUp");
  EXPECT_EQ(mutant.edit.file, "harness/check/sum.cpp");
  EXPECT_EQ(mutant.edit.replace, "a + b");
  EXPECT_EQ(mutant.edit.with, "a + b + 1");
  EXPECT_FALSE(mutant.is_wheat);
  EXPECT_TRUE(isOfHarness(mutant));
  EXPECT_TRUE(isUnitTest(mutant.killed_by));
}

TEST(ReadMutant, AWholeShaderStandsBesideIt) {
  const Mutant mutant =
      readMutant("about = 'a'\nsignature = 'b'\nkilled_by = 'oracle.walk'\npass = 'light'\n", "m/dark.toml",
                 false)
          .value();
  EXPECT_EQ(mutant.edit.file, "shaders/light.frag");
  EXPECT_EQ(mutant.shader, "m/dark.frag");
  EXPECT_FALSE(isOfHarness(mutant));
  EXPECT_FALSE(isUnitTest(mutant.killed_by));
}

TEST(ReadMutant, WantsEveryKey) {
  for (const std::string key : {"about", "signature", "killed_by", "file", "replace"}) {
    EXPECT_NE(complaint(without(key)).find(key), std::string::npos) << key;
  }
  EXPECT_EQ(complaint(without("with")), "read");  // what is taken away has nothing in its place
}

TEST(ReadMutant, RefusesWhatIsNoSourceOfTheKit) {
  for (const std::string file : {"/etc/passwd", "shaders/../secrets.txt", "docs/a.md", "shaders"}) {
    std::string text = without("file") + "file = \"" + file + "\"\n";
    EXPECT_NE(complaint(text).find("no source file"), std::string::npos) << file;
  }
}

TEST(ReadMutant, RefusesAnEditThatChangesNothing) {
  EXPECT_NE(complaint(without("with") + "with = 'a + b'\n").find("the same text"), std::string::npos);
}

TEST(ReadMutant, AWheatHasNoKiller) {
  EXPECT_NE(complaint(kEdit, true).find("signature"), std::string::npos);
  const Mutant wheat =
      readMutant("about = 'a'\nfile = 'shaders/a.frag'\nreplace = 'a'\nwith = 'b'\n", "w.toml", true).value();
  EXPECT_TRUE(wheat.is_wheat);
  EXPECT_EQ(wheat.killed_by, "");
}

}  // namespace
}  // namespace ssrkit
