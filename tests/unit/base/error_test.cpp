#include "base/error.h"

#include <gtest/gtest.h>

#include "base/check.h"

namespace ssrkit {
namespace {

TEST(Sentence, NamesThePlaceTheAttemptTheProblemAndTheRemedy) {
  const Error error =
      inputError("load the scene 'a.gltf'", "it is empty", "a.gltf:1:2", "export it again").value();
  EXPECT_EQ(sentence(error), "a.gltf:1:2: could not load the scene 'a.gltf': it is empty; export it again");
}

TEST(Sentence, LeavesOutWhatIsNotKnownAndListsTheReasonsBelow) {
  Error error = setupError("open the device", "it is absent").value();
  error.reasons = {"VK_ERROR_INCOMPATIBLE_DRIVER (-9)", "no ICD"};
  EXPECT_EQ(sentence(error),
            "could not open the device: it is absent\n  VK_ERROR_INCOMPATIBLE_DRIVER (-9)\n  no ICD");
}

TEST(ExitCode, TellsTheUsersMistakesFromTheMachines) {
  EXPECT_EQ(exitCode(inputError("a", "b").value()), 2);
  EXPECT_EQ(exitCode(setupError("a", "b").value()), 3);
}

TEST(CheckDeathTest, PrintsBothValuesAndAborts) {
  const int two = 2;
  EXPECT_DEATH(SSRKIT_CHECK_EQ(two, 3), "internal check failed: two == 3: 2 against 3");
}

}  // namespace
}  // namespace ssrkit
