#include "frame/techniques.h"

#include "frame/find_row.h"

namespace ssrkit {

namespace {

const std::vector<Technique>& table() {
  static const std::vector<Technique> rows = {
      {.name = "mirror",
       .about = "what each ray hit, weighted by Fresnel; the sky where it hit nothing",
       .after_trace = {{.name = "resolve", .outputs = {"reflection"}},
                       {.name = "composite", .outputs = {"composite"}}}},
  };
  return rows;
}

}  // namespace

std::span<const Technique> techniques() {
  return table();
}

Expected<const Technique*> findTechnique(std::string_view name) {
  return findRow(techniques(), name, "technique");
}

}  // namespace ssrkit
