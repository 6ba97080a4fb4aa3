#include "command/mutant_build.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "command/child_program.h"
#include "mutation/text_edit.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

// What the compiler is given: the source itself, or a file of the build that includes it among others.
struct TranslationUnit {
  fs::path path;
  std::string command;  // up to the names of its object and source
};

// How a unity build's file names a source.
std::string includeOf(const fs::path& source) {
  return fmt::format("#include \"{}\"", source.string());
}

// Warnings are the kit's, not the mutant's: what a mistake leaves unused is none.
Expected<TranslationUnit> unitOf(const fs::path& source, const fs::path& build,
                                 const std::string& attempted) {
  const fs::path list = build / "compile_commands.json";
  const auto content = readFile(list);
  if (!content) {
    return tl::make_unexpected(content.error());
  }
  std::error_code ignored;
  const fs::path wanted = fs::canonical(source, ignored);
  for (const nlohmann::json& entry : nlohmann::json::parse(*content, nullptr, false)) {
    const fs::path path = entry.value("file", "");
    const auto unity = path.parent_path().filename() == "Unity" ? readFile(path) : Expected<std::string>("");
    if (path == wanted || (unity && unity->find(includeOf(wanted)) != std::string::npos)) {
      const std::string command = entry.value("command", "");
      return TranslationUnit{path, command.substr(0, command.find(" -o ")) + " -w"};
    }
  }
  return inputError(attempted, fmt::format("'{}' is no file that is compiled", source.string()),
                    list.string(), "name a .cpp file of the build");
}

// Writes the mutant's source into `folder`, and where others are compiled with it the file that includes them
// all. What there is to compile.
Expected<fs::path> writeSource(const std::string& edited, const fs::path& source,
                               const TranslationUnit& compiled, const fs::path& folder) {
  fs::path changed = folder / source.filename();
  if (const auto done = writeFileAtomically(changed, edited); !done) {
    return tl::make_unexpected(done.error());
  }
  std::error_code ignored;
  const fs::path own = fs::canonical(source, ignored);
  if (compiled.path == own) {
    return changed;
  }
  auto unity = readFile(compiled.path);
  if (!unity) {
    return tl::make_unexpected(unity.error());
  }
  const std::string include = includeOf(own);
  unity->replace(unity->find(include), include.size(), includeOf(changed));
  fs::path all = folder / compiled.path.filename();
  const auto done = writeFileAtomically(all, *unity);
  return done ? Expected<fs::path>(std::move(all)) : tl::make_unexpected(done.error());
}

// A shell command that must succeed; what it printed is the reason when it does not.
Expected<void> runShell(const std::string& command, const fs::path& build, const fs::path& output,
                        const std::string& attempted, const std::string& where) {
  const auto code = runChild(
      {.arguments = {"/bin/sh", "-c", command}, .environment = {}, .folder = build, .output = output});
  if (!code) {
    return tl::make_unexpected(code.error());
  }
  if (*code == 0) {
    return {};
  }
  Error error{ErrorKind::kInput,       attempted, fmt::format("its command ended with {}", *code), where,
              "a mutant must compile", {}};
  if (const auto printed = readFile(output)) {
    error.reasons.push_back(printed->substr(0, 2000));
  }
  return tl::make_unexpected(std::move(error));
}

Expected<std::string> linkCommandOf(const std::string& target, const fs::path& build, const fs::path& output,
                                    const std::string& attempted) {
  const auto code = runChild({.arguments = {"ninja", "-C", build.string(), "-t", "commands", "-s", target},
                              .environment = {},
                              .folder = {},
                              .output = output});
  const auto printed = code ? readFile(output) : tl::make_unexpected(code.error());
  if (!printed) {
    return tl::make_unexpected(printed.error());
  }
  const std::size_t at = printed->find(": && ");
  if (*code != 0 || at == std::string::npos) {
    return setupError(attempted, fmt::format("ninja does not know how '{}' is linked", target),
                      build.string(), "configure with a preset of CMakePresets.json");
  }
  return printed->substr(at, printed->find('\n', at) - at);
}

}  // namespace

std::string roomOf(const Mutant& mutant) {
  const auto second = std::next(mutant.edit.file.begin());
  return second == mutant.edit.file.end() ? "" : second->string();
}

Expected<fs::path> buildMutant(const Mutant& mutant, const KitPaths& paths, const fs::path& folder) {
  const std::string attempted = fmt::format("build the mutant '{}'", mutant.name);
  const fs::path source = paths.root / mutant.edit.file;
  const auto original = readFile(source);
  const auto edited =
      original ? applyEdit(*original, mutant.edit, mutant.where) : tl::make_unexpected(original.error());
  const auto compiled = edited ? unitOf(source, paths.build, attempted) : tl::make_unexpected(edited.error());
  const auto changed = compiled ? writeSource(*edited, source, *compiled, folder)
                                : Expected<fs::path>(tl::make_unexpected(compiled.error()));
  if (!changed) {
    return tl::make_unexpected(changed.error());
  }
  const std::string object = changed->string() + ".o";
  const std::string target = "bin/test_" + roomOf(mutant);
  const fs::path program = folder / ("test_" + roomOf(mutant));
  const std::string compile = fmt::format("{} -o {} -c {}", compiled->command, object, changed->string());
  auto done = runShell(compile, paths.build, folder / "compile.log", attempted, mutant.where);
  auto link = done ? linkCommandOf(target, paths.build, folder / "link.txt", attempted)
                   : Expected<std::string>(tl::make_unexpected(done.error()));
  if (!link) {
    return tl::make_unexpected(link.error());
  }
  // Before the rooms' archives: what the object defines is not taken from them.
  const std::string output = "-o " + target + " ";
  const std::size_t at = link->find(output);
  if (at == std::string::npos) {
    return setupError(attempted, fmt::format("the command that links {} has another form", target));
  }
  link->replace(at, output.size(), fmt::format("-o {} {} ", program.string(), object));
  done = runShell(*link, paths.build, folder / "link.log", attempted, mutant.where);
  return done ? Expected<fs::path>(program) : tl::make_unexpected(done.error());
}

}  // namespace ssrkit
