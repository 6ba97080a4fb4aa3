// Where a GL context comes from: OSMesa today, EGL where Mesa no longer has it.
#pragma once

namespace ssrkit {

class GlContext {
 public:
  using Procedure = void (*)();

  virtual ~GlContext() = default;
  // Binds the context to the calling thread, unless it is bound already.
  virtual void makeCurrent() = 0;
  [[nodiscard]] virtual Procedure procedure(const char* name) const = 0;
};

}  // namespace ssrkit
