#include "base/background.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <thread>

namespace ssrkit {
namespace {

int priorityOfThisThread() {
  return getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
}

TEST(Background, IsTheThreadThatAsksAndThoseThatItStarts) {
  const int before = priorityOfThisThread();
  ASSERT_LT(before, 19) << "this process is in the background already";
  int own = 0;
  int started = 0;
  std::jthread([&] {
    workInBackground();
    own = priorityOfThisThread();
    std::jthread([&] { started = priorityOfThisThread(); }).join();
  }).join();
  EXPECT_EQ(own, 19);
  EXPECT_EQ(started, 19);
  EXPECT_EQ(priorityOfThisThread(), before);
}

}  // namespace
}  // namespace ssrkit
