#include "command/process_cost.h"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <thread>

#include "command/child_program.h"

namespace ssrkit {

namespace {

constexpr std::chrono::milliseconds kLook{15};
constexpr double kMibPerKib = 1.0 / 1024.0;

// Field 4 of /proc/PID/stat, after a name in brackets that may hold anything; 0 when the process is gone.
pid_t parentOf(const std::filesystem::path& process) {
  std::ifstream file(process / "stat");
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) {
    return 0;
  }
  std::istringstream rest(line.substr(name_end + 1));
  char state = 0;
  pid_t parent = 0;
  rest >> state >> parent;
  return parent;
}

double memoryMib(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/smaps_rollup", process));
  std::string word;
  while (file >> word) {
    if (word == "Pss:") {
      double kib = 0.0;
      file >> kib;
      return kib * kMibPerKib;
    }
  }
  return 0.0;
}

// Of the process and of everything that it has started.
double treeMemoryMib(pid_t root) {
  std::multimap<pid_t, pid_t> children;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", unreadable)) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::all_of(name, [](unsigned char c) { return std::isdigit(c) != 0; })) {
      children.emplace(parentOf(entry.path()), static_cast<pid_t>(std::stol(name)));
    }
  }
  double sum = 0.0;
  std::vector<pid_t> open = {root};
  while (!open.empty()) {
    const pid_t process = open.back();
    open.pop_back();
    sum += memoryMib(process);
    const auto [first, last] = children.equal_range(process);
    std::transform(first, last, std::back_inserter(open), [](const auto& child) { return child.second; });
  }
  return sum;
}

cpu_set_t usableCores() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  ::sched_getaffinity(0, sizeof(cores), &cores);
  return cores;
}

// While it lives, what this thread starts keeps to the first so many of the usable processors.
class OnCores {
 public:
  explicit OnCores(int count) : before_(usableCores()) {
    cpu_set_t fewer;
    CPU_ZERO(&fewer);
    for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&fewer) < count; ++core) {
      if (CPU_ISSET(core, &before_)) {
        CPU_SET(core, &fewer);
      }
    }
    ::sched_setaffinity(0, sizeof(fewer), count > 0 ? &fewer : &before_);
  }
  ~OnCores() { ::sched_setaffinity(0, sizeof(before_), &before_); }
  OnCores(const OnCores&) = delete;
  OnCores& operator=(const OnCores&) = delete;

 private:
  cpu_set_t before_;
};

}  // namespace

int usableCoreCount() {
  const cpu_set_t cores = usableCores();
  return CPU_COUNT(&cores);
}

Expected<ProcessCost> measureProcess(const std::vector<std::string>& arguments, bool wants_memory,
                                     int core_count) {
  const OnCores kept(core_count);
  ChildProgram program{.arguments = {"/proc/self/exe"}, .output = "/dev/null", .limit = kNoLimit};
  program.arguments.insert(program.arguments.end(), arguments.begin(), arguments.end());
  ProcessCost cost;
  std::function<void(pid_t)> look;
  if (wants_memory) {
    look = [&](pid_t process) {
      cost.peak_memory_mib = std::max(cost.peak_memory_mib, treeMemoryMib(process));
      std::this_thread::sleep_for(kLook);
    };
  }
  const auto begin = std::chrono::steady_clock::now();
  const auto exit_code = runChild(program, look);
  if (!exit_code) {
    return tl::make_unexpected(exit_code.error());
  }
  cost.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  cost.exit_code = *exit_code;
  return cost;
}

}  // namespace ssrkit
