#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "device/gl/gl_object.h"

namespace ssrkit {

class GlImage final : public DeviceImage {
 public:
  [[nodiscard]] static Expected<std::unique_ptr<GlImage>> create(const std::shared_ptr<GlSession>& session,
                                                                 const ImageDesc& desc);

  [[nodiscard]] const ImageDesc& desc() const override { return desc_; }
  [[nodiscard]] GLuint texture() const { return texture_.name(); }

  // A texture that holds just these mips, so that a sampler cannot see one that is drawn to. Made once, then
  // kept.
  [[nodiscard]] GLuint view(int base_mip, int mip_count) const;

  void upload(int mip, std::span<const std::byte> bytes);
  [[nodiscard]] std::vector<std::byte> read(int mip) const;

 private:
  GlImage(std::shared_ptr<GlSession> session, ImageDesc desc);

  std::shared_ptr<GlSession> session_;
  ImageDesc desc_;
  GlObject texture_;
  mutable std::map<std::pair<int, int>, GlObject> views_;
};

// The image as GL's own; it must have been made by a GL device.
[[nodiscard]] const GlImage& glImage(const DeviceImage& image);
[[nodiscard]] GlImage& glImage(DeviceImage& image);

}  // namespace ssrkit
