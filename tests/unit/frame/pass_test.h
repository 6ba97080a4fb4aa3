// Draws one pass of the kit over images that the test makes, and holds mutants of it to the same check.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "environment/environment_maps.h"
#include "frame/environment_images.h"
#include "frame/image_transfer.h"
#include "frame/programs.h"
#include "frame_device.h"

namespace ssrkit {

class PassTest : public FrameDeviceTest {
 protected:
  // A check of one shader: "" when it holds, else the first difference in words.
  using Check = std::function<std::string(const std::string& shader)>;

  // Forgets what the last pass was given.
  void begin();
  // An image that the pass's sampler of this name reads: floats as 32 bits unless told otherwise.
  void give(const std::string& name, const Image& image, Format format = Format::kRgba32f);
  void giveIntegers(const std::string& name, const Image& image, Format format);  // kRg16i, kRgba16ui
  void give(const EnvironmentMaps& maps);  // `environment`, `irradiance`, `split_sum`, and their uniforms

  // A specialisation constant, and the uniform of that name in shaders that have it.
  void setConstant(const std::string& name, UniformConstant value);

  // Draws the shader, an entry file of the kit's or an absolute path, into one image of `channel_count`
  // channels.
  [[nodiscard]] Image draw(const std::string& shader, Size size, Format format = Format::kRgba32f);
  // The same into several images at once, by the shader's output locations.
  [[nodiscard]] std::vector<Image> drawAll(const std::string& shader, Size size,
                                           const std::vector<Format>& formats);
  // The same, and keeps what was drawn as the image that later passes' samplers of this name read.
  void drawGiven(const std::string& shader, Size size, Format format, const std::string& name);
  // Fills the mips of an image whose mip 0 is given: one image a mip, as a pass that fills mips does. The
  // chain is then there under `name` for later passes, sampled linearly.
  std::vector<Image> drawMips(const std::string& shader, const Image& base, Format format,
                              const std::string& name = "chain");

  // The kit's own shader passes the check, and each mutant (tests/mutants/NAME.frag) fails it. A mutant's
  // description must name this test.
  void holdsAndKills(const Check& check, const std::string& shader, const std::vector<std::string>& mutants);

  UniformValues values_;

 private:
  [[nodiscard]] const Program* program(const PassRow& row);
  [[nodiscard]] std::vector<Image> drawInto(const std::string& shader, const std::vector<Attachment>& targets,
                                            Size size, const std::map<std::string, SampledImage>& aliases);
  struct Given {
    std::unique_ptr<DeviceImage> image;
    Filter filter = Filter::kNearest;
  };
  std::map<std::string, Given> given_;
  std::map<std::string, UniformConstant> constants_;
  std::unique_ptr<FrameImages> environment_;
  std::unique_ptr<Programs> programs_;
};

// "" when all channels agree to within `tolerance`, else the largest difference with its texel.
[[nodiscard]] std::string difference(const Image& got, const Image& expected, double tolerance);

// "" when the first channel of each texel is within `tolerance` of the formula.
[[nodiscard]] std::string followsFormula(const Image& got, const std::function<double(int x, int y)>& formula,
                                         double tolerance);

// An image of RGBA whose texels are made by a function.
[[nodiscard]] Image imageOf(Size size, const std::function<std::array<double, 4>(int x, int y)>& texel,
                            std::size_t channel_count = 4);

}  // namespace ssrkit
