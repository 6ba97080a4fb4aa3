#include "command/git_state.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "base/text.h"

namespace ssrkit {

namespace {

// Starts git with its standard output in `pipe_end`; 0 when it cannot be started.
pid_t startGit(const std::vector<std::string>& arguments, int pipe_end) {
  std::vector<std::string> words = {"git"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe_end, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawnp(&child, "git", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : 0;
}

// What git prints, where it succeeds.
std::optional<std::string> git(const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return std::nullopt;
  }
  const pid_t child = startGit(arguments, ends[1]);
  close(ends[1]);
  std::string output;
  std::array<char, 4096> part{};
  for (ssize_t count = 1; child > 0 && count != 0;) {
    count = read(ends[0], part.data(), part.size());
    if (count < 0 && errno != EINTR) {
      break;
    }
    output.append(part.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  close(ends[0]);
  int status = -1;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const bool done = child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return done ? std::optional(output) : std::nullopt;
}

}  // namespace

std::optional<std::string> gitIdentity(const std::filesystem::path& root) {
  auto identity = git({"-C", root.string(), "var", "GIT_AUTHOR_IDENT"});  // "Name <mail> 1767225600 +0000"
  const std::size_t end = identity ? identity->find('>') : std::string::npos;
  return end == std::string::npos ? std::nullopt : std::optional(identity->substr(0, end + 1));
}

std::optional<std::vector<std::string>> changedFiles(const std::filesystem::path& root,
                                                     const std::vector<std::string>& folders) {
  std::vector<std::string> arguments = {"-C", root.string(), "status", "--porcelain", "--"};
  arguments.insert(arguments.end(), folders.begin(), folders.end());
  const auto output = git(arguments);
  if (!output) {
    return std::nullopt;
  }
  constexpr std::size_t kStatusLetters = 3;  // "?? " before each name
  std::vector<std::string> files;
  for (const std::string& line : split(*output, '\n')) {
    if (line.size() > kStatusLetters) {
      files.push_back(line.substr(kStatusLetters));
    }
  }
  return files;
}

}  // namespace ssrkit
