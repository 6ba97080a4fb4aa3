#include "mutation/read_mutants.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "check/field_reader.h"
#include "check/read_expectations.h"

namespace ssrkit {

namespace {

const std::vector<std::string> kMutantKeys = {"about", "file",      "replace",  "with",
                                              "pass",  "signature", "killed_by"};
const std::vector<std::string> kWheatKeys = {"about", "file", "replace", "with"};

// Files that mutants may change; anything else is nothing that a check looks at.
bool isSource(const std::filesystem::path& file) {
  const bool is_inside = file.lexically_normal() == file && file.is_relative();
  return is_inside && (*file.begin() == "shaders" || *file.begin() == "harness") && file.has_extension();
}

void readEdit(FieldReader& fields, Mutant& mutant) {
  mutant.edit.file = fields.text("file");
  mutant.edit.replace = fields.text("replace");
  mutant.edit.with = fields.optionalText("with").value_or("");
  if (fields.ok() && !isSource(mutant.edit.file)) {
    fields.complain("file", fmt::format("'{}' is no source file of the kit", mutant.edit.file.string()),
                    "name a file under shaders/ or harness/");
  }
  if (fields.ok() && mutant.edit.replace == mutant.edit.with) {
    fields.complain("with", "it is the same text", "say what stands there instead");
  }
}

}  // namespace

Expected<Mutant> readMutant(std::string_view content, const std::filesystem::path& file, bool is_wheat) {
  const std::string attempted =
      fmt::format("read the {} '{}'", is_wheat ? "wheat" : "mutant", file.stem().string());
  const Expected<TomlValue> document = parseToml(content, file.string(), attempted);
  if (!document) {
    return tl::make_unexpected(document.error());
  }
  Mutant mutant{.name = file.stem().string(), .is_wheat = is_wheat, .where = file.string()};
  FieldReader fields(*document, "the file", file.string(), attempted);
  fields.allowOnly(is_wheat ? kWheatKeys : kMutantKeys);
  mutant.about = fields.text("about");
  const auto pass = is_wheat ? std::nullopt : fields.optionalText("pass");
  if (pass) {
    mutant.edit.file = "shaders/" + *pass + ".frag";
    mutant.shader = std::filesystem::path(file).replace_extension(".frag");
  } else {
    readEdit(fields, mutant);
  }
  if (!is_wheat) {
    mutant.signature = fields.text("signature");
    mutant.killed_by = fields.text("killed_by");
  }
  const auto read = fields.result();
  return read ? Expected<Mutant>(std::move(mutant)) : tl::make_unexpected(read.error());
}

Expected<std::vector<Mutant>> loadMutants(const std::filesystem::path& folder, bool are_wheats) {
  const std::string attempted =
      fmt::format("read the {} in '{}'", are_wheats ? "wheats" : "mutants", folder.string());
  const auto files = tomlFiles(folder, attempted);
  if (!files) {
    return tl::make_unexpected(files.error());
  }
  std::vector<Mutant> mutants;
  for (const std::filesystem::path& file : *files) {
    const Expected<std::string> content = readFile(file);
    auto mutant = content ? readMutant(*content, file, are_wheats) : tl::make_unexpected(content.error());
    if (!mutant) {
      return tl::make_unexpected(mutant.error());
    }
    mutants.push_back(std::move(*mutant));
  }
  return mutants;
}

}  // namespace ssrkit
