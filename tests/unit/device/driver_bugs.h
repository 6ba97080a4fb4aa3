// What the tests of drivers' faults share.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "device/gl/gl_session.h"
#include "device/gl/osmesa_context.h"
#include "device_fixture.h"

#define SSRKIT_SKIP_IF_MENDED(is_there)                    \
  if (!(is_there)) {                                       \
    GTEST_SKIP() << "this driver no longer has the fault"; \
  }

namespace ssrkit {

inline std::shared_ptr<GlSession> llvmpipeSession() {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  return valueOf(GlSession::create(valueOf(createOsmesaContext())));
}

}  // namespace ssrkit
