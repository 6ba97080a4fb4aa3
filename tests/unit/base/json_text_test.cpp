#include "base/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ssrkit {
namespace {

TEST(JsonText, BytesThatAreNoUtf8AreReplaced) {
  const nlohmann::ordered_json json = {{"command", {"run", "caf\xe9"}}};
  EXPECT_EQ(R"({"command":["run","caf)"
            "\xef\xbf\xbd"
            R"("]})",
            jsonText(json, -1));
}

TEST(JsonText, KeysKeepTheirOrderAndLevelsAreIndented) {
  const nlohmann::ordered_json json = {{"b", 1}, {"a", 2}};
  EXPECT_EQ("{\n  \"b\": 1,\n  \"a\": 2\n}", jsonText(json, 2));
}

}  // namespace
}  // namespace ssrkit
