#include "image/codec.h"

#include <dlfcn.h>

namespace ssrkit {

namespace {

struct Loaded {
  const ImageCodec* codec = nullptr;
  std::string problem;
};

Loaded load() {
  // Never closed: the library's threads and caches live as long as the process.
  void* const module = dlopen(SSRKIT_IMAGE_CODEC, RTLD_NOW | RTLD_LOCAL);
  void* const symbol = module != nullptr ? dlsym(module, kImageCodecSymbol) : nullptr;
  if (symbol == nullptr) {
    return {.codec = nullptr, .problem = dlerror()};
  }
  return {.codec = reinterpret_cast<ImageCodecFunction*>(symbol)(), .problem = {}};
}

}  // namespace

Expected<const ImageCodec*> imageCodec() {
  static const Loaded loaded = load();
  if (loaded.codec == nullptr) {
    return setupError(
        "load the reader and writer of pictures", loaded.problem, "",
        "check the installation of the packages libopenexr-dev, libpng-dev and libfreetype-dev");
  }
  return loaded.codec;
}

}  // namespace ssrkit
