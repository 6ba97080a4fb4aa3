#include "command/compile_names.h"

namespace ssrkit {

std::string apiName(ShaderTarget target) {
  return target == ShaderTarget::kVulkan ? "Vulkan 1.1" : "OpenGL 4.5";
}

std::string scalarName(ScalarType type) {
  return type == ScalarType::kFloat ? "float" : type == ScalarType::kInt ? "int" : "uint";
}

std::string samplerName(SamplerKind kind) {
  return kind == SamplerKind::kFloat ? "sampler" : kind == SamplerKind::kInt ? "isampler" : "usampler";
}

}  // namespace ssrkit
