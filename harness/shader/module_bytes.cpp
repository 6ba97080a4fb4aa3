#include "shader/module_bytes.h"

#include <type_traits>

#include "shader/archive.h"

namespace ssrkit {

namespace {

template <class T, class U>
concept Like = std::is_same_v<std::remove_const_t<T>, U>;

}  // namespace

template <class Archive, Like<SamplerBinding> T>
void fields(Archive& archive, T& value) {
  archive(value.name);
  archive(value.binding);
  archive(value.kind);
}

template <class Archive, Like<BlockMember> T>
void fields(Archive& archive, T& value) {
  archive(value.name);
  archive(value.type);
  archive(value.offset_bytes);
  archive(value.rows);
  archive(value.columns);
  archive(value.matrix_stride_bytes);
  archive(value.array_count);
  archive(value.array_stride_bytes);
}

template <class Archive, Like<UniformBlock> T>
void fields(Archive& archive, T& value) {
  archive(value.name);
  archive(value.binding);
  archive(value.size_bytes);
  archive(value.members);
}

template <class Archive, Like<StageVariable> T>
void fields(Archive& archive, T& value) {
  archive(value.name);
  archive(value.location);
  archive(value.type);
  archive(value.components);
}

template <class Archive, Like<SpecConstantInfo> T>
void fields(Archive& archive, T& value) {
  archive(value.name);
  archive(value.id);
  archive(value.type);
  archive(value.default_bits);
}

template <class Archive, Like<ShaderModule> T>
void fields(Archive& archive, T& value) {
  archive(value.spirv);
  archive(value.interface.samplers);
  archive(value.interface.uniform_blocks);
  archive(value.interface.inputs);
  archive(value.interface.outputs);
  archive(value.interface.spec_constants);
}

template <class Archive, Like<Error> T>
void fields(Archive& archive, T& value) {
  archive(value.kind);
  archive(value.attempted);
  archive(value.problem);
  archive(value.where);
  archive(value.remedy);
  archive(value.reasons);
}

namespace {

template <class T>
std::string written(const T& value) {
  ArchiveWriter writer;
  writer(value);
  return writer.take();
}

template <class T>
std::optional<T> readBack(std::string_view bytes) {
  ArchiveReader reader(bytes);
  T value;
  reader(value);
  return reader.isComplete() ? std::optional<T>(std::move(value)) : std::nullopt;
}

}  // namespace

std::string toBytes(const ShaderModule& module) {
  return written(module);
}
std::string toBytes(const Error& error) {
  return written(error);
}
std::optional<ShaderModule> moduleFromBytes(std::string_view bytes) {
  return readBack<ShaderModule>(bytes);
}
std::optional<Error> errorFromBytes(std::string_view bytes) {
  return readBack<Error>(bytes);
}

}  // namespace ssrkit
