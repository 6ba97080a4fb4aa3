#pragma once

#include <dlfcn.h>

namespace ssrkit {

// False, and `function` null, where the library from dlopen() has no function of that name.
template <class Function>
[[nodiscard]] bool findFunction(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

}  // namespace ssrkit
