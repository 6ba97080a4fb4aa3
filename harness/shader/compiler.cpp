#include "shader/compiler.h"

#include <fmt/format.h>

#include <array>
#include <mutex>
#include <shared_mutex>
#include <utility>

#include "shader/diagnostics.h"
#include "shader/endless_loop.h"
#include "shader/front_end.h"
#include "shader/isolated.h"
#include "shader/module_bytes.h"
#include "shader/reflect.h"
#include "shader/source_tree.h"
#include "shader/spirv_cache.h"
#include "shader/spirv_tools.h"

namespace ssrkit {

namespace {

struct Task {
  const SourceTree& tree;
  FrontEndOptions options;
  ModuleForm form = ModuleForm::kPlain;
  std::string attempted;

  [[nodiscard]] const std::string& where() const { return tree.files.front().shown_path; }
};

std::string targetName(ShaderTarget target) {
  return target == ShaderTarget::kVulkan ? "Vulkan" : "OpenGL";
}

Error endlessLoopError(const Task& task, std::size_t loop_index) {
  Error error{ErrorKind::kInput,
              task.attempted,
              "a loop never ends: no path leaves it",
              task.where(),
              "give it a condition or a break that every run comes to",
              {}};
  FrontEndOptions with_lines = task.options;
  with_lines.line_numbers = true;
  const auto spirv = translateToSpirv(task.tree, with_lines, task.attempted);
  const auto line = spirv ? findLineOfLoop(*spirv, loop_index) : std::nullopt;
  const auto file = line ? fileIndex(line->file) : std::nullopt;
  if (file && *file < task.tree.files.size()) {
    error.problem = fmt::format("the loop at line {} never ends: no path leaves it", line->line);
    error.where = placeInTree(task.tree, *file, line->line);
  }
  return error;
}

Expected<ShaderModule> buildModule(const Task& task) {
  Expected<std::vector<std::uint32_t>> spirv = translateToSpirv(task.tree, task.options, task.attempted);
  if (!spirv) {
    return tl::make_unexpected(spirv.error());
  }
  if (const std::optional<std::size_t> loop = findEndlessLoop(*spirv)) {
    return tl::make_unexpected(endlessLoopError(task, *loop));
  }
  const auto validate = [&task](const std::vector<std::uint32_t>& words) {
    return validateSpirv(words, task.options.target, task.where(), task.attempted);
  };
  if (const Expected<void> valid = validate(*spirv); !valid) {
    return tl::make_unexpected(valid.error());
  }
  if (task.form != ModuleForm::kPlain) {
    spirv = rewriteSpirv(*spirv, task.form, task.options.target, task.where(), task.attempted);
    if (!spirv) {
      return tl::make_unexpected(spirv.error());
    }
    if (const Expected<void> valid = validate(*spirv); !valid) {
      return tl::make_unexpected(valid.error());
    }
  }
  return reflectSpirv(*spirv, task.where(), task.attempted).map([&spirv](ShaderInterface interface) {
    return ShaderModule{std::move(*spirv), std::move(interface), {}, false};
  });
}

// The first byte of the child's answer.
constexpr char kModuleFollows = 'm';
constexpr char kErrorFollows = 'e';

std::string buildToBytes(const Task& task) {
  const Expected<ShaderModule> module = buildModule(task);
  return module ? kModuleFollows + toBytes(*module) : kErrorFollows + toBytes(module.error());
}

std::string describeEnd(const IsolatedResult& result) {
  switch (result.end) {
    case IsolationEnd::kOverTime:
      return "the compiler did not finish in time; a macro or an expression grows without bound";
    case IsolationEnd::kOutOfMemory:
      return "the compiler ran out of memory; a macro or an expression grows without bound";
    default:
      return fmt::format("the compiler itself crashed on it ({}); is an expression nested very deep?",
                         result.details);
  }
}

Expected<ShaderModule> readAnswer(const IsolatedResult& result, const Task& task) {
  if (result.end == IsolationEnd::kNotStarted) {
    return setupError(task.attempted, fmt::format("no process for the compiler: {}", result.details));
  }
  if (result.end == IsolationEnd::kDone && result.bytes.starts_with(kModuleFollows)) {
    if (std::optional<ShaderModule> module = moduleFromBytes(std::string_view(result.bytes).substr(1))) {
      return std::move(*module);
    }
  }
  if (result.end == IsolationEnd::kDone && result.bytes.starts_with(kErrorFollows)) {
    if (std::optional<Error> error = errorFromBytes(std::string_view(result.bytes).substr(1))) {
      return tl::make_unexpected(std::move(*error));
    }
  }
  return inputError(task.attempted, describeEnd(result), task.where(), "make it simpler");
}

Expected<ShaderModule> buildIsolated(const Task& task) {
  // A child that is forked while another thread is inside glslang would inherit its locks, taken for ever.
  static std::shared_mutex mutex;
  static std::array<bool, 2> is_prepared{};
  bool& prepared = is_prepared.at(static_cast<std::size_t>(task.options.target));
  {
    const std::unique_lock alone(mutex);
    if (!std::exchange(prepared, true)) {
      prepareFrontEnd(task.options.target);
    }
  }
  const std::shared_lock beside_others(mutex);
  return readAnswer(runIsolated([&task] { return buildToBytes(task); }), task);
}

}  // namespace

Expected<ShaderStage> stageOfFile(const std::filesystem::path& path) {
  const bool ends_in_glsl = path.extension() == ".glsl";
  const std::filesystem::path extension = ends_in_glsl ? path.stem().extension() : path.extension();
  if (ends_in_glsl && extension.empty()) {
    return ShaderStage::kFragment;  // as --replace takes it
  }
  if (extension == ".vert") {
    return ShaderStage::kVertex;
  }
  if (extension == ".frag") {
    return ShaderStage::kFragment;
  }
  return inputError(fmt::format("tell the stage of the shader '{}'", path.filename().string()),
                    "its name says neither a vertex nor a fragment shader", {},
                    "name it NAME.vert, NAME.frag or NAME.glsl, which is a fragment shader");
}

Expected<ShaderModule> compileShader(const ShaderSource& source, ShaderTarget target,
                                     const CompileOptions& options) {
  const std::string attempted = fmt::format("compile the {} shader '{}' for {}",
                                            source.stage == ShaderStage::kVertex ? "vertex" : "fragment",
                                            source.entry.filename().string(), targetName(target));
  const Expected<SourceTree> tree = readSourceTree(source, attempted);
  if (!tree) {
    return tl::make_unexpected(tree.error());
  }
  const Expected<std::string> preamble = makePreamble(source, target, attempted);
  if (!preamble) {
    return tl::make_unexpected(preamble.error());
  }
  const std::string recipe = compileRecipe(*tree, *preamble, source.stage, target, options.form);
  const SpirvCache cache = options.use_cache ? SpirvCache::ofUser() : SpirvCache({});
  std::optional<ShaderModule> cached = cache.find(recipe);
  Expected<ShaderModule> module = tl::make_unexpected(Error{});
  if (cached) {
    cached->from_cache = true;
    module = std::move(*cached);
  } else {
    const FrontEndOptions front_end{target, source.stage, *preamble, false};
    const Task task{*tree, front_end, options.form, attempted};
    module = buildIsolated(task);
  }
  if (!module) {
    return module;
  }
  if (!module->from_cache) {
    cache.store(recipe, *module);
  }
  for (const SourceFile& file : tree->files) {
    module->dependencies.push_back(file.path);
  }
  return module;
}

}  // namespace ssrkit
