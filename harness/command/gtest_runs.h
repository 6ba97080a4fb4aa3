// The unit-test programs of the build, test by test.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace ssrkit {

// The room of each unit test by its name, "TracersTest.Name": all of its parameters are one test.
using UnitTestRooms = std::map<std::string, std::string>;

// Asks every program build/bin/test_ROOM. Fails when there is none: they are built by `./ssrkit test`.
[[nodiscard]] Expected<UnitTestRooms> findUnitTests(const std::filesystem::path& build,
                                                    const std::filesystem::path& scratch);

struct UnitTestRun {
  std::filesystem::path program;
  std::vector<std::string> tests;  // by name
  std::string instance;            // of tests with parameters: those whose own name ends so; empty: all
  std::vector<std::pair<std::string, std::string>> environment;
  std::filesystem::path scratch;  // a folder for the program's files
};

// What each test said: empty when it passed, else the first line of its complaint. A test that ends the
// program, or does not end in time, has failed. Tests without an instance are left out.
[[nodiscard]] Expected<std::map<std::string, std::string>> runUnitTests(const UnitTestRun& run);

}  // namespace ssrkit
