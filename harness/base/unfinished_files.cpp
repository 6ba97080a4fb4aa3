#include "base/unfinished_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

#include "base/atomic_file.h"
#include "base/check.h"

namespace ssrkit {

namespace {

// `owner` is the process that writes the file, 0 when the slot is free and kFilling while its name is being
// written. A forked child sees its parent's slots and must leave those files alone.
struct Slot {
  std::atomic<int> owner{0};
  std::array<char, PATH_MAX> path{};
};

constexpr int kFilling = -1;
constexpr std::size_t kSlotCount = 64;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only read lock-free atomics");

std::array<Slot, kSlotCount> slots;

std::size_t claimSlot() {
  for (std::size_t i = 0; i < kSlotCount; ++i) {
    int free = 0;
    if (slots[i].owner.compare_exchange_strong(free, kFilling)) {
      return i;
    }
  }
  checkFailed(__FILE__, __LINE__, "a free slot", "64 files are being written at once");
}

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& temporary) : slot_(claimSlot()) {
  Slot& slot = slots[slot_];
  const std::string& text = temporary.native();
  SSRKIT_CHECK_LT(text.size(), slot.path.size());
  std::memcpy(slot.path.data(), text.c_str(), text.size() + 1);
  slot.owner.store(getpid());
}

UnfinishedFile::~UnfinishedFile() {
  Slot& slot = slots[slot_];
  if (slot.owner.load() == getpid()) {
    unlink(slot.path.data());
    slot.owner.store(0);
  }
}

void UnfinishedFile::release() noexcept {
  slots[slot_].owner.store(0);
}

void removeUnfinishedFiles() noexcept {
  const int self = getpid();
  for (const Slot& slot : slots) {
    if (slot.owner.load() == self) {
      unlink(slot.path.data());
    }
  }
}

}  // namespace ssrkit
