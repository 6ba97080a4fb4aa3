#pragma once

#include <cstdint>
#include <memory>

#include "device/gl/gl_object.h"

namespace ssrkit {

// A pair of GL timestamps. llvmpipe stamps the last tile that it has begun, not the last one that was asked
// for, so each stamp stands between two flushes.
class GlTimestamps {
 public:
  explicit GlTimestamps(std::shared_ptr<GlSession> session);

  void begin() { stamp(begin_); }
  void end() { stamp(end_); }

  // Nanoseconds between the two; waits for them.
  [[nodiscard]] std::int64_t elapsedNs() const;

 private:
  void stamp(const GlObject& query);

  std::shared_ptr<GlSession> session_;
  GlObject begin_;
  GlObject end_;
};

}  // namespace ssrkit
