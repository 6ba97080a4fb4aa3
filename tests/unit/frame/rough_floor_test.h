// A technique's passes over the rough floor of rough_floor.h, with as many samples as a test wants.
#pragma once

#include <optional>

#include "frame/techniques.h"
#include "pass_test.h"

namespace ssrkit {

class RoughFloorTest : public PassTest {
 protected:
  void SetUp() override;

  void giveFloor(const std::map<std::string, Image>& gbuffer);

  // A shader of an absolute path takes the place of this pass, another one that of none.
  void replace(const std::string& pass, const std::string& shader);

  // The means after each of `counts` samples of the `sample_count`.
  [[nodiscard]] std::map<int, Image> means(const std::string& technique, int sample_count,
                                           const std::vector<int>& counts);
  void drawAll(const std::vector<FramePass>& passes);
  [[nodiscard]] Image read(const std::string& image);

  CompileSettings settings_;

 private:
  std::optional<Programs> programs_;
  std::optional<FrameImages> images_;
};

}  // namespace ssrkit
