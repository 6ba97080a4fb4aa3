#include "base/share_out.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <set>
#include <stdexcept>
#include <thread>

namespace ssrkit {
namespace {

TEST(ShareOut, EveryPieceIsDoneOnce) {
  std::array<std::atomic<int>, 100> done{};
  for (const int lanes : {0, 1, 3, 200}) {
    forEachInParallel(100, lanes, [&](int i) { ++done.at(static_cast<std::size_t>(i)); });
  }
  for (const std::atomic<int>& times : done) {
    EXPECT_EQ(4, times);
  }
  forEachInParallel(0, 4, [](int) { FAIL() << "there is no piece"; });
}

TEST(ShareOut, ALaneIsMadeInItsThreadAndKeptFromPieceToPiece) {
  std::atomic<int> pieces = 0;
  std::atomic<int> strangers = 0;
  shareOut(50, 3, [&](int number) -> Lane {
    EXPECT_TRUE(number >= 0 && number < 3);
    return [&, maker = std::this_thread::get_id()](int) {
      ++pieces;
      strangers += maker == std::this_thread::get_id() ? 0 : 1;
    };
  });
  EXPECT_EQ(50, pieces);
  EXPECT_EQ(0, strangers);
}

TEST(ShareOut, AnExceptionOfALaneEndsTheWorkAndIsThrownHere) {
  std::atomic<int> begun = 0;
  const auto fail = [&](int i) {
    ++begun;
    if (i == 7) {
      throw std::runtime_error("piece 7");
    }
  };
  for (const int lanes : {1, 4}) {
    EXPECT_THROW(forEachInParallel(1'000'000'000, lanes, fail), std::runtime_error);
  }
  EXPECT_LT(begun, 1'000'000'000);
  EXPECT_THROW(shareOut(9, 4, [](int) -> Lane { throw std::runtime_error("no lane"); }), std::runtime_error);
}

// The address space that is left has no room for a thread's stack.
[[noreturn]] void workWithoutThreads() {
  std::ifstream statm("/proc/self/statm");
  rlim_t pages = 0;
  statm >> pages;
  const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{1} << 20);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
  std::set<int> done;
  forEachInParallel(20, 4, [&](int i) { done.insert(i); });
  _exit(done.size() == 20 ? 0 : 1);
}

TEST(ShareOut, WithoutMoreThreadsThisOneDoesTheWork) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer reserves the address space itself";
#endif
  EXPECT_EXIT(workWithoutThreads(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace ssrkit
