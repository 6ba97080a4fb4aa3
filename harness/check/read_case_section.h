// The [[case]] sections of an expectation file: named sets of tracing parameters, and the technique that
// makes a picture.
#pragma once

#include <string>

#include "base/error.h"
#include "check/expectation.h"
#include "check/read_expectations.h"
#include "check/toml_document.h"

namespace ssrkit {

// One section. `test` holds the cases read so far: two of one name are an error.
[[nodiscard]] Expected<TestCase> readCaseSection(const TomlValue& table, const TestFile& test,
                                                 const KnownNames& known, const std::string& attempted);

}  // namespace ssrkit
