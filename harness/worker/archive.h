// Packs structs into a payload and back. Each struct lists its fields once, in an overload of
// `fields(archive, value)` that serves both ways, so that the two cannot drift apart. Both ends are the same
// program: values travel as they lie in memory, which keeps every bit of a number, and the bytes of a name
// whatever its encoding.
#pragma once

#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/check.h"
#include "worker/payload.h"

namespace ssrkit {

template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// `T` with or without const: what a `fields` that serves both ways takes.
template <class T, class Plain>
concept Is = std::is_same_v<std::remove_const_t<T>, Plain>;

template <class T>
inline constexpr bool kIsVector = false;
template <class T>
inline constexpr bool kIsVector<std::vector<T>> = true;
template <class T>
inline constexpr bool kIsMap = false;
template <class T>
inline constexpr bool kIsMap<std::map<std::string, T>> = true;
template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

// Of values that are not const, `finish` empties the large arrays as it goes: what is handed over is never
// there twice.
class Packer {
 public:
  template <class... Values>
  void operator()(Values&&... values) {
    (add(values), ...);
  }

  // A large array: goes to the bulk part. It must outlive `finish`.
  template <class Vector>
  void bulk(Vector& values) {
    static_assert(std::is_trivially_copyable_v<typename Vector::value_type>);
    (*this)(static_cast<std::uint64_t>(values.size()));
    BulkPart& part = bulk_.emplace_back();
    part.bytes = std::as_bytes(std::span(values));
    if constexpr (!std::is_const_v<Vector>) {
      part.release = [&values] { Vector().swap(values); };
    }
  }

  void require(bool condition) { SSRKIT_CHECK(condition); }

  [[nodiscard]] Expected<Payload> finish() const {
    return makePayload(std::as_bytes(std::span(header_)), bulk_);
  }

 private:
  template <class T>
  void add(T& value) {
    using Plain = std::remove_const_t<T>;
    if constexpr (Scalar<Plain>) {
      header_.append(reinterpret_cast<const char*>(&value), sizeof(value));
    } else if constexpr (std::is_same_v<Plain, std::string>) {
      (*this)(static_cast<std::uint64_t>(value.size()));
      header_ += value;
    } else if constexpr (std::is_same_v<Plain, std::filesystem::path>) {
      (*this)(value.native());
    } else if constexpr (kIsVector<Plain>) {
      (*this)(static_cast<std::uint64_t>(value.size()));
      for (auto& element : value) {
        (*this)(element);
      }
    } else if constexpr (kIsMap<Plain>) {
      (*this)(static_cast<std::uint64_t>(value.size()));
      for (auto& [key, element] : value) {
        (*this)(key, element);
      }
    } else if constexpr (kIsOptional<Plain>) {
      (*this)(value.has_value());
      if (value) {
        (*this)(*value);
      }
    } else {
      fields(*this, value);
    }
  }

  std::string header_;
  std::vector<BulkPart> bulk_;
};

// Reads what a Packer wrote, once: large arrays are taken out of the payload. It trusts no count and no size:
// on the first that does not fit, `failed` is set and every later value keeps its default.
class Unpacker {
 public:
  explicit Unpacker(const Payload& payload) : payload_(payload) {
    header_.resize(payload.header_bytes);
    failed_ = !readPayload(payload, 0, std::as_writable_bytes(std::span(header_)));
  }

  template <class... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }

  template <class T>
  void bulk(std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t count = takeCount();
    require(count <= (payload_.bulk_bytes - bulk_offset_) / sizeof(T));
    if (failed_) {
      return;
    }
    values.resize(count);
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(values));
    const std::uint64_t offset = payload_.header_bytes + bulk_offset_;
    require(readPayload(payload_, offset, bytes));
    releasePayload(payload_, offset, bytes.size());
    bulk_offset_ += bytes.size();
  }

  void require(bool condition) { failed_ = failed_ || !condition; }

  // Everything fitted and nothing is left over.
  [[nodiscard]] bool succeeded() const {
    return !failed_ && header_offset_ == header_.size() && bulk_offset_ == payload_.bulk_bytes;
  }

 private:
  // The next `count` bytes of the header, or null.
  const char* next(std::uint64_t count) {
    require(count <= header_.size() - header_offset_);
    if (failed_) {
      return nullptr;
    }
    const char* const bytes = header_.data() + header_offset_;
    header_offset_ += count;
    return bytes;
  }
  std::uint64_t takeCount() {
    std::uint64_t count = 0;
    take(count);
    return count;
  }
  // Of things that take a byte of the header or more: a count that cannot be true is refused before memory is
  // taken.
  std::uint64_t takeElementCount() {
    const std::uint64_t count = takeCount();
    require(count <= header_.size() - header_offset_);
    return failed_ ? 0 : count;
  }

  template <Scalar T>
  void take(T& value) {
    if (const char* const bytes = next(sizeof(value))) {
      std::memcpy(&value, bytes, sizeof(value));
    }
  }
  void take(bool& value) {  // any other byte than 0 or 1 in a bool is undefined behaviour
    std::uint8_t byte = 0;
    take(byte);
    require(byte <= 1);
    value = byte == 1;
  }
  void take(std::string& text) {
    const std::uint64_t size = takeElementCount();
    if (const char* const bytes = next(size)) {
      text.assign(bytes, size);
    }
  }
  void take(std::filesystem::path& path) {
    std::string text;
    take(text);
    path = text;
  }
  template <class T>
  void take(std::vector<T>& values) {
    const std::uint64_t count = takeElementCount();
    for (std::uint64_t i = 0; i < count && !failed_; ++i) {
      (*this)(values.emplace_back());
    }
  }
  template <class T>
  void take(std::map<std::string, T>& values) {
    const std::uint64_t count = takeElementCount();
    for (std::uint64_t i = 0; i < count && !failed_; ++i) {
      std::string key;
      (*this)(key);
      (*this)(values[key]);
    }
  }
  template <class T>
  void take(std::optional<T>& value) {
    bool present = false;
    take(present);
    if (present) {
      (*this)(value.emplace());
    }
  }
  template <class T>
  requires std::is_class_v<T>
  void take(T& value) { fields(*this, value); }

  const Payload& payload_;
  std::string header_;
  std::uint64_t header_offset_ = 0;
  std::uint64_t bulk_offset_ = 0;
  bool failed_ = false;
};

}  // namespace ssrkit
