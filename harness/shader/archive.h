// Plain values to bytes and back, for the cache and for the compiler's child process. The bytes are this
// machine's own: little-endian or not, they never leave it.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ssrkit {

// `fields(archive, value)` hands every member of a struct to the archive: one list serves both directions.
class ArchiveWriter {
 public:
  template <class T>
  void operator()(const T& value) {
    if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
      const auto number = static_cast<std::uint32_t>(value);
      bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
    } else {
      fields(*this, value);
    }
  }
  void operator()(const std::string& value) {
    (*this)(static_cast<std::uint32_t>(value.size()));
    bytes_ += value;
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(static_cast<std::uint32_t>(values.size()));
    for (const T& value : values) {
      (*this)(value);
    }
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  void operator()(T& value) {
    if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
      std::uint32_t number = 0;
      take(&number, sizeof number);
      value = static_cast<T>(number);
    } else {
      fields(*this, value);
    }
  }
  void operator()(std::string& value) {
    const std::size_t size = count();
    value.resize(size);
    take(value.data(), size);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    const std::size_t size = count();
    values.clear();
    values.reserve(size);
    for (std::size_t i = 0; i < size && good_; ++i) {
      (*this)(values.emplace_back());
    }
  }

  // Every value was there and nothing is left over.
  [[nodiscard]] bool isComplete() const { return good_ && rest_.empty(); }

 private:
  // Every element takes a byte or more, so no count may exceed what is left: a bad one must not reserve.
  std::size_t count() {
    std::uint32_t number = 0;
    take(&number, sizeof number);
    good_ = good_ && number <= rest_.size();
    return good_ ? number : 0;
  }

  void take(void* target, std::size_t size) {
    good_ = good_ && size <= rest_.size();
    if (good_ && size > 0) {
      std::memcpy(target, rest_.data(), size);
      rest_.remove_prefix(size);
    }
  }

  std::string_view rest_;
  bool good_ = true;
};

}  // namespace ssrkit
