// What is Vulkan's own: finding a device, its messages, its lifetime.
#include "device/vulkan/vulkan_device.h"

#include <algorithm>

#include "device/vulkan/barriers.h"
#include "device/vulkan/commands.h"
#include "device/vulkan/image.h"
#include "device/vulkan/library.h"
#include "device/vulkan/memory.h"
#include "device/vulkan/physical_device.h"
#include "device/vulkan/result.h"
#include "device_fixture.h"
#include "scoped_variable.h"

namespace ssrkit {
namespace {

class VulkanDeviceTest : public DeviceTest {
 protected:
  [[nodiscard]] static std::unique_ptr<Device> create() {
    return valueOf(createVulkanDevice("vk-lavapipe", {.device_name_part = "llvmpipe"}));
  }
};
INSTANTIATE_TEST_SUITE_P(On, VulkanDeviceTest, testing::Values("vk-lavapipe"), nameOfDevice);

bool mentions(const std::vector<std::string>& texts, const std::string& part) {
  return std::ranges::any_of(texts,
                             [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

TEST_P(VulkanDeviceTest, TheIdentityNamesApiDriverAndVersion) {
  const DeviceIdentity& identity = device().identity();
  EXPECT_EQ(identity.id, "vk-lavapipe");
  EXPECT_EQ(identity.api.rfind("Vulkan 1.", 0), 0U) << identity.api;
  EXPECT_EQ(identity.driver.rfind("llvmpipe (LLVM ", 0), 0U) << identity.driver;
  EXPECT_EQ(identity.version.rfind("Mesa ", 0), 0U) << identity.version;
  EXPECT_EQ(identity.version.find('('), std::string::npos) << identity.version;
  EXPECT_FALSE(identity.cpu.empty());
}

TEST_P(VulkanDeviceTest, AnUnknownNameIsAnErrorThatListsTheDevicesThatWereSeen) {
  const auto created = createVulkanDevice("vk-none", {.device_name_part = "no such device"});
  ASSERT_FALSE(created);
  EXPECT_EQ(created.error().kind, ErrorKind::kSetup);
  EXPECT_TRUE(mentions(created.error().reasons, "llvmpipe")) << sentence(created.error());
  EXPECT_TRUE(mentions(created.error().reasons, "does not contain 'no such device'"))
      << sentence(created.error());
}

TEST_P(VulkanDeviceTest, AMachineWithoutADriverIsToldWhatToInstall) {
  const ScopedVariable files("VK_DRIVER_FILES", "/no/such/driver.json");
  const auto created = createVulkanDevice("vk-lavapipe", {.device_name_part = "llvmpipe"});
  ASSERT_FALSE(created);
  EXPECT_EQ(created.error().kind, ErrorKind::kSetup);
  EXPECT_NE(sentence(created.error()).find("mesa-vulkan-drivers"), std::string::npos)
      << sentence(created.error());
}

TEST(VulkanLibraryTest, AMissingLoaderIsAnErrorThatNamesItsPackage) {
  const auto opened = vulkan::Library::open("libvulkan-that-is-not-there.so.1");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().kind, ErrorKind::kSetup);
  EXPECT_NE(sentence(opened.error()).find("libvulkan-that-is-not-there.so.1"), std::string::npos);
  EXPECT_NE(sentence(opened.error()).find("libvulkan1"), std::string::npos);
}

TEST(VulkanLibraryTest, ALibraryThatIsNoLoaderIsAnError) {
  const auto opened = vulkan::Library::open("libm.so.6");
  ASSERT_FALSE(opened);
  EXPECT_NE(sentence(opened.error()).find("vkGetInstanceProcAddr"), std::string::npos);
}

TEST(VulkanResultTest, CodesAreNamedAndUnknownOnesNumbered) {
  EXPECT_EQ(vulkan::resultName(VK_ERROR_DEVICE_LOST), "VK_ERROR_DEVICE_LOST");
  EXPECT_EQ(vulkan::resultName(static_cast<VkResult>(-987654)), "VkResult -987654");
}

TEST_P(VulkanDeviceTest, BrokenSpirvIsAnErrorAndTheDeviceWorksOn) {
  ProgramSource source = compile("screen.vert", "coordinate.frag");
  source.desc.colour_formats = {Format::kRgba32f};
  for (const std::size_t cut : {std::size_t{0}, std::size_t{3}, source.fragment.spirv.size() - 1}) {
    ProgramDesc broken = source.desc;
    broken.fragment_spirv = std::span(source.fragment.spirv).first(cut);
    const auto refused = device().createProgram(broken);
    ASSERT_FALSE(refused) << cut;
    EXPECT_NE(sentence(refused.error()).find("fragment"), std::string::npos) << sentence(refused.error());
  }
  EXPECT_NE(program(source.desc), nullptr);
}

TEST_P(VulkanDeviceTest, EveryMutilatedWordIsRefusedOrDrawsWithoutACrash) {
  ProgramSource source = compile("screen.vert", "coordinate.frag");
  source.desc.colour_formats = {Format::kRgba32f};
  const auto target = image(Format::kRgba32f, {2, 2});
  std::size_t refused_count = 0;
  for (std::size_t word = 0; word < source.fragment.spirv.size(); ++word) {
    std::vector<std::uint32_t> mutilated = source.fragment.spirv;
    mutilated[word] ^= 5U;
    ProgramDesc desc = source.desc;
    desc.fragment_spirv = mutilated;
    const auto made = device().createProgram(desc);
    if (made) {
      EXPECT_TRUE(device().draw(passTo(*target, **made)));
    }
    refused_count += made ? 0 : 1;
  }
  EXPECT_GT(refused_count, source.fragment.spirv.size() / 2);
  (void)device().drainMessages();  // a validation layer has its say about the modules that passed
}

// The module with `addend` added to every decoration of this kind.
std::vector<std::uint32_t> redecorated(std::vector<std::uint32_t> words, std::uint32_t decoration,
                                       std::uint32_t addend) {
  constexpr std::uint32_t kOpDecorate = (4U << 16U) | 71U;  // four words: itself, target, decoration, number
  for (std::size_t i = 0; i + 3 < words.size(); ++i) {
    if (words[i] == kOpDecorate && words[i + 2] == decoration) {
      words[i + 3] += addend;
    }
  }
  return words;
}

// glslang lets a varying sit at any location below 4096.
TEST_P(VulkanDeviceTest, ALocationPastTheDevicesLimitIsAnErrorThatNamesIt) {
  constexpr std::uint32_t kLocation = 30;
  ProgramSource source = compile("mesh.vert", "mesh.frag");
  const std::vector<std::uint32_t> far = redecorated(source.fragment.spirv, kLocation, 1000);
  source.desc.colour_formats = {Format::kR32f};
  source.desc.fragment_spirv = far;
  const auto refused = device().createProgram(source.desc);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kInput);
  EXPECT_NE(sentence(refused.error()).find("fragment shader uses location 1000"), std::string::npos)
      << sentence(refused.error());
}

TEST_P(VulkanDeviceTest, AnotherDescriptorSetThanTheFirstIsAnErrorThatNamesIt) {
  constexpr std::uint32_t kDescriptorSet = 34;
  ProgramSource source = compile("screen.vert", "look_up.frag");
  const std::vector<std::uint32_t> elsewhere = redecorated(source.fragment.spirv, kDescriptorSet, 2);
  source.desc.colour_formats = {Format::kRgba32f};
  source.desc.fragment_spirv = elsewhere;
  const auto refused = device().createProgram(source.desc);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kInput);
  EXPECT_NE(sentence(refused.error()).find("descriptor set 2"), std::string::npos)
      << sentence(refused.error());
}

TEST_P(VulkanDeviceTest, AVertexModuleInTheFragmentsPlaceIsAnError) {
  ProgramSource source = compile("screen.vert", "coordinate.frag");
  source.desc.colour_formats = {Format::kRgba32f};
  source.desc.fragment_spirv = source.vertex.spirv;
  const auto refused = device().createProgram(source.desc);
  ASSERT_FALSE(refused);
  EXPECT_NE(sentence(refused.error()).find("no fragment shader named main"), std::string::npos)
      << sentence(refused.error());
}

TEST_P(VulkanDeviceTest, ImagesBuffersAndProgramsMayOutliveTheirDevice) {
  const ScopedVariable validation("SSRKIT_VALIDATION", "1");
  testing::internal::CaptureStderr();
  {
    std::unique_ptr<DeviceImage> late_image;
    std::unique_ptr<DeviceBuffer> late_buffer;
    std::unique_ptr<DeviceProgram> late_program;
    const auto short_lived = create();
    late_image = valueOf(short_lived->createImage({"late", Format::kR32f, {2, 2}, 1}));
    late_buffer = valueOf(short_lived->createVertexBuffer(std::vector<std::byte>(16)));
    ProgramSource source = compile("screen.vert", "coordinate.frag");
    source.desc.colour_formats = {Format::kR32f};
    late_program = valueOf(short_lived->createProgram(source.desc));
    ASSERT_TRUE(short_lived->draw(passTo(*late_image, *late_program)));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "the layer saw an object that was never destroyed";
}

// Without these two, tests that expect no message would pass on a device that cannot speak.
TEST_P(VulkanDeviceTest, ValidationReportsATargetOfAnotherKindThanTheShaderWrites) {
  const ScopedVariable validation("SSRKIT_VALIDATION", "1");
  const auto validated = create();
  ProgramSource source = compile("screen.vert", "coordinate.frag");
  source.desc.colour_formats = {Format::kRgba16ui};
  (void)valueOf(validated->createProgram(source.desc));
  const std::vector<std::string> messages = validated->drainMessages();
  EXPECT_TRUE(mentions(messages, "fragment shader output type")) << messages.size() << " messages";
  EXPECT_EQ(validated->drainMessages(), std::vector<std::string>{}) << "a message is told once";
}

TEST_P(VulkanDeviceTest, SynchronizationValidationReportsAMissingBarrier) {
  auto instance =
      valueOf(vulkan::Instance::create(valueOf(vulkan::Library::open()), {.core = true, .sync = true}));
  auto physical = valueOf(vulkan::pickPhysicalDevice(*instance, {.device_name_part = "llvmpipe"}));
  const auto gpu = valueOf(vulkan::Gpu::create(std::move(instance), std::move(physical)));
  auto commands = valueOf(vulkan::Commands::create(gpu));
  const auto texels =
      valueOf(vulkan::createMappedBuffer(*gpu, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, 0, "test"));
  const auto image = valueOf(vulkan::VulkanImage::create(gpu, {"unguarded", Format::kR32f, {4, 4}, 1}));
  const VkCommandBuffer buffer = valueOf(commands.begin("test"));
  vulkan::Barriers barriers;
  barriers.use(*image, 0, 1, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  barriers.record(gpu->functions(), buffer);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {4, 4, 1};
  for (int i = 0; i < 2; ++i) {  // two writes of one buffer with nothing between them
    gpu->functions().vkCmdCopyImageToBuffer(buffer, image->get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                            texels.buffer.get(), 1, &region);
  }
  (void)valueOf(commands.submitAndWait("test"));
  EXPECT_TRUE(mentions(gpu->instance().messages().drain(), "SYNC-HAZARD-WRITE-AFTER-WRITE"));
}

TEST_P(VulkanDeviceTest, DeviceTimeOfAPassIsNoLongerThanItsWallTime) {
  const auto coordinates = screenProgram("coordinate.frag", {Format::kRgba32f});
  const auto target = image(Format::kRgba32f, {640, 360});
  draw(passTo(*target, *coordinates));  // compiles
  const PassTime time = draw(passTo(*target, *coordinates));
  ASSERT_TRUE(time.device_ns.has_value());
  EXPECT_GT(*time.device_ns, 0);
  EXPECT_LE(*time.device_ns, time.wall_ns);
  EXPECT_GT(time.cpu_ns, 0);
}

}  // namespace
}  // namespace ssrkit
