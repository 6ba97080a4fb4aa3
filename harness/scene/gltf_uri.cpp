#include "scene/gltf_uri.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/atomic_file.h"
#include "scene/clean_name.h"

namespace ssrkit {

namespace fs = std::filesystem;

namespace {

// 0..63 for a character of the base64 alphabets (the plain and the URL one), -1 for any other.
int base64Digit(char c) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t position = kAlphabet.find(c == '-' ? '+' : c == '_' ? '/' : c);
  return position == std::string_view::npos ? -1 : static_cast<int>(position);
}

std::optional<std::vector<std::uint8_t>> decodeBase64(std::string_view text) {
  std::array<int, 256> digits{};
  for (int c = 0; c < 256; ++c) {
    digits[static_cast<std::size_t>(c)] = base64Digit(static_cast<char>(c));
  }
  while (!text.empty() && text.back() == '=') {
    text.remove_suffix(1);
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t window = 0;
  int bit_count = 0;
  for (const char c : text) {
    const int digit = digits[static_cast<unsigned char>(c)];
    if (digit < 0) {
      return std::nullopt;
    }
    window = (window << 6U) | static_cast<std::uint32_t>(digit);
    bit_count += 6;
    if (bit_count >= 8) {
      bit_count -= 8;
      bytes.push_back(static_cast<std::uint8_t>(window >> static_cast<unsigned>(bit_count)));
    }
  }
  return bytes;
}

Expected<std::vector<std::uint8_t>> readDataUri(const GltfSource& source, std::string_view uri,
                                                const std::string& place) {
  constexpr std::string_view kMarker = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(kMarker)) {
    return source.refuse(place, "the data: URI is not base64");
  }
  auto bytes = decodeBase64(uri.substr(comma + 1));
  if (!bytes) {
    return source.refuse(place, "the data: URI holds a character that is not base64");
  }
  return *std::move(bytes);
}

int hexDigit(char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const std::size_t position = kDigits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  return position == std::string_view::npos ? -1 : static_cast<int>(position);
}

// "%20" becomes a space; a '%' without two hexadecimal digits stays as it is.
std::string percentDecoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape =
        text[i] == '%' && i + 2 < text.size() && hexDigit(text[i + 1]) >= 0 && hexDigit(text[i + 2]) >= 0;
    decoded += escape ? static_cast<char>(16 * hexDigit(text[i + 1]) + hexDigit(text[i + 2])) : text[i];
    i += escape ? 2U : 0U;
  }
  return decoded;
}

bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos && uri.find('/') > colon;
}

// Whether `path`, links followed, lies in `folder`.
bool isInside(const fs::path& path, const fs::path& folder) {
  std::error_code failed;
  const fs::path real_folder = fs::weakly_canonical(folder, failed);
  const fs::path real_path = failed ? fs::path() : fs::weakly_canonical(path, failed);
  if (failed) {
    return false;
  }
  const auto parted =
      std::mismatch(real_folder.begin(), real_folder.end(), real_path.begin(), real_path.end());
  return parted.first == real_folder.end();
}

}  // namespace

bool isDataUri(std::string_view uri) {
  return uri.starts_with("data:");
}

Expected<fs::path> gltfUriFile(const GltfSource& source, const std::string& uri, const std::string& place) {
  std::string text = percentDecoded(uri);
  const std::string shown = cleanName(text);
  std::replace(text.begin(), text.end(), '\\', '/');
  const fs::path relative(text);
  if (text.empty() || text.find('\0') != std::string::npos) {
    return source.refuse(place, "the URI is not a file name");
  }
  if (hasScheme(text)) {
    return source.refuse(place,
                         fmt::format("the URI '{}' is neither data: nor a file beside the scene", shown));
  }
  const fs::path folder = source.file.has_parent_path() ? source.file.parent_path() : fs::path(".");
  const bool leads_out =
      relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end();
  if (leads_out || !isInside(folder / relative, folder)) {
    return source.refuse(place, fmt::format("the URI '{}' leads out of the scene's folder", shown),
                         "put the file beside the scene");
  }
  return folder / relative;
}

Expected<std::vector<std::uint8_t>> readGltfUri(const GltfSource& source, const std::string& uri,
                                                const std::string& place) {
  if (isDataUri(uri)) {
    return readDataUri(source, uri, place);
  }
  const auto file = gltfUriFile(source, uri, place);
  if (!file) {
    return tl::make_unexpected(file.error());
  }
  const Expected<std::string> content = readFile(*file, kMaxGltfFileBytes);
  if (!content) {
    return source.refuse(place,
                         fmt::format("'{}': {}", cleanName(percentDecoded(uri)), content.error().problem),
                         "put the file beside the scene");
  }
  return std::vector<std::uint8_t>(content->begin(), content->end());
}

}  // namespace ssrkit
