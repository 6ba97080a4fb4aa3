// What an answer would be, looked at in another way: what the answers of variants that change the view are
// held against.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "check/subject.h"
#include "image/image.h"
#include "image/ray_record.h"

namespace ssrkit {

// Owns what a made answer points at.
struct SeenAnswer {
  RayRecord record;
  std::map<std::string, Image> images;
};

// Whether the variant (a row of frame/variants.h) shows the scene in another view.
[[nodiscard]] bool changesView(const std::string& variant);

// Adds, for each of the variants that changes the view, the plain answers as that view has them.
void addSeenAnswers(const std::vector<std::string>& variants, std::deque<SeenAnswer>& owned,
                    std::vector<Answer>& answers);

}  // namespace ssrkit
