#include "environment/parallel.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

namespace ssrkit {

void forEachInParallel(int count, const std::function<void(int)>& piece) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next.fetch_add(1); i < count; i = next.fetch_add(1)) {
      piece(i);
    }
  };
  std::vector<std::jthread> threads;
  const int core_count = static_cast<int>(std::thread::hardware_concurrency());
  try {
    for (int i = 1; i < std::min(core_count, count); ++i) {
      threads.emplace_back(work);
    }
  } catch (const std::system_error&) {
    // No more threads to be had: those that there are do the work, this one at least.
  }
  work();
}

}  // namespace ssrkit
