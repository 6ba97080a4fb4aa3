#include "command/known_names.h"

#include "device/registry.h"
#include "frame/frames.h"
#include "frame/stages.h"
#include "frame/techniques.h"
#include "frame/variants.h"
#include "scene/find_scene.h"

namespace ssrkit {

KnownNames knownNames(const KitPaths& paths) {
  KnownNames known{.scenes = builtInScenes(paths.scenes)};
  for (const DeviceEntry& entry : deviceEntries()) {
    known.devices.push_back(entry.id);
  }
  for (const Stage& stage : stages()) {
    known.stages.push_back(stage.name);
  }
  for (const FrameKind& kind : frameKinds()) {
    known.frames.push_back(kind.name);
  }
  for (const Technique& technique : techniques()) {
    known.techniques.push_back(technique.name);
  }
  for (const Variant& variant : variants()) {
    known.variants.push_back(variant.name);
  }
  return known;
}

}  // namespace ssrkit
