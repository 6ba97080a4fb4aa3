// How children are started.
#pragma once

#include <spawn.h>

#include <string>
#include <utility>
#include <vector>

namespace ssrkit {

// What happens between the start of a child and its program. posix_spawn rather than fork: other threads may
// hold locks, and it returns exec's own error.
class SpawnPlan {
 public:
  SpawnPlan();
  ~SpawnPlan();
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;

  // A process group of its own, and no blocked or ignored signal of ours: SIGXCPU must end the child. 0 or an
  // errno.
  [[nodiscard]] int setGroupAndSignals();

  [[nodiscard]] posix_spawn_file_actions_t* actions() { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

// This process's environment with `own` in the place of theirs.
[[nodiscard]] std::vector<std::string> mergedEnvironment(
    const std::vector<std::pair<std::string, std::string>>& own);

// As exec wants them: null at the end; they live as long as `texts`.
[[nodiscard]] std::vector<char*> pointersTo(std::vector<std::string>& texts);

}  // namespace ssrkit
