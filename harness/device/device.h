// The one seam between the kit and a graphics API. Everything is synchronous: when a call returns, its
// results are there (on the host for reads). Descriptors are plain structs; handles are move-only and free
// themselves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/size.h"

namespace ssrkit {

enum class Format { kR8ui, kRgba8, kRgba8Srgb, kRg16i, kRgba16ui, kRgba16f, kR32f, kRg32f, kRgba32f, kD32f };

struct FormatInfo {
  int channel_count;
  std::size_t bytes_per_texel;
  bool is_integer;  // read by isampler/usampler, cleared with integers
};
[[nodiscard]] FormatInfo formatInfo(Format format);

struct ImageDesc {
  std::string name;  // for messages
  Format format = Format::kRgba32f;
  Size size;
  int mip_count = 1;  // mip n has size max(1, size >> n)
};

class DeviceImage {
 public:
  virtual ~DeviceImage() = default;
  [[nodiscard]] virtual const ImageDesc& desc() const = 0;
};

class DeviceBuffer {  // vertices or uniforms
 public:
  virtual ~DeviceBuffer() = default;
};

enum class VertexFormat { kFloat1, kFloat2, kFloat3, kFloat4 };
struct VertexAttribute {
  std::uint32_t location = 0;
  VertexFormat format = VertexFormat::kFloat4;
  std::uint32_t offset_bytes = 0;
};

struct SpecConstant {
  std::uint32_t id = 0;
  std::uint32_t bits = 0;  // the 32-bit pattern of an int, uint, float or bool (0/1)
};

// What becomes of the depth (kD32f) that is stored where a program draws.
enum class DepthTest {
  kNone,    // there is none
  kNearer,  // drawn where it is nearer than what is stored, and takes its place
  kBehind,  // drawn where it is farther than what is stored, which stays
};

struct ProgramDesc {
  std::string name;
  std::span<const std::uint32_t> vertex_spirv;
  std::span<const std::uint32_t> fragment_spirv;
  std::vector<SpecConstant> spec_constants;        // ids that a stage does not declare are not passed to it
  std::vector<std::uint32_t> vertex_constant_ids;  // ids declared by each stage (from reflection)
  std::vector<std::uint32_t> fragment_constant_ids;
  std::vector<std::uint32_t> sampler_bindings;  // from reflection, both stages
  std::vector<std::uint32_t> uniform_bindings;
  std::vector<VertexAttribute> vertex_attributes;  // empty: one triangle from gl_VertexID/gl_VertexIndex
  std::uint32_t vertex_stride_bytes = 0;
  std::vector<Format> colour_formats;  // what it draws to, in the order of locations
  DepthTest depth_test = DepthTest::kNone;
};

class DeviceProgram {
 public:
  virtual ~DeviceProgram() = default;
};

enum class Filter { kNearest, kLinear };
enum class AddressMode { kClamp, kRepeat, kMirror };

struct SampledImage {
  std::uint32_t binding = 0;
  const DeviceImage* image = nullptr;
  int base_mip = 0;  // the shader sees mips base_mip .. base_mip + mip_count - 1 as 0 ..
  int mip_count = 1;
  Filter filter = Filter::kNearest;
  AddressMode address_u = AddressMode::kClamp;
  AddressMode address_v = AddressMode::kClamp;
};

struct Attachment {
  DeviceImage* image = nullptr;
  int mip = 0;
  std::optional<std::array<double, 4>> clear;  // absent: keep what is there
};

struct Rect {
  int x = 0;  // from the upper left
  int y = 0;
  int width = 0;
  int height = 0;
};

// One range of vertices; `sampled` is added to the pass's own (textures that change by material).
struct DrawCall {
  std::uint32_t first_vertex = 0;
  std::uint32_t vertex_count = 3;
  std::vector<SampledImage> sampled;
};

struct PassDesc {
  std::string name;
  const DeviceProgram* program = nullptr;
  std::vector<SampledImage> sampled;
  std::uint32_t uniform_binding = 0;
  std::span<const std::byte> uniforms;  // one std140 block, empty when the program has none
  const DeviceBuffer* vertices = nullptr;
  // The first one's size (the depth's without any) is the pass's. Others may be larger: what they hold beside
  // that size is lost when they are cleared, and stays as it is otherwise.
  std::vector<Attachment> colour;
  std::optional<Attachment> depth;
  Rect viewport;
  std::optional<Rect> scissor = {};  // texels outside keep what they hold; may be empty; absent: the viewport
  std::vector<DrawCall> draws{DrawCall{}};
};

// Around submit and fence (or draw and finish). CPU time is of this process, all threads: the rasteriser's
// own.
struct PassTime {
  std::int64_t wall_ns = 0;
  std::int64_t cpu_ns = 0;
  std::optional<std::int64_t> device_ns;  // the API's timestamps, where the device has them; never gated on
};

struct DeviceIdentity {
  std::string id;                         // "gl-osmesa"
  std::string api;                        // "OpenGL 4.5 core", "Vulkan 1.3.230"
  std::string driver;                     // "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version;                    // "Mesa 22.3.6"
  std::string cpu;                        // model name
  std::vector<std::string> cpu_features;  // "avx2", "avx512f", ...
};

class Device {
 public:
  virtual ~Device() = default;
  [[nodiscard]] virtual const DeviceIdentity& identity() const = 0;
  // What its driver is given of a program's SPIR-V: "SPIR-V", or the language that it is translated to.
  [[nodiscard]] virtual std::string shaderInput() const { return "SPIR-V"; }

  [[nodiscard]] virtual Expected<std::unique_ptr<DeviceImage>> createImage(const ImageDesc& desc) = 0;
  [[nodiscard]] virtual Expected<std::unique_ptr<DeviceBuffer>> createVertexBuffer(
      std::span<const std::byte> bytes) = 0;
  [[nodiscard]] virtual Expected<std::unique_ptr<DeviceProgram>> createProgram(const ProgramDesc& desc) = 0;

  // Tightly packed rows, row 0 on top; the span's size must fit the mip exactly.
  [[nodiscard]] virtual Expected<void> upload(DeviceImage& image, int mip,
                                              std::span<const std::byte> bytes) = 0;
  [[nodiscard]] virtual Expected<std::vector<std::byte>> read(const DeviceImage& image, int mip) = 0;

  // Copies the upper left `size` texels of a mip of `from` to `to` (its mip 0), where their corner comes to
  // stand at (x, y). Same format.
  [[nodiscard]] virtual Expected<void> copy(const DeviceImage& from, int mip, Size size, DeviceImage& to,
                                            int x, int y) = 0;

  // Draws and waits. A pass may not sample a mip that it draws to.
  [[nodiscard]] virtual Expected<PassTime> draw(const PassDesc& pass) = 0;

  // Messages of the driver and the validation layer since the last call; each one fails the job that caused
  // it.
  [[nodiscard]] virtual std::vector<std::string> drainMessages() = 0;
};

}  // namespace ssrkit
