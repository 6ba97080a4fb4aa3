#include "frame/gbuffer_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "image/exr.h"
#include "spaces/camera_json.h"

namespace ssrkit {

namespace {

const std::string kAttempted = "read the G-buffer";

// One image file and the channel names it may come with, the kit's own first.
struct FileRow {
  std::string name;
  bool is_required;
  std::vector<std::vector<std::string>> channel_sets;
};

const std::vector<FileRow>& fileRows() {
  static const std::vector<FileRow> rows = {
      {"dist_view", true, {{"Z"}, {"V"}, {"Y"}, {"R"}}},
      {"normal_view", true, {{"R", "G", "B", "A"}, {"R", "G", "B"}, {"X", "Y", "Z"}}},
      {"albedo", false, {{"R", "G", "B"}}},
      {"material", false, {{"R", "G", "B"}}},
      {"emission", false, {{"R", "G", "B"}}},
      {"motion", false, {{"X", "Y"}, {"R", "G"}}},
      {"lit", false, {{"R", "G", "B"}}},
      {"lit_base", false, {{"R", "G", "B"}}},
  };
  return rows;
}

std::string texelText(std::size_t texel, Size size) {
  const auto width = static_cast<std::size_t>(size.width);
  return fmt::format("texel ({}, {})", texel % width, texel / width);
}

Image withChannels(const Image& image, const std::vector<std::string>& channels) {
  Image picked(image.size, channels);
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    const auto from = static_cast<std::size_t>(std::ranges::find(image.channels, channels[channel]) -
                                               image.channels.begin());
    for (std::size_t texel = 0; texel < image.texelCount(); ++texel) {
      picked.data[texel * channels.size() + channel] = image.data[texel * image.channelCount() + from];
    }
  }
  return picked;
}

Expected<Image> readFileOf(const FileRow& row, const std::filesystem::path& file, Size size) {
  auto image = readExr(file, {.channels = {}, .size = size});
  if (!image) {
    return image;
  }
  for (const auto& channels : row.channel_sets) {
    const bool has_all = std::ranges::all_of(channels, [&](const std::string& channel) {
      return std::ranges::count(image->channels, channel) > 0;
    });
    if (has_all) {
      return withChannels(*image, channels);
    }
  }
  return inputError(kAttempted,
                    fmt::format("the image has the channels {}, not {}", joinNames(image->channels),
                                joinNames(row.channel_sets.front())),
                    file.string());
}

// Depths and normals that no tracer can start from are refused here, by texel, rather than traced into
// nonsense.
Expected<void> checkValues(const Image& dist_view, const Image& normal_view,
                           const std::filesystem::path& folder) {
  for (std::size_t texel = 0; texel < dist_view.texelCount(); ++texel) {
    const float dist = dist_view.data[texel];
    if (std::isnan(dist) || dist <= 0.0F) {
      return inputError(kAttempted,
                        fmt::format("dist_view is {} at {}", dist, texelText(texel, dist_view.size)),
                        (folder / "dist_view.exr").string(), "it must be metres over 0, +inf for background");
    }
    const float* normal = normal_view.data.data() + texel * normal_view.channelCount();
    const float length = std::hypot(normal[0], normal[1], normal[2]);
    if (!std::isinf(dist) && !(length > 0.5F && length < 2.0F)) {
      return inputError(
          kAttempted,
          fmt::format("normal_view has length {} at {}", length, texelText(texel, dist_view.size)),
          (folder / "normal_view.exr").string(), "it must hold unit vectors in view space");
    }
  }
  for (const float value : normal_view.data) {
    if (std::isnan(value)) {
      return inputError(kAttempted, "normal_view holds NaN", (folder / "normal_view.exr").string());
    }
  }
  return {};
}

std::optional<std::filesystem::path> firstThatExists(const std::vector<std::filesystem::path>& candidates) {
  for (const std::filesystem::path& path : candidates) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {
      return path;
    }
  }
  return std::nullopt;
}

}  // namespace

Expected<GbufferFiles> readGbuffer(const std::filesystem::path& given_folder) {
  std::error_code ignored;
  std::filesystem::path folder = std::filesystem::weakly_canonical(given_folder, ignored);
  if (!std::filesystem::is_directory(folder, ignored)) {
    return inputError(kAttempted, "there is no such folder", given_folder.string());
  }
  const auto camera_file = firstThatExists({folder / "camera.json", folder.parent_path() / "camera.json",
                                            folder.parent_path().parent_path() / "camera.json"});
  if (!camera_file) {
    return inputError(kAttempted, "camera.json is missing", given_folder.string(),
                      "put it beside the images, docs/formats.md has its keys");
  }
  const auto text = readFile(*camera_file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  auto camera = cameraFromJson(*text, camera_file->string());
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  GbufferFiles files{.name = folder.filename().string(), .camera = *camera, .images = {}};
  for (const FileRow& row : fileRows()) {
    const std::string file_name = row.name + ".exr";
    const auto file = firstThatExists({folder / file_name, folder / "gbuffer" / file_name});
    if (!file) {
      if (row.is_required) {
        return inputError(kAttempted, file_name + " is missing", given_folder.string());
      }
      continue;
    }
    auto image = readFileOf(row, *file, files.camera.size);
    if (!image) {
      return tl::make_unexpected(image.error());
    }
    files.images.emplace(row.name, std::move(*image));
  }
  if (const auto valid =
          checkValues(files.images.at("dist_view"), files.images.at("normal_view"), given_folder);
      !valid) {
    return tl::make_unexpected(valid.error());
  }
  return files;
}

}  // namespace ssrkit
