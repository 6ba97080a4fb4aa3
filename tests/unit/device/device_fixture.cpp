#include "device_fixture.h"

#include <algorithm>
#include <cstdlib>

#include "device/format.h"

namespace ssrkit {
namespace {

template <class Binding>
void addBindings(const std::vector<Binding>& bindings, std::vector<std::uint32_t>& numbers) {
  for (const Binding& binding : bindings) {
    if (std::ranges::find(numbers, binding.binding) == numbers.end()) {
      numbers.push_back(binding.binding);
    }
  }
}

std::vector<std::uint32_t> idsOf(const ShaderInterface& interface) {
  std::vector<std::uint32_t> ids;
  for (const SpecConstantInfo& constant : interface.spec_constants) {
    ids.push_back(constant.id);
  }
  return ids;
}

}  // namespace

std::vector<std::string> DeviceTest::allDevices() {
  std::vector<std::string> ids;
  for (const DeviceEntry& entry : deviceEntries()) {
    if (entry.is_software) {
      ids.push_back(entry.id);
    }
  }
  return ids;
}

void DeviceTest::SetUp() {
  const auto entry = findDevice(GetParam());
  ASSERT_TRUE(entry) << sentence(entry.error());
  for (const auto& [name, value] : (*entry)->environment) {
    ASSERT_EQ(setenv(name.c_str(), value.c_str(), 1), 0);
  }
  entry_ = *entry;
  auto created = (*entry)->create();
  ASSERT_TRUE(created) << sentence(created.error());
  device_ = std::move(*created);
}

void DeviceTest::TearDown() {
  if (device_ != nullptr) {
    EXPECT_EQ(device_->drainMessages(), std::vector<std::string>{});
  }
}

ProgramSource DeviceTest::compile(const std::string& vertex, const std::string& fragment) const {
  const std::filesystem::path root = SSRKIT_SOURCE_DIR "/tests/unit/device/shaders";
  ProgramSource source;
  source.vertex =
      valueOf(compileShader({root, vertex, ShaderStage::kVertex, {}}, target(), {.use_cache = false}));
  source.fragment =
      valueOf(compileShader({root, fragment, ShaderStage::kFragment, {}}, target(), {.use_cache = false}));
  ProgramDesc& desc = source.desc;
  desc.name = fragment;
  desc.vertex_spirv = source.vertex.spirv;
  desc.fragment_spirv = source.fragment.spirv;
  for (const ShaderInterface* interface : {&source.vertex.interface, &source.fragment.interface}) {
    addBindings(interface->samplers, desc.sampler_bindings);
    addBindings(interface->uniform_blocks, desc.uniform_bindings);
  }
  desc.vertex_constant_ids = idsOf(source.vertex.interface);
  desc.fragment_constant_ids = idsOf(source.fragment.interface);
  return source;
}

std::unique_ptr<DeviceProgram> DeviceTest::program(const ProgramDesc& desc) {
  return valueOf(device().createProgram(desc));
}

std::unique_ptr<DeviceProgram> DeviceTest::screenProgram(const std::string& fragment,
                                                         std::vector<Format> colour_formats) {
  ProgramSource source = compile("screen.vert", fragment);
  source.desc.colour_formats = std::move(colour_formats);
  return program(source.desc);
}

std::unique_ptr<DeviceImage> DeviceTest::image(Format format, Size size, int mip_count) {
  return valueOf(device().createImage({"test image", format, size, mip_count}));
}

std::vector<std::byte> DeviceTest::readBytes(const DeviceImage& image, int mip) {
  return valueOf(device().read(image, mip));
}

PassTime DeviceTest::draw(const PassDesc& pass) {
  return valueOf(device().draw(pass));
}

PassDesc passTo(DeviceImage& image, const DeviceProgram& program, int mip) {
  const Size size = mipSize(image.desc(), mip);
  PassDesc pass;
  pass.name = "test pass";
  pass.program = &program;
  pass.colour = {{.image = &image, .mip = mip, .clear = {}}};
  pass.viewport = {0, 0, size.width, size.height};
  return pass;
}

std::string nameOfDevice(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace ssrkit
