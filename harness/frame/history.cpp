#include "frame/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frame/image_transfer.h"

namespace ssrkit {

namespace {

// Images that never leave the trace that makes them.
bool isOfTrace(const FrameImageRow& previous) {
  return frameImageRow(previous.previous_of).folder.empty();
}

std::array<float, 4> clearValue(const FrameImageRow& row) {
  std::array<float, 4> value{};
  std::ranges::transform(row.clear, value.begin(), [](double one) { return static_cast<float>(one); });
  return value;
}

// The row of the previous frame that a sampler of the pass reads, null for every other sampler.
const FrameImageRow* previousRow(const PreparedPass& pass, const std::string& sampler) {
  const auto renamed = pass.pass.inputs.find(sampler);
  const std::string& name = renamed == pass.pass.inputs.end() ? sampler : renamed->second;
  const auto row = std::ranges::find(frameImages(), name, &FrameImageRow::name);
  return row == frameImages().end() || row->previous_of.empty() ? nullptr : &*row;
}

}  // namespace

void History::add(Kept kept) {
  if (std::ranges::find(kept_, kept.image, &Kept::image) == kept_.end()) {
    kept_.push_back(std::move(kept));
  }
}

void History::watch(const std::vector<PreparedPass>& passes, const std::string& owner) {
  for (const PreparedPass& pass : passes) {
    for (const SamplerBinding& sampler : pass.program->samplers) {
      const FrameImageRow* row = previousRow(pass, sampler.name);
      if (row != nullptr && isOfTrace(*row) == !owner.empty()) {
        add({row->name, owner.empty() ? row->name : fmt::format("{} of {}", row->name, owner), owner});
      }
    }
  }
}

void History::watchTrace(std::vector<PreparedPass>& passes, const std::string& owner) {
  watch(passes, "");
  watch(passes, owner);
  for (PreparedPass& pass : passes) {
    for (const SamplerBinding& sampler : pass.program->samplers) {
      const FrameImageRow* row = previousRow(pass, sampler.name);
      if (row != nullptr && isOfTrace(*row)) {
        pass.pass.inputs[sampler.name] = fmt::format("{} of {}", row->name, owner);
      }
    }
  }
}

Expected<void> History::clear(Device& device, FrameImages& images) const {
  for (const Kept& kept : kept_) {
    const auto image = images.getSized(images.descOf(kept.row, kept.image));
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    if (auto filled = fillImage(device, **image, clearValue(frameImageRow(kept.row))); !filled) {
      return filled;
    }
  }
  return {};
}

Expected<void> History::keep(Device& device, FrameImages& images, const std::string& owner) const {
  for (const Kept& kept : kept_) {
    if (kept.owner != owner) {
      continue;
    }
    const std::string& source = frameImageRow(kept.row).previous_of;
    const DeviceImage* from = images.find(source);
    if (from == nullptr) {
      return inputError("keep the previous frame", fmt::format("the image '{}' has not been made", source),
                        "", "a pass of the frame or of the technique must write it");
    }
    if (auto copied = device.copy(*from, 0, from->desc().size, *images.find(kept.image), 0, 0); !copied) {
      return copied;
    }
  }
  return {};
}

}  // namespace ssrkit
