#include "frame/variants.h"

#include "frame/find_row.h"

namespace ssrkit {

std::span<const Variant> variants() {
  static const std::vector<Variant> rows = {
      {.name = "spirv_opt", .about = "every module through spirv-opt -O", .modules = ModuleForm::kOptimised},
      {.name = "spirv_opt_size",
       .about = "every module through spirv-opt -Os",
       .modules = ModuleForm::kOptimisedSize},
      {.name = "robust",
       .about = "every module through spirv-opt --graphics-robust-access: no index leaves its array",
       .modules = ModuleForm::kRobust},
      {.name = "dead_code",
       .about = "every sum with a zero that no compiler knows, and a branch that is never taken",
       .modules = ModuleForm::kDeadCode},
      {.name = "uniform_order",
       .about = "the members of every uniform block in the opposite order",
       .modules = ModuleForm::kUniformsReversed},
      {.name = "counted_loops",
       .about = "fragments whose loops run more than 60,000 times write something else",
       .modules = ModuleForm::kCountedLoops},
      {.name = "tiled",
       .about = "full-screen passes drawn in six scissored tiles, whose borders cut through 2x2 quads",
       .is_tiled = true},
      {.name = "mirrored", .about = "left and right change places", .view = {.is_mirrored = true}},
      {.name = "scaled", .about = "everything eight times as large and as far away", .view = {.scale = 8.0}},
      {.name = "cropped", .about = "the middle of the picture alone", .view = {.is_cropped = true}},
      {.name = "threads_0",
       .about = "Mesa's software rasteriser without threads",
       .environment = {{"LP_NUM_THREADS", "0"}}},
      {.name = "threads_1", .about = "with one thread", .environment = {{"LP_NUM_THREADS", "1"}}},
      {.name = "threads_2", .about = "with two threads", .environment = {{"LP_NUM_THREADS", "2"}}},
  };
  return rows;
}

Expected<const Variant*> findVariant(std::string_view name) {
  static const Variant plain{.name = "", .about = "the job as it is"};
  return name.empty() ? Expected<const Variant*>(&plain) : findRow(variants(), name, "variant");
}

}  // namespace ssrkit
