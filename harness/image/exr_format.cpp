#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string_view>

#include "image/codec.h"
#include "image/picture_formats.h"

namespace ssrkit {

namespace {

constexpr int kFastestZip = 1;  // nearly as small as the slowest for these images, at a third of the time
constexpr int kNoThreads = 0;   // callers that write many files write them side by side

// A file in memory: the reason of a failure to write comes from base/atomic_file.h.
class OutputBytes : public Imf::OStream {
 public:
  explicit OutputBytes(std::vector<unsigned char>& bytes) : Imf::OStream("memory"), bytes_(bytes) {}

  void write(const char data[], int count) override {
    const std::size_t end = position_ + static_cast<std::size_t>(count);
    bytes_.resize(std::max(bytes_.size(), end));
    std::memcpy(bytes_.data() + position_, data, static_cast<std::size_t>(count));
    position_ = end;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

 private:
  std::vector<unsigned char>& bytes_;
  std::size_t position_ = 0;
};

class InputBytes : public Imf::IStream {
 public:
  explicit InputBytes(std::string_view bytes) : Imf::IStream("memory"), bytes_(bytes) {}

  bool read(char data[], int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (position_ > bytes_.size() || wanted > bytes_.size() - position_) {
      throw std::runtime_error("it ends too early");
    }
    std::memcpy(data, bytes_.data() + position_, wanted);
    position_ += wanted;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

// One slice a channel of the interleaved image. OpenEXR takes no const, and writes from it only when it reads
// a file.
Imf::FrameBuffer slicesOf(const Image& image) {
  Imf::FrameBuffer slices;
  const std::size_t texel_bytes = image.channelCount() * sizeof(float);
  const std::size_t row_bytes = texel_bytes * static_cast<std::size_t>(image.size.width);
  for (std::size_t channel = 0; channel < image.channelCount(); ++channel) {
    auto* const first = const_cast<float*>(image.data.data() + channel);
    slices.insert(image.channels[channel],
                  Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(first), texel_bytes, row_bytes));
  }
  return slices;
}

// Files are read whose own header (exr_header.h) has these channels and this size; the library must agree.
bool agrees(const Imf::Header& header, const Image& image) {
  const Imath::Box2i& window = header.dataWindow();
  const Size size{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1};
  return size == image.size && window.min == Imath::V2i(0, 0) &&
         std::ranges::all_of(image.channels, [&](const std::string& name) {
           const Imf::Channel* const channel = header.channels().findChannel(name);
           return channel != nullptr && channel->type != Imf::UINT && channel->xSampling == 1 &&
                  channel->ySampling == 1;
         });
}

}  // namespace

std::string encodeExr(const Image& image, const std::map<std::string, std::string>& metadata,
                      std::vector<unsigned char>& bytes) try {
  Imf::Header header(image.size.width, image.size.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.zipCompressionLevel() = kFastestZip;
  for (const std::string& channel : image.channels) {
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  }
  for (const auto& [key, value] : metadata) {
    header.insert("ssrkit:" + key, Imf::StringAttribute(value));
  }
  // Never more than a little over the texels themselves: grown bit by bit, the bytes would be there two and
  // three times. What is not written takes no memory.
  bytes.reserve(image.data.size() * sizeof(float));
  OutputBytes memory(bytes);
  {
    Imf::OutputFile file(memory, header, kNoThreads);
    file.setFrameBuffer(slicesOf(image));
    file.writePixels(image.size.height);
  }  // the table of the lines is written at the end
  return "";
} catch (const std::exception& problem) {
  return problem.what();
}

std::string decodeExr(const std::string& file, Image& image) try {
  InputBytes memory(file);
  Imf::InputFile input(memory, kNoThreads);
  if (!agrees(input.header(), image)) {
    return "its header contradicts itself";
  }
  input.setFrameBuffer(slicesOf(image));
  input.readPixels(0, image.size.height - 1);
  return "";
} catch (const std::exception& problem) {
  return std::string("it is damaged: ") + problem.what();
}

}  // namespace ssrkit
