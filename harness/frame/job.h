// A job: what one worker is asked to do with one scene, camera and size on one device, and what comes back.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/size.h"
#include "device/device.h"
#include "frame/peer.h"
#include "frame/sequence.h"
#include "frame/setup_times.h"
#include "image/image.h"
#include "image/ray_record.h"
#include "scene/scene.h"
#include "spaces/camera.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// One trace over the job's G-buffer. A job may hold many: they share the scene, the G-buffer and the light.
struct TraceRequest {
  std::string stage;  // a row of frame/stages.h: "naive", "refined", "dda", "hiz", "walk"
  TraceParameters parameters;
  std::string technique = "mirror";  // a row of frame/techniques.h; empty: the trace alone, no picture
  std::optional<PeerShader> peer;    // in the place of a stage; `stage` is then its name
};

// Times passes against each other: `rounds` interleaved runs of the frame and all of the job's traces after
// one warm-up.
struct TimingRequest {
  int rounds = 0;  // 0: each pass is drawn once and its time is cold
};

// A file of the user's own in the place of a pass's shader.
struct ShaderReplacement {
  std::string pass;
  std::filesystem::path file;
};

struct Job {
  std::string id;  // for messages: "clutter 640x360"
  // Either a scene file with a camera name ("" the first) ...
  std::filesystem::path scene_file;
  std::string camera_name;
  std::string mirror_material;                   // "" the scene's own mirrors
  std::optional<EnvironmentChoice> environment;  // in the place of the scene's own
  // ... or a G-buffer made by others, by image name ("dist_view", "normal_view", ...).
  std::map<std::string, Image> gbuffer;
  std::optional<Camera> gbuffer_camera;
  Size size;
  std::string frame = "basic";  // a row of frame/frames.h
  Sequence sequence;            // a G-buffer made by others stays the same in all of its frames
  std::vector<TraceRequest> traces;
  TimingRequest timing;
  std::vector<ShaderReplacement> replacements;
  bool may_replace_nothing = false;  // other jobs draw what this one may not; else that is an error
  std::filesystem::path shader_root;
  std::string variant;       // a row of frame/variants.h; empty: none
  bool want_gbuffer = true;  // read back and return the frame's images
};

struct PassReport {
  std::string pass;
  PassTime cold;                 // first draw: JIT compile included
  std::vector<PassTime> steady;  // one a round
};

struct TraceResult {
  std::string stage;
  std::string technique;
  TraceParameters parameters;  // as used, with defaults filled in
  RayRecord record;
  // What the technique reads back: "reflection" (RGBA, a = 1 where the ray hit), "composite" (RGB, linear),
  // ... and under a frame image's name ("normal_view") what the tracer read in its place.
  std::map<std::string, Image> images;
  std::vector<PassReport> passes;  // pyramid, trace, the technique's
};

struct JobResult {
  Camera camera;
  std::map<std::string, Image>
      images;  // albedo, normal_view, material, depth_window, dist_view, motion, lit ...
  std::vector<TraceResult> traces;
  std::vector<PassReport> frame_passes;   // G-buffer and the passes of the frame's kind
  std::vector<std::string> drawn_passes;  // by the names that replacements have; stages by their shaders'
  SetupTimes setup;                       // of the programs that no earlier job had made
  std::vector<std::string> notes;         // the scene's
  std::vector<std::string> messages;      // driver and validation; any one fails the job
};

}  // namespace ssrkit
