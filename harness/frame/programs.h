// Compiled passes: SPIR-V of both stages with the device's program, made once and kept.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "frame/frame_images.h"
#include "frame/setup_times.h"
#include "frame/uniform_values.h"
#include "shader/compiler.h"

namespace ssrkit {

// A pass as data: which shaders, what it draws to. Its inputs are the names of the samplers that the shaders
// declare.
struct PassRow {
  std::string name;           // for reports and replacements: "gbuffer", "trace_hiz_tuned"
  std::string vertex_shader;  // entry files under the shader root
  std::string fragment_shader;
  std::vector<Format> colour_formats;  // in the order of the fragment shader's output locations
  DepthTest depth_test = DepthTest::kNone;
  std::vector<VertexAttribute> vertex_attributes;
  std::uint32_t vertex_stride_bytes = 0;
  // Values of specialisation constants, by name; those that no shader declares change nothing, and those that
  // are not here have the shader's own value.
  std::map<std::string, UniformConstant> constants = {};
};

struct Program {
  std::string shader;  // the fragment shader's file, for messages
  std::unique_ptr<DeviceProgram> device_program;
  std::vector<SamplerBinding> samplers;       // of both stages
  std::optional<UniformBlock> uniform_block;  // at most one
  std::size_t target_count = 0;               // colour images that it draws to
};

struct CompileSettings {
  std::filesystem::path shader_root;
  std::map<std::string, std::filesystem::path> replacements;  // by pass name
  ModuleForm form = ModuleForm::kPlain;
};

class Programs {
 public:
  Programs(Device& device, ShaderTarget target) : device_(device), target_(target) {}

  // Compiles at the first use. Errors name the author's file and line.
  [[nodiscard]] Expected<const Program*> get(const PassRow& pass, const CompileSettings& settings);

  // Of every pass that was asked for since the last call.
  std::set<std::string> takePassNames() { return std::exchange(pass_names_, {}); }

  // Of every program made since the last call.
  [[nodiscard]] SetupTimes takeTimes() { return std::exchange(times_, {}); }

 private:
  [[nodiscard]] Expected<Program> make(const PassRow& pass, const CompileSettings& settings);

  Device& device_;
  ShaderTarget target_;
  std::set<std::string> pass_names_;
  SetupTimes times_;
  // By everything that a program is made of; a replaced file is compiled anew for each job, it may have been
  // edited.
  std::map<std::string, Program> kept_;
};

// The images that a program's samplers name, found in `images`; `aliases` gives a sampler an image of another
// name. Fails on names that no image has.
[[nodiscard]] Expected<std::vector<SampledImage>> bindSamplers(
    const Program& program, const FrameImages& images,
    const std::map<std::string, SampledImage>& aliases = {});

// Draws one full-screen pass: samplers and uniforms by name, the given attachments.
struct FullScreenPass {
  const PassRow* row = nullptr;
  std::vector<Attachment> targets;
  std::optional<Attachment> depth = std::nullopt;
  Rect viewport;
  std::map<std::string, SampledImage> aliases;
  int layer = 0;  // its depth: layer 0 at the far end, each one nearer than the one before
};
[[nodiscard]] Expected<PassTime> drawFullScreen(Device& device, const Program& program,
                                                const FullScreenPass& pass, const FrameImages& images,
                                                const UniformValues& values);

}  // namespace ssrkit
