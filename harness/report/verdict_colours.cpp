#include "report/verdict_colours.h"

#include <cstddef>

#include "image/colour_map.h"

namespace ssrkit {

Rgb8 colourOf(Verdict verdict) {
  static constexpr std::array<Rgb8, kVerdictCount> kColours = {{{128, 128, 128},
                                                                okabe_ito::kBluishGreen,
                                                                okabe_ito::kSkyBlue,
                                                                okabe_ito::kVermillion,
                                                                okabe_ito::kOrange,
                                                                okabe_ito::kBlue,
                                                                okabe_ito::kReddishPurple,
                                                                okabe_ito::kYellow}};
  return kColours.at(static_cast<std::size_t>(verdict));
}

const char* meaningOf(Verdict verdict) {
  static constexpr std::array<const char*, kVerdictCount> kMeanings = {
      "no ray: not reflective, or background", "same class, same texel",           "hit within one pixel",
      "another texel, or another class",       "hit; the oracle did not",          "missed; the oracle hit",
      "slipped through a diagonal line",       "differs, but it is a tie in float"};
  return kMeanings.at(static_cast<std::size_t>(verdict));
}

}  // namespace ssrkit
