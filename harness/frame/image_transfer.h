// Between host images (float32) and device images (each in its own format).
#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"
#include "image/image.h"
#include "image/ray_record.h"

namespace ssrkit {

// Uploads a host image; channels that it lacks are taken from `defaults`. Formats: float and half.
[[nodiscard]] Expected<void> uploadImage(Device& device, DeviceImage& to, const Image& from,
                                         const std::array<float, 4>& defaults);

// Fills the whole image with one value.
[[nodiscard]] Expected<void> fillImage(Device& device, DeviceImage& to, const std::array<float, 4>& value);

// Reads mip 0 back as floats, under the given channel names (at most as many as the format has).
[[nodiscard]] Expected<Image> readImage(Device& device, const DeviceImage& from,
                                        const std::vector<std::string>& channels);

// The three images of a trace as one record. Classes are as the shader wrote them, also those that are none;
// numbers over kLastRayClassNumber become that.
[[nodiscard]] Expected<RayRecord> readRecord(Device& device, const DeviceImage& hit_texel,
                                             const DeviceImage& hit_point, const DeviceImage& ray_work);

}  // namespace ssrkit
