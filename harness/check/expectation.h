// What must hold, as data: the content of one file of tests/expect/ (docs/expectations.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/size.h"
#include "check/geometry_verdict.h"
#include "check/metric_table.h"
#include "check/verdict.h"

namespace ssrkit {

// What an answer is held against.
struct Truth {
  TruthKind kind = TruthKind::kNone;
  std::string name;  // the device, stage, case or size ("1280x720") of kCross, kStage, kCase and kSize

  bool operator==(const Truth&) const = default;
};

// "oracle", "cross:vk-lavapipe"
[[nodiscard]] std::string truthText(const Truth& truth);

// One set of parameters that a test is run with.
struct TestCase {
  std::string name;  // empty for the only case of a test without [[case]]
  std::vector<std::pair<std::string, std::string>>
      parameters;         // setParameter's names and values, over the scene's
  std::string technique;  // what makes a picture of each trace; empty: the run's own, or none
  std::string variant;    // how the job is asked in another way (frame/variants.h); empty: the plain job
};

struct Expectation {
  std::string name;  // unique in its test; the metric's name where the file gives none
  Metric metric = Metric::kDifferentRays;
  std::string buffer = "hit";       // "hit" or an image: "dist_view", "composite"
  std::vector<std::string> stages;  // the stages it is asked of; empty for a buffer of the frame
  std::vector<std::string> cases;   // the cases it is asked of; for metrics over cases, the cases in order
  std::vector<Size> sizes;          // empty: every size of the test
  std::optional<std::vector<std::string>> devices;  // the devices it is asked of; absent: all
  Truth truth;
  std::optional<double> max;
  std::optional<double> min;
  double percentile = 100.0;      // 100: the largest
  bool has_percentile = false;    // it was given; `flip` is a mean without it
  double margin = 0.05;           // of the bound: a measured ratio fails only beyond bound * (1 + margin)
  std::vector<Verdict> verdicts;  // the verdicts that verdict_count and verdict_share count
  std::vector<TrueClass> true_classes;             // the rays that the truth `geometry` counts
  std::vector<GeometryVerdict> geometry_verdicts;  // the verdicts of true_verdict_share
  std::vector<std::string> ignore;                 // fields of the record that `identical` leaves out
  std::vector<std::string> passes;                 // passes whose times are summed
  std::vector<std::string> over;                   // pass_cpu_share: the passes they are divided by
  bool allow_empty = false;                        // an image without a single ray passes
  std::string where;                               // "tests/expect/hiz.toml:12:1"
};

// One file.
struct TestFile {
  std::string id;
  std::string about;
  std::vector<std::string> scenes;   // names, or only "all"
  std::string camera;                // empty: the scene's first
  std::vector<Size> sizes;           // empty: the run's
  std::vector<std::string> devices;  // empty: the run's
  std::vector<std::string> stages;
  std::vector<std::string> tags;
  std::string frame = "basic";  // the kind of frame that is drawn
  std::string input;          // the device whose G-buffer every device is given; empty: each renders its own
  std::optional<int> frames;  // of a sequence; absent: as many as its techniques want
  std::optional<double> time_s;  // of the last frame
  std::optional<double> time_step_s;
  int rounds = 0;               // interleaved timing rounds; 0: nothing is timed
  std::vector<TestCase> cases;  // never empty
  std::vector<Expectation> expectations;
  std::string file;
};

}  // namespace ssrkit
