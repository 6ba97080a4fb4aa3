#include "shader/front_end.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <glslang/build_info.h>

#include <memory>
#include <optional>

#include "shader/diagnostics.h"
#include "shader/glsl_text.h"

namespace ssrkit {

namespace {

class GlslangProcess {
 public:
  GlslangProcess() { glslang::InitializeProcess(); }
  ~GlslangProcess() { glslang::FinalizeProcess(); }
  GlslangProcess(const GlslangProcess&) = delete;
  GlslangProcess& operator=(const GlslangProcess&) = delete;
};

// Answers from the tree that was read before, so that nothing is compiled that was not hashed.
class TreeIncluder : public glslang::TShader::Includer {
 public:
  explicit TreeIncluder(const SourceTree& tree) : tree_(tree) {}

  IncludeResult* includeLocal(const char* name, const char*, std::size_t) override { return include(name); }
  IncludeResult* includeSystem(const char* name, const char*, std::size_t) override { return include(name); }

  void releaseInclude(IncludeResult* result) override {
    if (result != nullptr && !result->headerName.empty()) {
      open_files_.pop_back();
    }
    const std::unique_ptr<IncludeResult> owner(result);
  }

 private:
  IncludeResult* include(const std::string& name) {
    const std::size_t including = open_files_.back();
    const IncludeEdge* const edge = findEdge(including, name);
    if (edge == nullptr) {
      return refuse(fmt::format("write #include \"{}\" whole on a line of its own", name));
    }
    if (!edge->target) {
      return refuse(edge->refusal);
    }
    const SourceFile& file = tree_.files[*edge->target];
    if (std::find(open_files_.begin(), open_files_.end(), *edge->target) != open_files_.end()) {
      return refuse(fmt::format("'{}' includes itself, straight or through its own includes", name));
    }
    constexpr std::size_t kDepthLimit = 16;
    if (open_files_.size() > kDepthLimit) {
      return refuse(fmt::format("'{}' is nested deeper than {} includes", name, kDepthLimit));
    }
    included_bytes_ += file.text.size();
    if (included_bytes_ > kSourceLimitBytes) {
      return refuse(fmt::format("the included text has more than {} bytes", kSourceLimitBytes));
    }
    open_files_.push_back(*edge->target);
    return new IncludeResult(neutralName(*edge->target), file.text.data(), file.text.size(), nullptr);
  }

  IncludeResult* refuse(std::string why) {
    refusal_ = std::move(why);
    return new IncludeResult("", refusal_.data(), refusal_.size(), nullptr);
  }

  [[nodiscard]] const IncludeEdge* findEdge(std::size_t file, const std::string& name) const {
    for (const IncludeEdge& edge : tree_.files[file].includes) {
      if (edge.name == name) {
        return &edge;
      }
    }
    return nullptr;
  }

  const SourceTree& tree_;
  std::vector<std::size_t> open_files_{0};  // entry first, innermost last
  std::size_t included_bytes_ = 0;
  std::string refusal_;
};

EShLanguage languageOf(ShaderStage stage) {
  return stage == ShaderStage::kVertex ? EShLangVertex : EShLangFragment;
}

EShMessages messagesFor(const FrontEndOptions& options, bool is_hlsl) {
  unsigned flags = EShMsgSpvRules | EShMsgCascadingErrors;
  flags |= options.target == ShaderTarget::kVulkan ? EShMsgVulkanRules : 0U;
  flags |= is_hlsl ? EShMsgReadHlsl : 0U;
  flags |= options.line_numbers ? EShMsgDebugInfo : 0U;
  return static_cast<EShMessages>(flags);
}

void setEnvironment(glslang::TShader& shader, const FrontEndOptions& options, bool is_hlsl) {
  constexpr int kDialectVersion = 100;
  const bool vulkan = options.target == ShaderTarget::kVulkan;
  const glslang::EShClient client = vulkan ? glslang::EShClientVulkan : glslang::EShClientOpenGL;
  const glslang::EShSource language = is_hlsl ? glslang::EShSourceHlsl : glslang::EShSourceGlsl;
  shader.setEnvInput(language, languageOf(options.stage), client, kDialectVersion);
  shader.setEnvClient(client, vulkan ? glslang::EShTargetVulkan_1_1 : glslang::EShTargetOpenGL_450);
  shader.setEnvTarget(glslang::EShTargetSpv, vulkan ? glslang::EShTargetSpv_1_3 : glslang::EShTargetSpv_1_0);
  shader.setEnhancedMsgs();
}

// HLSL's textures and samplers become combined ones, whose sampling the kit sets; registers t0, t1, ... and
// b0 get bindings that do not share a number.
void setHlslBindings(glslang::TShader& shader) {
  constexpr unsigned kFirstTexture = 16;
  shader.setEntryPoint("main");
  shader.setSourceEntryPoint("main");
  shader.setTextureSamplerTransformMode(EShTexSampTransUpgradeTextureRemoveSampler);
  shader.setAutoMapBindings(true);
  shader.setShiftBinding(glslang::EResTexture, kFirstTexture);
  shader.setShiftBinding(glslang::EResSampler, kFirstTexture);
}

std::vector<std::uint32_t> emit(const glslang::TIntermediate& intermediate, bool line_numbers) {
  glslang::SpvOptions options;
  options.generateDebugInfo = line_numbers;
  std::vector<std::uint32_t> words;
  glslang::GlslangToSpv(intermediate, words, &options);
  return words;
}

}  // namespace

void prepareFrontEnd(ShaderTarget target) {
  SourceTree tree;
  tree.files.push_back({"built-in", "built-in", "#version 450\nvoid main() {}\n", {}});
  const FrontEndOptions options{target, ShaderStage::kFragment, {}, false};
  static_cast<void>(translateToSpirv(tree, options, "start the compiler"));
}

Expected<std::vector<std::uint32_t>> translateToSpirv(const SourceTree& tree, const FrontEndOptions& options,
                                                      const std::string& attempted) {
  static const GlslangProcess process;
  const std::string& text = tree.files.front().text;
  const char* const begin = text.data();
  const int size = static_cast<int>(text.size());
  const std::string name = neutralName(0);
  const char* const name_begin = name.c_str();
  glslang::TShader shader(languageOf(options.stage));
  shader.setStringsWithLengthsAndNames(&begin, &size, &name_begin, 1);
  shader.setPreamble(options.preamble.c_str());
  const bool is_hlsl = isHlsl(tree.files.front().path);
  setEnvironment(shader, options, is_hlsl);
  if (is_hlsl) {
    setHlslBindings(shader);
  }
  TreeIncluder includer(tree);
  constexpr int kDefaultVersion = 450;
  const EShMessages messages = messagesFor(options, is_hlsl);
  if (!shader.parse(GetDefaultResources(), kDefaultVersion, ECoreProfile, false, false, messages, includer)) {
    return tl::make_unexpected(errorFromLog(shader.getInfoLog(), tree, attempted));
  }
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages) || (is_hlsl && !program.mapIO())) {
    return tl::make_unexpected(errorFromLog(program.getInfoLog(), tree, attempted));
  }
  return emit(*program.getIntermediate(languageOf(options.stage)), options.line_numbers);
}

std::string frontEndVersion() {
  return fmt::format("glslang {}.{}.{}", GLSLANG_VERSION_MAJOR, GLSLANG_VERSION_MINOR, GLSLANG_VERSION_PATCH);
}

}  // namespace ssrkit
