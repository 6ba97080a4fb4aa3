// The command line: options to plain structs, errors to sentences and exit codes.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>

#include "base/system_error.h"
#include "base/text.h"
#include "command/bench_options.h"
#include "command/bless.h"
#include "command/compare.h"
#include "command/compile.h"
#include "command/conform_options.h"
#include "command/devices.h"
#include "command/interrupt.h"
#include "command/kit_paths.h"
#include "command/mutate.h"
#include "command/run_options.h"
#include "command/test.h"
#include "report/table.h"
#include "worker/supervisor.h"

namespace ssrkit {

namespace {

using Command = std::function<Expected<int>()>;

constexpr int kWorkerSocket = 3;

void addTest(CLI::App& app, TestOptions& options, Command& command) {
  CLI::App* test = app.add_subcommand("test", "Run the unit tests and every expectation file");
  test->add_option("--filter", options.filter, "Names to run, * stands for any text")->capture_default_str();
  test->add_option("--only", options.only, "unit: no expectation files; expect: nothing else")
      ->check(CLI::IsMember({"unit", "expect"}));
  test->add_option("--tag", options.tags,
                   "Only the expectation files that carry this tag, or one of these; no unit tests");
  test->add_option("--device", options.devices, "Devices of the expectation files that name none");
  test->add_option("--out", options.out, "The folder for results.json")->capture_default_str();
  test->add_flag("--list", options.list, "Print the names instead of running");
  test->add_flag("--json", options.json, "Print results.json instead of the text");
  test->callback([&] { command = [&] { return testCommand(options); }; });
}

void addCompare(CLI::App& app, CompareOptions& options, Command& command) {
  CLI::App* compare =
      app.add_subcommand("compare", "Put what people say of reflections to the test, claim by claim");
  compare->add_option("--claim", options.claims, "A claim by name (default: all of them)");
  compare->add_option("--device", options.devices, "A device of `ssrkit devices`")->capture_default_str();
  compare->add_option("--out", options.out, "The folder for claims.json and report.html")
      ->capture_default_str();
  compare->add_flag("--list", options.list, "Print the claims instead of measuring them");
  compare->add_flag("--json", options.json, "Print claims.json instead of the text");
  compare->callback([&] { command = [&] { return compareCommand(options); }; });
}

void addBless(CLI::App& app, BlessOptions& options, Command& command) {
  CLI::App* bless =
      app.add_subcommand("bless", "Write the goldens of an expectation file, once they are proved right");
  bless->add_option("test", options.test, "The id of an expectation file with truth = \"golden\"")
      ->required();
  bless->add_option("--scene", options.scenes, "A scene of the test (default: all of them)");
  bless->add_option("--device", options.devices, "A device of `ssrkit devices` (default: the test's first)");
  bless->add_option("--why", options.why, "Why what is drawn now is right")->required();
  bless->add_option("--who", options.who, "Who says so (default: git's identity)");
  bless->add_flag("--json", options.json, "Print what was blessed as JSON instead of the text");
  bless->callback([&] { command = [&] { return blessCommand(options); }; });
}

void addMutate(CLI::App& app, MutateOptions& options, Command& command) {
  CLI::App* mutate =
      app.add_subcommand("mutate", "Make known mistakes, one at a time, and see whether the checks notice");
  mutate->add_option("--filter", options.filter, "Mutants and wheats to run, * stands for any text")
      ->capture_default_str();
  mutate->add_option("--out", options.out, "The folder for mutate.json, kill_matrix.csv and report.html")
      ->capture_default_str();
  mutate->add_flag("--first-kill", options.first_kill,
                   "Go on with the next mutant once one check has noticed");
  mutate->add_flag("--list", options.list, "Print the names instead of running");
  mutate->add_flag("--json", options.json, "Print mutate.json instead of the text");
  mutate->callback([&] { command = [&] { return mutateCommand(options); }; });
}

void addCompile(CLI::App& app, CompileCommandOptions& options, Command& command) {
  CLI::App* compile =
      app.add_subcommand("compile", "Show what the compiler says about one shader, for both APIs");
  compile->add_option("file", options.file, "A .vert, .frag or .glsl file; the last is a fragment shader")
      ->required();
  compile->add_flag("--optimise", options.optimise, "Run spirv-opt -O too");
  compile->add_option("--out", options.out, "Write what the devices' drivers are given into this folder");
  compile->add_flag("--json", options.json, "Print JSON");
  compile->callback([&] {
    command = [&] {
      options.shader_root = kitPaths().shaders;
      options.use_colour = wantsColour(STDOUT_FILENO);
      return compileCommand(options);
    };
  });
}

void addDevices(CLI::App& app, DevicesOptions& options, Command& command) {
  CLI::App* devices =
      app.add_subcommand("devices", "Show the devices, their drivers and what the probe found");
  devices->add_option("--device", options.devices, "A device that must be there (default: show all)");
  devices->add_flag("--json", options.json, "Print JSON");
  devices->callback([&] { command = [&] { return devicesCommand(options); }; });
}

Error unknownWord(const std::string& kind, const std::string& word, const std::vector<std::string>& known) {
  const auto nearest = nearestName(word, known);
  return inputError("read the command line", fmt::format("there is no {} '{}'", kind, word), "",
                    nearest ? fmt::format("did you mean '{}'?", *nearest)
                            : fmt::format("the {}s are {}", kind, joinNames(known)))
      .value();
}

// CLI11 tells of a word that it does not know, but not of the nearest one that it does.
Error misread(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error) {
  const auto any = [](const auto*) { return true; };
  if (app.get_subcommands().empty() && words.size() > 1 && !words[1].starts_with('-')) {
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands(any)) {
      commands.push_back(command->get_name());
    }
    return unknownWord("command", words[1], commands);
  }
  for (const CLI::App* command : app.get_subcommands()) {
    std::vector<std::string> options;
    for (const CLI::Option* option : command->get_options(any)) {
      if (!option->get_lnames().empty()) {
        options.push_back("--" + option->get_lnames().front());
      }
    }
    for (const std::string& word : words) {
      const std::string name = word.substr(0, word.find('='));
      if (name.starts_with("--") && std::ranges::find(options, name) == options.end()) {
        return unknownWord("option", name, options);
      }
    }
  }
  const bool is_contradiction = dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr;
  return inputError("read the command line", error.what(), "",
                    is_contradiction ? "leave one of the two out" : "see ./ssrkit --help")
      .value();
}

int commandLine(int argc, char** argv) {
  CLI::App app("Test and teaching kit for screen-space reflections", "ssrkit");
  app.set_version_flag("--version", SSRKIT_VERSION);
  app.require_subcommand(1);
  const std::vector<std::string> command_line(argv, argv + argc);
  RunOptions run;
  TestOptions test;
  CompareOptions compare;
  ConformOptions conform;
  ConformMergeOptions conform_merge;
  MutateOptions mutate;
  BenchOptions bench;
  CompileCommandOptions compile;
  BlessOptions bless;
  DevicesOptions devices;
  run.command = command_line;
  run.command.front() = "./ssrkit";
  test.command = run.command;
  compare.command = run.command;
  conform.command = run.command;
  conform_merge.command = run.command;
  mutate.command = run.command;
  bench.command = run.command;
  Command command;
  addRun(app, run, command);
  addTest(app, test, command);
  addCompare(app, compare, command);
  addConform(app, conform, conform_merge, command);
  addBench(app, bench, command);
  addDevices(app, devices, command);
  addMutate(app, mutate, command);
  addCompile(app, compile, command);
  addBless(app, bless, command);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "ssrkit: {}\n", sentence(misread(app, command_line, error)));
    return 2;
  }
  const Expected<int> code = command();
  if (!code) {
    fmt::print(stderr, "ssrkit: {}\n", sentence(code.error()));
    return exitCode(code.error());
  }
  return *code;
}

// A pipe whose reader has had enough (`| head`) is no failure.
bool hasNoReader(int fd) {
  pollfd watched{fd, POLLOUT, 0};
  return ::poll(&watched, 1, 0) == 1 && (watched.revents & POLLERR) != 0;
}

// `code`, unless some of what was printed went nowhere.
int codeOfOutput(int code) {
  errno = 0;
  const bool is_whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_whole || hasNoReader(STDOUT_FILENO)) {
    return code;
  }
  const auto error = setupError("write to standard output",
                                errno != 0 ? errnoInWords(errno) : "some of it could not be written", {},
                                "free some disk space or write to another place");
  fmt::print(stderr, "ssrkit: {}\n", sentence(error.value()));
  return exitCode(error.value());
}

}  // namespace

}  // namespace ssrkit

int main(int argc, char** argv) try {
  if (argc == 3 && std::strcmp(argv[1], "__worker") == 0) {
    return ssrkit::workerMain(argv[2], ssrkit::kWorkerSocket);
  }
  ssrkit::endCleanlyOnSignals();
  return ssrkit::codeOfOutput(ssrkit::commandLine(argc, argv));
} catch (const std::exception& exception) {
  // Out of memory, out of threads: what no caller can mend.
  std::fprintf(stderr, "ssrkit: could not go on: %s\n", exception.what());
  return 3;
}
