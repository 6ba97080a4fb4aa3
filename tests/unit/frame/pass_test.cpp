#include "pass_test.h"

#include <fmt/format.h>
#include <glm/gtc/packing.hpp>

#include <toml++/toml.h>
#include <cstring>
#include <filesystem>

#include "../kit_shaders.h"
#include "device/format.h"

namespace ssrkit {

namespace {

std::vector<std::string> channelNames(Format format) {
  const std::vector<std::string> all = {"R", "G", "B", "A"};
  return {all.begin(), all.begin() + formatInfo(format).channel_count};
}

Expected<Image> readMip(Device& device, const DeviceImage& image, int mip) {
  const auto bytes = device.read(image, mip);
  if (!bytes) {
    return tl::make_unexpected(bytes.error());
  }
  const Format format = image.desc().format;
  Image read(mipSize(image.desc(), mip), channelNames(format));
  for (std::size_t i = 0; i < read.data.size(); ++i) {
    if (format == Format::kRgba16f || formatInfo(format).is_integer) {
      std::uint16_t word = 0;
      std::memcpy(&word, bytes->data() + 2 * i, sizeof(word));
      read.data[i] = format == Format::kRgba16f ? glm::unpackHalf1x16(word)
                     : format == Format::kRg16i ? static_cast<float>(static_cast<std::int16_t>(word))
                                                : static_cast<float>(word);
    } else {
      std::memcpy(&read.data[i], bytes->data() + 4 * i, sizeof(float));
    }
  }
  return read;
}

// The mutant's shader, once its description names the test that runs.
std::string mutantFile(const std::string& name, const std::string& shader) {
  const std::string path = SSRKIT_SOURCE_DIR "/tests/mutants/" + name;
  const toml::table about = toml::parse_file(path + ".toml");
  EXPECT_EQ(about["pass"].value_or(std::string()) + ".frag", shader) << name;
  EXPECT_GT(about["about"].value_or(std::string()).size(), 20U) << name;
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::string suite = test.test_suite_name();
  const std::string title = test.name();
  EXPECT_EQ(about["killed_by"].value_or(std::string()),
            suite.substr(suite.find('/') + 1) + "." + title.substr(0, title.find('/')))
      << name;
  return path + ".frag";
}

}  // namespace

void PassTest::begin() {
  given_.clear();
  environment_.reset();
  constants_.clear();
  values_ = {};
}

void PassTest::setConstant(const std::string& name, UniformConstant value) {
  constants_[name] = value;
  std::visit([&](auto number) { values_.set(name, number); }, value);
}

void PassTest::give(const std::string& name, const Image& image, Format format) {
  auto created = device_->createImage({.name = name, .format = format, .size = image.size});
  ASSERT_TRUE(created.has_value()) << sentence(created.error());
  ASSERT_TRUE(uploadImage(*device_, **created, image, {0, 0, 0, 1}).has_value());
  given_[name] = {std::move(*created)};
}

void PassTest::giveIntegers(const std::string& name, const Image& image, Format format) {
  auto created = device_->createImage({.name = name, .format = format, .size = image.size});
  ASSERT_TRUE(created.has_value()) << sentence(created.error());
  std::vector<std::int16_t> words;  // two's complement: the same words for unsigned values below 2^15
  for (const float value : image.data) {
    words.push_back(static_cast<std::int16_t>(value));
  }
  ASSERT_TRUE(device_->upload(**created, 0, std::as_bytes(std::span(words))).has_value());
  given_[name] = {std::move(*created)};
}

void PassTest::give(const EnvironmentMaps& maps) {
  environment_ = std::make_unique<FrameImages>(*device_, Size{1, 1});
  const auto done = uploadEnvironment(*device_, maps, *environment_, values_);
  ASSERT_TRUE(done.has_value()) << sentence(done.error());
}

const Program* PassTest::program(const PassRow& row) {
  if (programs_ == nullptr) {
    programs_ = std::make_unique<Programs>(*device_, target_);
  }
  const auto made = programs_->get(row, {.shader_root = kitShaders()});
  EXPECT_TRUE(made.has_value()) << sentence(made.error());
  return made ? *made : nullptr;
}

std::vector<Image> PassTest::drawInto(const std::string& shader, const std::vector<Attachment>& targets,
                                      Size size, const std::map<std::string, SampledImage>& aliases) {
  std::vector<Format> formats;
  std::vector<Image> images;
  for (const Attachment& target : targets) {
    formats.push_back(target.image->desc().format);
    images.emplace_back(size, channelNames(formats.back()));
  }
  const PassRow row{.name = shader,
                    .vertex_shader = "full_screen.vert",
                    .fragment_shader = shader,
                    .colour_formats = formats,
                    .vertex_attributes = {},
                    .vertex_stride_bytes = 0,
                    .constants = constants_};
  const Program* compiled = program(row);
  if (compiled == nullptr) {
    return images;
  }
  std::map<std::string, SampledImage> sampled = aliases;
  for (const auto& [name, given] : given_) {
    sampled.emplace(name, SampledImage{.image = given.image.get(),
                                       .mip_count = given.image->desc().mip_count,
                                       .filter = given.filter});
  }
  const FrameImages none(*device_, size);
  const auto time = drawFullScreen(
      *device_, *compiled,
      {.row = &row, .targets = targets, .viewport = {0, 0, size.width, size.height}, .aliases = sampled},
      environment_ != nullptr ? *environment_ : none, values_);
  EXPECT_TRUE(time.has_value()) << sentence(time.error());
  for (std::size_t i = 0; time && i < targets.size(); ++i) {
    const auto image = readMip(*device_, *targets[i].image, targets[i].mip);
    EXPECT_TRUE(image.has_value()) << sentence(image.error());
    images[i] = image ? *image : images[i];
  }
  return images;
}

void PassTest::drawGiven(const std::string& shader, Size size, Format format, const std::string& name) {
  auto target = device_->createImage({.name = name, .format = format, .size = size});
  ASSERT_TRUE(target.has_value()) << sentence(target.error());
  static_cast<void>(drawInto(shader, {{target->get(), 0, std::nullopt}}, size, {}));
  given_[name] = {.image = std::move(*target)};
}

Image PassTest::draw(const std::string& shader, Size size, Format format) {
  return drawAll(shader, size, {format}).front();
}

std::vector<Image> PassTest::drawAll(const std::string& shader, Size size,
                                     const std::vector<Format>& formats) {
  std::vector<std::unique_ptr<DeviceImage>> images;
  std::vector<Attachment> targets;
  for (const Format format : formats) {
    auto target = device_->createImage({.name = "target", .format = format, .size = size});
    EXPECT_TRUE(target.has_value()) << sentence(target.error());
    images.push_back(std::move(*target));
    targets.push_back({images.back().get(), 0, std::nullopt});
  }
  return drawInto(shader, targets, size, {});
}

std::vector<Image> PassTest::drawMips(const std::string& shader, const Image& base, Format format,
                                      const std::string& name) {
  int mip_count = 1;
  while (std::max(base.size.width, base.size.height) >> mip_count > 0) {
    ++mip_count;
  }
  auto chain =
      device_->createImage({.name = name, .format = format, .size = base.size, .mip_count = mip_count});
  EXPECT_TRUE(chain.has_value()) << sentence(chain.error());
  EXPECT_TRUE(uploadImage(*device_, **chain, base, {0, 0, 0, 1}).has_value());
  std::vector<Image> mips = {base};
  for (int mip = 1; mip < mip_count; ++mip) {
    mips.push_back(drawInto(shader, {{chain->get(), mip, std::nullopt}}, mipSize((*chain)->desc(), mip),
                            {{"finer", {.image = chain->get(), .base_mip = mip - 1}}})
                       .front());
  }
  given_[name] = {std::move(*chain), Filter::kLinear};
  return mips;
}

void PassTest::holdsAndKills(const Check& check, const std::string& shader,
                             const std::vector<std::string>& mutants) {
  EXPECT_EQ(check(shader), "");
  for (const std::string& mutant : mutants) {
    EXPECT_NE(check(mutantFile(mutant, shader)), "") << mutant << " survives";
  }
}

std::string difference(const Image& got, const Image& expected, double tolerance) {
  if (got.size != expected.size || got.channelCount() != expected.channelCount()) {
    return "other sizes or channels";
  }
  std::size_t worst = 0;
  double largest = -1.0;
  for (std::size_t i = 0; i < got.data.size(); ++i) {
    const double off = std::abs(static_cast<double>(got.data[i]) - static_cast<double>(expected.data[i]));
    if (!(off <= largest)) {  // also for what is no number
      largest = off;
      worst = i;
    }
  }
  if (largest <= tolerance) {
    return "";
  }
  const std::size_t texel = worst / got.channelCount();
  const auto width = static_cast<std::size_t>(got.size.width);
  return fmt::format("texel {}, {} channel {}: {} where {} is right", texel % width, texel / width,
                     worst % got.channelCount(), got.data[worst], expected.data[worst]);
}

std::string followsFormula(const Image& got, const std::function<double(int x, int y)>& formula,
                           double tolerance) {
  for (int y = 0; y < got.size.height; ++y) {
    for (int x = 0; x < got.size.width; ++x) {
      const auto value = static_cast<double>(got.at(x, y));
      if (!(std::abs(value - formula(x, y)) <= tolerance)) {
        return fmt::format("{} at {}, {} where {} is right", value, x, y, formula(x, y));
      }
    }
  }
  return "";
}

Image imageOf(Size size, const std::function<std::array<double, 4>(int x, int y)>& texel,
              std::size_t channel_count) {
  const std::vector<std::string> all = {"R", "G", "B", "A"};
  Image image(size, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(channel_count)});
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto value = texel(x, y);
      for (std::size_t channel = 0; channel < channel_count; ++channel) {
        image.at(x, y, channel) = static_cast<float>(value[channel]);
      }
    }
  }
  return image;
}

}  // namespace ssrkit
