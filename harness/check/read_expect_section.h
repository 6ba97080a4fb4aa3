// The [[expect]] sections of an expectation file.
#pragma once

#include <string>

#include "base/error.h"
#include "check/expectation.h"
#include "check/read_expectations.h"
#include "check/toml_document.h"

namespace ssrkit {

// One section. `test` is complete but for its expectations: stages and cases are checked against it.
[[nodiscard]] Expected<Expectation> readExpectSection(const TomlValue& table, const TestFile& test,
                                                      const KnownNames& known, const ReadRules& rules,
                                                      const std::string& attempted);

}  // namespace ssrkit
