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

// The command that compiles a source file, up to the names of its object and source. Warnings are the kit's,
// not the mutant's: what a mistake leaves unused is none.
Expected<std::string> compileCommandOf(const fs::path& source, const fs::path& build,
                                       const std::string& attempted) {
  const fs::path list = build / "compile_commands.json";
  const auto content = readFile(list);
  if (!content) {
    return tl::make_unexpected(content.error());
  }
  std::error_code ignored;
  const fs::path wanted = fs::canonical(source, ignored);
  for (const nlohmann::json& entry : nlohmann::json::parse(*content, nullptr, false)) {
    if (fs::path(entry.value("file", "")) == wanted) {
      const std::string command = entry.value("command", "");
      return command.substr(0, command.find(" -o ")) + " -w";
    }
  }
  return inputError(attempted, fmt::format("'{}' is no file that is compiled by itself", source.string()),
                    list.string(), "name a .cpp file of the build");
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
  auto compile =
      edited ? compileCommandOf(source, paths.build, attempted) : tl::make_unexpected(edited.error());
  if (!compile) {
    return tl::make_unexpected(compile.error());
  }
  const fs::path changed = folder / source.filename();
  const std::string object = changed.string() + ".o";
  const std::string target = "bin/test_" + roomOf(mutant);
  const fs::path program = folder / ("test_" + roomOf(mutant));
  auto done = writeFileAtomically(changed, *edited);
  *compile += fmt::format(" -o {} -c {}", object, changed.string());
  done = done ? runShell(*compile, paths.build, folder / "compile.log", attempted, mutant.where) : done;
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
