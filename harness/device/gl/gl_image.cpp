#include "device/gl/gl_image.h"

#include <fmt/format.h>

#include <limits>

#include "base/check.h"
#include "device/format.h"
#include "device/gl/gl_formats.h"
#include "device/pass_rules.h"

namespace ssrkit {
namespace {

// GL counts the bytes of a read-back in a GLsizei.
constexpr std::size_t kMostBytes = std::numeric_limits<GLsizei>::max();

}  // namespace

GlImage::GlImage(std::shared_ptr<GlSession> session, ImageDesc desc)
    : session_(std::move(session)), desc_(std::move(desc)), texture_(createTexture(session_)) {
  session_->gl().TextureStorage2D(texture_.name(), desc_.mip_count, glFormat(desc_.format).internal,
                                  desc_.size.width, desc_.size.height);
}

Expected<std::unique_ptr<GlImage>> GlImage::create(const std::shared_ptr<GlSession>& session,
                                                   const ImageDesc& desc) {
  if (const auto valid = checkImageDesc(desc, session->integer(GL_MAX_TEXTURE_SIZE)); !valid) {
    return tl::unexpected(valid.error());
  }
  const std::string attempted = fmt::format("create the image '{}' of {} x {} texels ({})", desc.name,
                                            desc.size.width, desc.size.height, formatName(desc.format));
  if (mipByteCount(desc, 0) > kMostBytes) {
    return setupError(
        attempted,
        fmt::format("its {} bytes are more than OpenGL's limit of {}", mipByteCount(desc, 0), kMostBytes), {},
        "choose a smaller size");
  }
  std::unique_ptr<GlImage> image(new GlImage(session, desc));
  if (const auto created = session->failOnMessages(attempted, "choose a smaller size"); !created) {
    return tl::unexpected(created.error());
  }
  return image;
}

GLuint GlImage::view(int base_mip, int mip_count) const {
  if (base_mip == 0 && mip_count == desc_.mip_count) {
    return texture();
  }
  const auto [entry, is_new] = views_.try_emplace({base_mip, mip_count});
  if (is_new) {
    entry->second = createTextureName(session_);
    session_->gl().TextureView(entry->second.name(), GL_TEXTURE_2D, texture(),
                               glFormat(desc_.format).internal, static_cast<GLuint>(base_mip),
                               static_cast<GLuint>(mip_count), 0, 1);
  }
  return entry->second.name();
}

void GlImage::upload(int mip, std::span<const std::byte> bytes) {
  checkUpload(desc_, mip, bytes);
  const Size size = mipSize(desc_, mip);
  const GlFormat format = glFormat(desc_.format);
  session_->gl().TextureSubImage2D(texture(), mip, 0, 0, size.width, size.height, format.transfer,
                                   format.component, bytes.data());
}

std::vector<std::byte> GlImage::read(int mip) const {
  const GlFormat format = glFormat(desc_.format);
  std::vector<std::byte> bytes(mipByteCount(desc_, mip));
  session_->gl().GetTextureImage(texture(), mip, format.transfer, format.component,
                                 static_cast<GLsizei>(bytes.size()), bytes.data());
  return bytes;
}

const GlImage& glImage(const DeviceImage& image) {
  const auto* const own = dynamic_cast<const GlImage*>(&image);
  SSRKIT_CHECK(own != nullptr);
  return *own;
}

GlImage& glImage(DeviceImage& image) {
  auto* const own = dynamic_cast<GlImage*>(&image);
  SSRKIT_CHECK(own != nullptr);
  return *own;
}

}  // namespace ssrkit
