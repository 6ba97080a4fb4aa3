// What every device asks of its callers, written once so that the devices cannot disagree about it.
// Broken rules are of two kinds: those that a user's shader can break come back as an Error, the rest are
// checks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"

namespace ssrkit {

// What a device keeps of a ProgramDesc.
struct ProgramLayout {
  std::string name;
  std::vector<std::uint32_t> sampler_bindings;
  std::vector<std::uint32_t> uniform_bindings;
  std::uint32_t vertex_stride_bytes = 0;
  bool has_vertices = false;
  std::vector<Format> colour_formats;
  DepthTest depth_test = DepthTest::kNone;
};
[[nodiscard]] ProgramLayout layoutOf(const ProgramDesc& desc);

// Fails when a side is not in 1..max_side; mip_count must be in 1..log2(longest side) + 1.
[[nodiscard]] Expected<void> checkImageDesc(const ImageDesc& desc, int max_side);

// The span's size is the mip's, to the byte.
void checkUpload(const ImageDesc& desc, int mip, std::span<const std::byte> bytes);

// One format, and `size` lies inside the mip of `from` and, at (x, y), inside mip 0 of `to`.
void checkCopy(const ImageDesc& from, int mip, Size size, const ImageDesc& to, int x, int y);

// Fails when the program reads a sampler or a block that the pass does not supply. Checks that the
// attachments are the program's, none smaller than the first, that viewport and scissor lie inside them, that
// no mip is both drawn to and sampled, and that integer images are not filtered.
[[nodiscard]] Expected<void> checkPass(const PassDesc& pass, const ProgramLayout& layout);

// No draw reads past the vertex buffer's end.
void checkVertexRanges(const PassDesc& pass, const ProgramLayout& layout, std::size_t buffer_byte_count);

}  // namespace ssrkit
