// A technique is written once; the frame decides what its reflection is put together with.
#pragma once

#include "base/error.h"
#include "frame/frames.h"
#include "frame/techniques.h"

namespace ssrkit {

// The technique as this kind of frame draws it: with the frame's own passes in the place of those that would
// count some of its light twice. Fails where the technique is made for another frame, and names the row that
// is made for this one, if there is any.
[[nodiscard]] Expected<Technique> inFrame(const Technique& technique, const FrameKind& kind);

}  // namespace ssrkit
