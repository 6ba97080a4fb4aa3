#include "command/suite_jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/check.h"
#include "frame/stages.h"
#include "frame/techniques.h"
#include "frame/variants.h"

namespace ssrkit {

Sequence sequenceOf(const TestFile& test) {
  Sequence sequence;
  sequence.time_s = test.time_s;
  sequence.time_step_s = test.time_step_s.value_or(sequence.time_step_s);
  for (const TestCase& test_case : test.cases) {
    const auto technique = findTechnique(test_case.technique);
    sequence.frame_count = std::max(sequence.frame_count, technique ? (*technique)->frame_count : 1);
  }
  sequence.frame_count = test.frames.value_or(sequence.frame_count);
  return sequence;
}

std::vector<std::string> variantsOf(const TestFile& test) {
  std::vector<std::string> names;
  for (const TestCase& test_case : test.cases) {
    if (std::ranges::find(names, test_case.variant) == names.end()) {
      names.push_back(test_case.variant);
    }
  }
  return names;
}

std::vector<TestCase> casesOf(const TestFile& test, const std::string& variant) {
  std::vector<TestCase> cases;
  std::ranges::copy_if(test.cases, std::back_inserter(cases),
                       [&](const TestCase& test_case) { return test_case.variant == variant; });
  return cases;
}

int roundsOfPart(int rounds, int part, int parts) {
  return rounds * (part + 1) / parts - rounds * part / parts;
}

Job jobFor(const TestFile& test, const SceneSource& source, const SuiteOptions& options, Size size,
           const std::string& variant) {
  Job job;
  job.id = fmt::format("{}{} {}x{}", options.tests_in_job_ids ? test.id + " " : "", source.name, size.width,
                       size.height);
  job.id += variant.empty() ? "" : " " + variant;
  job.variant = variant;
  job.scene_file = source.file;
  job.camera_name = test.camera.empty() ? source.camera_name : test.camera;
  job.mirror_material = options.mirror_material;
  job.environment = options.environment;
  job.size = size;
  job.frame = test.frame;
  job.sequence = sequenceOf(test);
  job.timing.rounds = roundsOfPart(test.rounds, 0, options.parts);
  job.replacements = options.replacements;
  job.may_replace_nothing = options.tests_draw_different_passes;
  job.shader_root = options.shader_root;
  for (const TestCase& test_case : casesOf(test, variant)) {
    for (const std::string& name : test.stages) {
      // Known, and the values are in range: both were checked when the file or the command line was read.
      const auto stage = findStage(name);
      SSRKIT_CHECK(stage.has_value());
      job.traces.push_back({.stage = name,
                            .parameters = askedParameters(source.defaults, **stage, test_case.parameters),
                            .technique = test_case.technique});
    }
    for (const PeerShader& peer : options.peers) {
      job.traces.push_back(
          {.stage = peer.name,
           .parameters = askedParameters(source.defaults, stages().back(), test_case.parameters),
           .technique = test_case.technique,
           .peer = peer});
    }
  }
  if (source.gbuffer != nullptr) {
    job.gbuffer = source.gbuffer->images;
    job.gbuffer_camera = source.gbuffer->camera;
    job.size = source.gbuffer->camera.size;
  }
  return job;
}

bool comparesWithRendered(const TestFile& test) {
  return std::ranges::any_of(test.expectations, [](const Expectation& expectation) {
    return expectation.truth.kind == TruthKind::kRendered;
  });
}

Environment environmentOf(const std::string& variant) {
  const auto row = findVariant(variant);
  return row ? (*row)->environment : Environment{};
}

}  // namespace ssrkit
