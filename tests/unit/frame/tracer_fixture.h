// Traces jobs by the kit's tracers, or by mutants of them.
#pragma once

#include "frame/run_job.h"
#include "pass_test.h"

namespace ssrkit {

class TracerFixture : public PassTest {
 protected:
  // An absolute path in the place of the stage's own shader is a mutant's.
  [[nodiscard]] RayRecord trace(Job job, const std::string& stage, const TraceParameters& parameters,
                                const std::string& shader) {
    job.traces = {{.stage = stage, .parameters = parameters, .technique = ""}};
    job.want_gbuffer = false;
    if (shader.starts_with('/')) {
      job.replacements = {{.pass = stage, .file = shader}};
    }
    const auto result = JobRunner(*device_, target_).run(job, [](const std::string&) {});
    EXPECT_TRUE(result.has_value()) << sentence(result.error());
    return result ? result->traces.front().record : RayRecord{};
  }
};

}  // namespace ssrkit
