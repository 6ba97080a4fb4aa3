#include "device/pass_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "base/check.h"
#include "device/format.h"

namespace ssrkit {
namespace {

const SampledImage* findBinding(std::span<const SampledImage> sampled, std::uint32_t binding) {
  const auto found = std::ranges::find(sampled, binding, &SampledImage::binding);
  return found == sampled.end() ? nullptr : &*found;
}

bool isDrawnTo(const PassDesc& pass, const SampledImage& sampled) {
  const auto overlaps = [&](const Attachment& attachment) {
    return attachment.image == sampled.image && attachment.mip >= sampled.base_mip &&
           attachment.mip < sampled.base_mip + sampled.mip_count;
  };
  return std::ranges::any_of(pass.colour, overlaps) || (pass.depth && overlaps(*pass.depth));
}

void checkSampled(const PassDesc& pass, const SampledImage& sampled) {
  SSRKIT_CHECK(sampled.image != nullptr);
  const ImageDesc& desc = sampled.image->desc();
  SSRKIT_CHECK_LE(0, sampled.base_mip);
  SSRKIT_CHECK_LE(1, sampled.mip_count);
  SSRKIT_CHECK_LE(sampled.base_mip + sampled.mip_count, desc.mip_count);
  SSRKIT_CHECK(sampled.filter == Filter::kNearest || !formatInfo(desc.format).is_integer);
  SSRKIT_CHECK(!isDrawnTo(pass, sampled));
}

Size attachmentSize(const PassDesc& pass) {
  const Attachment& first = pass.colour.empty() ? *pass.depth : pass.colour.front();
  SSRKIT_CHECK(first.image != nullptr);
  return mipSize(first.image->desc(), first.mip);
}

void checkAttachment(const Attachment& attachment, Format format, Size size) {
  SSRKIT_CHECK(attachment.image != nullptr);
  const ImageDesc& desc = attachment.image->desc();
  SSRKIT_CHECK(desc.format == format);
  const auto [width, height] = mipSize(desc, attachment.mip);
  SSRKIT_CHECK_LE(size.width, width);
  SSRKIT_CHECK_LE(size.height, height);
}

void checkAttachments(const PassDesc& pass, const ProgramLayout& layout) {
  SSRKIT_CHECK_EQ(pass.colour.size(), layout.colour_formats.size());
  SSRKIT_CHECK_EQ(pass.depth.has_value(), layout.depth_test != DepthTest::kNone);
  SSRKIT_CHECK(!pass.colour.empty() || pass.depth);
  const Size size = attachmentSize(pass);
  for (std::size_t i = 0; i < pass.colour.size(); ++i) {
    checkAttachment(pass.colour[i], layout.colour_formats[i], size);
  }
  if (pass.depth) {
    checkAttachment(*pass.depth, Format::kD32f, size);
  }
}

void checkRect(const Rect& rect, Size size) {
  SSRKIT_CHECK_LE(0, rect.x);
  SSRKIT_CHECK_LE(0, rect.y);
  SSRKIT_CHECK_LE(0, rect.width);
  SSRKIT_CHECK_LE(0, rect.height);
  SSRKIT_CHECK_LE(rect.x + rect.width, size.width);
  SSRKIT_CHECK_LE(rect.y + rect.height, size.height);
}

void checkViewport(const PassDesc& pass) {
  const Size size = attachmentSize(pass);
  SSRKIT_CHECK_LE(1, pass.viewport.width);
  SSRKIT_CHECK_LE(1, pass.viewport.height);
  checkRect(pass.viewport, size);
  checkRect(pass.scissor.value_or(pass.viewport), size);
}

}  // namespace

ProgramLayout layoutOf(const ProgramDesc& desc) {
  return {.name = desc.name,
          .sampler_bindings = desc.sampler_bindings,
          .uniform_bindings = desc.uniform_bindings,
          .vertex_stride_bytes = desc.vertex_stride_bytes,
          .has_vertices = !desc.vertex_attributes.empty(),
          .colour_formats = desc.colour_formats,
          .depth_test = desc.depth_test};
}

Expected<void> checkImageDesc(const ImageDesc& desc, int max_side) {
  const int longest = std::max(desc.size.width, desc.size.height);
  if (std::min(desc.size.width, desc.size.height) < 1 || longest > max_side) {
    return inputError(
        fmt::format("create the image '{}'", desc.name),
        fmt::format("{} x {} texels is outside 1..{} a side", desc.size.width, desc.size.height, max_side),
        {}, "choose another size");
  }
  SSRKIT_CHECK_LE(1, desc.mip_count);
  SSRKIT_CHECK_LE(desc.mip_count, static_cast<int>(std::bit_width(static_cast<unsigned>(longest))));
  return {};
}

void checkUpload(const ImageDesc& desc, int mip, std::span<const std::byte> bytes) {
  SSRKIT_CHECK_EQ(bytes.size(), mipByteCount(desc, mip));
}

void checkCopy(const ImageDesc& from, int mip, Size size, const ImageDesc& to, int x, int y) {
  SSRKIT_CHECK(from.format == to.format);
  const auto [width, height] = mipSize(from, mip);
  SSRKIT_CHECK_LE(size.width, width);
  SSRKIT_CHECK_LE(size.height, height);
  SSRKIT_CHECK_LE(0, x);
  SSRKIT_CHECK_LE(0, y);
  SSRKIT_CHECK_LE(x + size.width, to.size.width);
  SSRKIT_CHECK_LE(y + size.height, to.size.height);
}

Expected<void> checkPass(const PassDesc& pass, const ProgramLayout& layout) {
  checkAttachments(pass, layout);
  checkViewport(pass);
  SSRKIT_CHECK_EQ(pass.vertices != nullptr, layout.has_vertices);
  std::ranges::for_each(pass.sampled, [&](const SampledImage& sampled) { checkSampled(pass, sampled); });
  for (const DrawCall& draw : pass.draws) {
    std::ranges::for_each(draw.sampled, [&](const SampledImage& sampled) { checkSampled(pass, sampled); });
    for (const std::uint32_t binding : layout.sampler_bindings) {
      if (findBinding(pass.sampled, binding) == nullptr && findBinding(draw.sampled, binding) == nullptr) {
        return inputError(
            fmt::format("draw the pass '{}'", pass.name),
            fmt::format("its shader has a sampler at binding {} and the pass has no image there", binding),
            layout.name, "use a binding that the pass supplies");
      }
    }
  }
  for (const std::uint32_t binding : layout.uniform_bindings) {
    if (pass.uniforms.empty() || binding != pass.uniform_binding) {
      return inputError(
          fmt::format("draw the pass '{}'", pass.name),
          fmt::format("its shader has a uniform block at binding {} and the pass has none there", binding),
          layout.name, "use the block that the pass supplies");
    }
  }
  return {};
}

void checkVertexRanges(const PassDesc& pass, const ProgramLayout& layout, std::size_t buffer_byte_count) {
  for (const DrawCall& draw : pass.draws) {
    const std::size_t end_vertex = std::size_t{draw.first_vertex} + draw.vertex_count;
    SSRKIT_CHECK_LE(end_vertex * layout.vertex_stride_bytes, buffer_byte_count);
  }
}

}  // namespace ssrkit
