// What the driver complains about, through KHR_debug and glGetError.
#pragma once

#include <glad/gl.h>

#include <string>
#include <vector>

namespace ssrkit {

class GlMessages {
 public:
  // Keeps errors, undefined behaviour and everything of medium or high severity but compilers' warnings.
  // `this` must outlive the context.
  void listen(const GladGLContext& gl);

  // Since the last call.
  [[nodiscard]] std::vector<std::string> drain(const GladGLContext& gl);

 private:
  std::vector<std::string> messages_;
};

}  // namespace ssrkit
