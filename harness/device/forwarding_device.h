// A device that hands every call to another one: the base of devices that change one thing about them.
#pragma once

#include "device/device.h"

namespace ssrkit {

// Images, buffers and programs are those of the device behind it, which must outlive it.
class ForwardingDevice : public Device {
 public:
  explicit ForwardingDevice(Device& device) : device_(device) {}

  [[nodiscard]] const DeviceIdentity& identity() const override { return device_.identity(); }
  [[nodiscard]] Expected<std::unique_ptr<DeviceImage>> createImage(const ImageDesc& desc) override {
    return device_.createImage(desc);
  }
  [[nodiscard]] Expected<std::unique_ptr<DeviceBuffer>> createVertexBuffer(
      std::span<const std::byte> bytes) override {
    return device_.createVertexBuffer(bytes);
  }
  [[nodiscard]] Expected<std::unique_ptr<DeviceProgram>> createProgram(const ProgramDesc& desc) override {
    return device_.createProgram(desc);
  }
  [[nodiscard]] Expected<void> upload(DeviceImage& image, int mip,
                                      std::span<const std::byte> bytes) override {
    return device_.upload(image, mip, bytes);
  }
  [[nodiscard]] Expected<std::vector<std::byte>> read(const DeviceImage& image, int mip) override {
    return device_.read(image, mip);
  }
  [[nodiscard]] Expected<void> copy(const DeviceImage& from, int mip, Size size, DeviceImage& to, int x,
                                    int y) override {
    return device_.copy(from, mip, size, to, x, y);
  }
  [[nodiscard]] Expected<PassTime> draw(const PassDesc& pass) override { return device_.draw(pass); }
  [[nodiscard]] std::vector<std::string> drainMessages() override { return device_.drainMessages(); }

 protected:
  [[nodiscard]] Device& behind() { return device_; }

 private:
  Device& device_;
};

}  // namespace ssrkit
