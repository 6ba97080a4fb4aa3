// Where a GL context comes from: OSMesa or EGL. Both draw without a window.
#pragma once

namespace ssrkit {

struct GlVersion {
  int major = 4;
  int minor = 5;
};

class GlContext {
 public:
  using Procedure = void (*)();

  virtual ~GlContext() = default;
  // Binds the context to the calling thread, unless it is bound already.
  virtual void makeCurrent() = 0;
  [[nodiscard]] virtual Procedure procedure(const char* name) const = 0;
};

}  // namespace ssrkit
