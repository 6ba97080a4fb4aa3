// Metamorphic variants of a job, as rows of data: the same question asked in another way, to which a right
// driver gives the same answer. A check holds the variant's answer against the plain one's (truth =
// "case:NAME").
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "image/view_change.h"
#include "shader/compiler.h"

namespace ssrkit {

struct Variant {
  std::string name;   // of Job::variant and of [[case]] variant
  std::string about;  // one line for people
  ModuleForm modules = ModuleForm::kPlain;
  bool is_tiled = false;  // full-screen passes are drawn tile by tile
  ViewChange view =
      {};  // another picture of the same scene; answers are compared by what becomes of its texels
  // Set over the device's own before its driver is loaded: such a variant has a worker of its own.
  std::vector<std::pair<std::string, std::string>> environment = {};
};

[[nodiscard]] std::span<const Variant> variants();

// "" is the plain job. Fails with the nearest name.
[[nodiscard]] Expected<const Variant*> findVariant(std::string_view name);

}  // namespace ssrkit
