#include "oracle/rows.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>
#include <vector>

#include "base/check.h"

namespace ssrkit {

void forEachRow(int height, int thread_count, const std::function<void(int)>& work) {
  SSRKIT_CHECK_LE(0, thread_count);
  std::atomic<int> next_row = 0;
  const auto work_on_rows = [&] {
    for (int y = next_row++; y < height; y = next_row++) {
      work(y);
    }
  };
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int threads = std::min(thread_count == 0 ? cores : thread_count, height);
  std::vector<std::jthread> helpers;
  try {
    for (int helper = 1; helper < threads; ++helper) {
      helpers.emplace_back(work_on_rows);
    }
  } catch (const std::system_error&) {
    // The machine gives no more threads: those that run do the work.
  }
  work_on_rows();
}

}  // namespace ssrkit
