#include "frame/packed_techniques.h"

#include "frame/shared_passes.h"

namespace ssrkit {

namespace {

// The picture of the technique "mirror", traced from images that were packed and read back.
Technique packed(const std::string& name, const std::string& about, std::vector<FramePass> passes,
                 std::map<std::string, std::string> trace_inputs) {
  return {.name = name,
          .about = about,
          .before_pyramid = std::move(passes),
          .trace_inputs = std::move(trace_inputs),
          .after_trace = {resolvePass(), {.name = "composite", .outputs = {"composite"}}}};
}

}  // namespace

std::vector<Technique> packedTechniques() {
  return {
      packed("normals_octahedral", "mirror, from normals in 2 x 16 bits, octahedral",
             {{.name = "normal_pack_octahedral", .outputs = {"normal_octahedral"}},
              {.name = "normal_unpack_octahedral", .outputs = {"normal_unpacked"}}},
             {{"normal_view", "normal_unpacked"}}),
      packed("normals_xy_sign", "mirror, from normals in 2 x 16 bits, x, y and the sign of z",
             {{.name = "normal_pack_xy_sign", .outputs = {"normal_xy_sign"}},
              {.name = "normal_unpack_xy_sign", .outputs = {"normal_unpacked"}}},
             {{"normal_view", "normal_unpacked"}}),
      packed("depth_stored", "mirror, from the depth that the rasteriser stores",
             {{.name = "dist_from_window", .outputs = {"dist_unpacked"}}}, {{"dist_view", "dist_unpacked"}})};
}

}  // namespace ssrkit
