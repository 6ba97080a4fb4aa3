#include "device/gl/gl_timestamps.h"

#include <utility>

namespace ssrkit {

GlTimestamps::GlTimestamps(std::shared_ptr<GlSession> session)
    : session_(std::move(session)), begin_(createTimestamp(session_)), end_(createTimestamp(session_)) {}

std::int64_t GlTimestamps::elapsedNs() const {
  GLint64 begin_ns = 0;
  GLint64 end_ns = 0;
  session_->gl().GetQueryObjecti64v(begin_.name(), GL_QUERY_RESULT, &begin_ns);
  session_->gl().GetQueryObjecti64v(end_.name(), GL_QUERY_RESULT, &end_ns);
  return end_ns - begin_ns;
}

void GlTimestamps::stamp(const GlObject& query) {
  const GladGLContext& gl = session_->gl();
  gl.Flush();
  gl.QueryCounter(query.name(), GL_TIMESTAMP);
  gl.Flush();
}

}  // namespace ssrkit
