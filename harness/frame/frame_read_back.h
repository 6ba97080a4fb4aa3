// What a job gives back of the frame itself.
#pragma once

#include <map>
#include <set>
#include <string>

#include "base/error.h"
#include "frame/frame_images.h"
#include "image/image.h"

namespace ssrkit {

// Device images of a large frame are made anew for each job: kept, they would stand beside the job's result
// and all that is done with it.
[[nodiscard]] bool isLargeFrame(Size size);

// Of a large frame that is drawn to its end, gives up what neither leaves the device nor is among `names`.
void dropWhatStays(FrameImages& images, const std::set<std::string>& names);

// Every image that leaves the device, by name. Of a large frame, each is given up once it is read, and what
// does not leave the device before that. `is_given`: the G-buffer was made by others, and has no depth
// buffer.
[[nodiscard]] Expected<std::map<std::string, Image>> readFrame(Device& device, FrameImages& images,
                                                               bool is_given);

}  // namespace ssrkit
