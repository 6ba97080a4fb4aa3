#include "device/vulkan/vulkan_device.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "base/check.h"
#include "device/pass_rules.h"
#include "device/vulkan/commands.h"
#include "device/vulkan/descriptors.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/image.h"
#include "device/vulkan/instance.h"
#include "device/vulkan/pass_recorder.h"
#include "device/vulkan/program.h"
#include "device/vulkan/transfer.h"

namespace ssrkit {

namespace {

using vulkan::passOn;

Expected<vulkan::ValidationChecks> checksAskedFor() {
  const char* const value = std::getenv("SSRKIT_VALIDATION");
  return vulkan::parseValidation(value == nullptr ? "" : value);
}

const vulkan::VulkanImage& vulkanImage(const DeviceImage& image) {
  const auto* const mine = dynamic_cast<const vulkan::VulkanImage*>(&image);
  SSRKIT_CHECK(mine != nullptr);
  return *mine;
}

class VulkanDevice final : public Device {
 public:
  VulkanDevice(std::string_view id, std::shared_ptr<vulkan::Gpu> gpu, vulkan::Commands commands)
      : gpu_(std::move(gpu)),
        identity_(gpu_->physical().identity),
        commands_(std::move(commands)),
        transfer_(gpu_),
        descriptors_(gpu_) {
    identity_.id = id;
  }

  [[nodiscard]] const DeviceIdentity& identity() const override { return identity_; }

  [[nodiscard]] Expected<std::unique_ptr<DeviceImage>> createImage(const ImageDesc& desc) override {
    return vulkan::VulkanImage::create(gpu_, desc);
  }

  [[nodiscard]] Expected<std::unique_ptr<DeviceBuffer>> createVertexBuffer(
      std::span<const std::byte> bytes) override {
    SSRKIT_CHECK(!bytes.empty());
    return vulkan::VulkanBuffer::create(gpu_, bytes);
  }

  [[nodiscard]] Expected<std::unique_ptr<DeviceProgram>> createProgram(const ProgramDesc& desc) override {
    return vulkan::VulkanProgram::create(gpu_, desc);
  }

  [[nodiscard]] Expected<void> upload(DeviceImage& image, int mip,
                                      std::span<const std::byte> bytes) override {
    return transfer_.upload(commands_, vulkanImage(image), mip, bytes);
  }

  [[nodiscard]] Expected<std::vector<std::byte>> read(const DeviceImage& image, int mip) override {
    return transfer_.read(commands_, vulkanImage(image), mip);
  }

  [[nodiscard]] Expected<void> copy(const DeviceImage& from, int mip, Size size, DeviceImage& to, int x,
                                    int y) override {
    return transfer_.copy(commands_, vulkanImage(from), mip, size, vulkanImage(to), x, y);
  }

  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override;

  [[nodiscard]] std::vector<std::string> drainMessages() override {
    return gpu_->instance().messages().drain();
  }

 private:
  std::shared_ptr<vulkan::Gpu> gpu_;
  DeviceIdentity identity_;
  vulkan::Commands commands_;
  vulkan::Transfer transfer_;
  vulkan::Descriptors descriptors_;
};

Expected<PassTime> VulkanDevice::draw(const PassDesc& pass) {
  const auto* const program = dynamic_cast<const vulkan::VulkanProgram*>(pass.program);
  SSRKIT_CHECK(program != nullptr);
  Expected<void> legal = checkPass(pass, program->layout());
  if (!legal) {
    return passOn(legal);
  }
  if (pass.vertices != nullptr) {
    const auto* const vertices = dynamic_cast<const vulkan::VulkanBuffer*>(pass.vertices);
    SSRKIT_CHECK(vertices != nullptr);
    checkVertexRanges(pass, program->layout(), vertices->byteCount());
  }
  auto views = vulkan::attachmentViews(pass);
  if (!views) {
    return passOn(views);
  }
  auto sets = descriptors_.prepare(pass, *program);
  if (!sets) {
    return passOn(sets);
  }
  const std::string attempted = "draw the pass '" + pass.name + "'";
  auto buffer = commands_.begin(attempted);
  if (!buffer) {
    return passOn(buffer);
  }
  commands_.startTimer();
  vulkan::recordPass(gpu_->functions(), *buffer, pass, *program, *views, *sets);
  commands_.stopTimer();
  return commands_.submitAndWait(attempted);
}

}  // namespace

Expected<std::unique_ptr<Device>> createVulkanDevice(std::string_view id, const VulkanChoice& choice) {
  const auto checks = checksAskedFor();
  if (!checks) {
    return tl::make_unexpected(checks.error());
  }
  auto library = vulkan::Library::open();
  if (!library) {
    return passOn(library);
  }
  auto instance = vulkan::Instance::create(std::move(*library), *checks);
  if (!instance) {
    return passOn(instance);
  }
  auto physical = vulkan::pickPhysicalDevice(**instance, choice);
  if (!physical) {
    return passOn(physical);
  }
  auto gpu = vulkan::Gpu::create(std::move(*instance), std::move(*physical));
  if (!gpu) {
    return passOn(gpu);
  }
  auto commands = vulkan::Commands::create(*gpu);
  if (!commands) {
    return passOn(commands);
  }
  return std::make_unique<VulkanDevice>(id, std::move(*gpu), std::move(*commands));
}

}  // namespace ssrkit
