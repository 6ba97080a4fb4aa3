#include "base/share_out.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/check.h"

namespace ssrkit {

void shareOut(int count, int lane_count, const std::function<Lane(int)>& make_lane) {
  SSRKIT_CHECK_LE(0, lane_count);
  std::atomic<int> next = 0;
  std::once_flag failed;
  std::exception_ptr failure;
  const auto work = [&](int number) {
    try {
      const Lane lane = make_lane(number);
      for (int i = next++; i < count; i = next++) {
        lane(i);
      }
    } catch (...) {
      std::call_once(failed, [&] { failure = std::current_exception(); });
      next = count;
    }
  };
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  {
    std::vector<std::jthread> helpers;
    try {
      for (int number = 1; number < std::min(lane_count == 0 ? cores : lane_count, count); ++number) {
        helpers.emplace_back(work, number);
      }
    } catch (const std::system_error&) {
      // The machine gives no more threads: those that run do the work.
    }
    work(0);
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

void forEachInParallel(int count, int lane_count, const Lane& piece) {
  shareOut(count, lane_count, [&piece](int) { return piece; });
}

}  // namespace ssrkit
