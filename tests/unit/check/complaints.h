// Files that are right but for one thing, and what is said about it.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace ssrkit {

// The file with `from` replaced by `to`, once.
inline std::string withChange(std::string file, std::string_view from, std::string_view to) {
  const std::size_t place = file.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return file.replace(place, from.size(), to);
}

// Whether a complaint has all of these parts.
inline testing::AssertionResult says(const std::string& complaint,
                                     std::initializer_list<std::string_view> parts) {
  std::string lacking;
  for (const std::string_view part : parts) {
    lacking += complaint.find(part) == std::string::npos ? " '" + std::string(part) + "'" : "";
  }
  return (lacking.empty() ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "no" << lacking << " in: " << complaint;
}

}  // namespace ssrkit
