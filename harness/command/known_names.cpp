#include "command/known_names.h"

#include "device/registry.h"
#include "device/tolerance_class.h"
#include "frame/frames.h"
#include "frame/stages.h"
#include "frame/techniques.h"
#include "frame/variants.h"
#include "scene/find_scene.h"

namespace ssrkit {

namespace {

// Both are known: the file's reader looked them up first.
std::string toleranceLetter(const std::string& a, const std::string& b) {
  const auto first = findDevice(a);
  const auto second = findDevice(b);
  return first && second ? std::string(letterOf(toleranceClass(**first, **second))) : std::string();
}

}  // namespace

KnownNames knownNames(const KitPaths& paths) {
  KnownNames known{.scenes = builtInScenes(paths.scenes), .tolerance_class = toleranceLetter};
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
