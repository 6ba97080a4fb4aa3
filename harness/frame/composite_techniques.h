// Techniques that differ in what a hit is worth, how it is filtered and how it is put into the picture.
#pragma once

#include <vector>

#include "frame/techniques.h"

namespace ssrkit {

// How public implementations composite one sharp reflection, and the kit's confidence.
[[nodiscard]] std::vector<Technique> compositeTechniques();

// What is done to one sharp reflection afterwards: rough surfaces by filters, holes filled.
[[nodiscard]] std::vector<Technique> filterTechniques();

}  // namespace ssrkit
