#include "command/bless_report.h"

#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "report/json_parts.h"

namespace ssrkit {

std::string blessJson(const std::string& test, const std::vector<BlessedGolden>& goldens) {
  const auto goldenOf = [](const BlessedGolden& golden) -> Json {
    const GoldenSubject& subject = golden.note.subject;
    return {{"file", golden.file.string()}, {"scene", subject.scene},        {"size", sizeOf(subject.size)},
            {"stage", subject.stage},       {"case", subject.case_name},     {"buffer", subject.buffer},
            {"who", golden.note.who},       {"when", golden.note.when},      {"why", golden.note.why},
            {"change", golden.change},      {"metrics", golden.note.metrics}};
  };
  const Json json = {{"schema", "ssrkit-bless"},
                     {"schema_version", kBlessSchemaVersion},
                     {"kit_version", SSRKIT_VERSION},
                     {"test", test},
                     {"goldens", listOf(goldens, goldenOf)}};
  return jsonText(json, 1) + "\n";
}

}  // namespace ssrkit
