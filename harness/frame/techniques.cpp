#include "frame/techniques.h"

#include <algorithm>
#include <iterator>

#include "frame/composite_techniques.h"
#include "frame/find_row.h"
#include "frame/packed_techniques.h"
#include "frame/roofline_techniques.h"
#include "frame/rough_techniques.h"
#include "frame/temporal_techniques.h"

namespace ssrkit {

namespace {

std::vector<Technique> joined(std::vector<std::vector<Technique>> families) {
  std::vector<Technique> all;
  for (std::vector<Technique>& family : families) {
    std::ranges::move(family, std::back_inserter(all));
  }
  return all;
}

const std::vector<Technique>& techniqueTable() {
  static const std::vector<Technique> rows =
      joined({compositeTechniques(), filterTechniques(), packedTechniques(), roughTechniques(),
              temporalTechniques(), rooflineTechniques()});
  return rows;
}

}  // namespace

std::span<const Technique> techniques() {
  return techniqueTable();
}

Expected<const Technique*> findTechnique(std::string_view name) {
  return findRow(techniques(), name, "technique");
}

}  // namespace ssrkit
