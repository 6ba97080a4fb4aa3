#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "device/device.h"
#include "device/gl/gl_object.h"

namespace ssrkit {

// One sampler object for each way of reading, made when first asked for.
class GlSamplers {
 public:
  explicit GlSamplers(std::shared_ptr<GlSession> session) : session_(std::move(session)) {}

  [[nodiscard]] GLuint find(const SampledImage& sampled);

 private:
  std::shared_ptr<GlSession> session_;
  std::map<std::tuple<Filter, AddressMode, AddressMode>, GlObject> samplers_;
};

}  // namespace ssrkit
