// What expectations are held against: the answers that a run has collected. All pointers must outlive the
// check.
#pragma once

#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/size.h"
#include "check/expectation.h"
#include "image/image.h"
#include "image/ray_record.h"
#include "oracle/geometry.h"
#include "oracle/oracle.h"
#include "spaces/trace_parameters.h"

namespace ssrkit {

// One timed run of one pass.
struct TimeSample {
  double cpu_ns = 0.0;  // of the whole process
  double wall_ns = 0.0;
};

// One answer: what one stage said of one scene on one device, or (stage empty) what the device rendered for
// all of them.
struct Answer {
  std::string stage;
  std::string case_name;
  std::string device;
  Size size;
  std::string input;                     // the device whose G-buffer was uploaded; empty: the device's own
  std::string variant;                   // of the job; empty: the plain one
  std::vector<std::string> frame_cases;  // of a frame (stage empty): the cases that share it; empty: all
  std::string shown_in;  // the variant whose changed view it is in; empty: the scene's own view
  bool is_made = false;  // out of another answer, to hold others against: it is not judged itself
  TraceParameters parameters;
  const RayRecord* record = nullptr;
  const OracleInput* oracle_input = nullptr;   // over the very depth image that this stage read
  const OracleResult* oracle = nullptr;        // may be absent
  const GeometryResult* geometry = nullptr;    // likewise; traced from oracle_input
  const Image* true_dist_view = nullptr;       // of the frame; likewise
  std::map<std::string, const Image*> images;  // by buffer: "dist_view", "lit", "composite"
  // By pass: one sample a round. All stages' rounds are interleaved: sample i of each was taken in the same
  // round.
  std::map<std::string, std::vector<TimeSample>> times;
};

// Everything that one test collected of one scene, and the answer that is judged.
struct Subject {
  std::string test_id;
  std::string scene;
  const Answer* self = nullptr;
  std::span<const Answer>
      pool;           // holds every answer that `truth` or `cases` may name, `self` among them or not
  std::string repro;  // the command that runs this check alone
  const Answer* golden = nullptr;  // what the truth `golden` is; null where nobody has blessed one that fits
};

// Whether the frame's answer is the one that the case was traced over.
[[nodiscard]] bool sharesFrame(const Answer& frame, const std::string& case_name);

// The answer that `truth` names, seen from the subject's own; or why there is none, as a sentence.
[[nodiscard]] std::variant<const Answer*, std::string> answerOfTruth(const Subject& subject,
                                                                     const Truth& truth);

// The subject's own stage, device and size in another case; null when it is not in the pool.
[[nodiscard]] const Answer* answerOfCase(const Subject& subject, const std::string& case_name);

}  // namespace ssrkit
