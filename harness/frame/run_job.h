#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "device/device.h"
#include "frame/job.h"
#include "frame/progress.h"
#include "shader/compiler.h"

namespace ssrkit {

// Runs one job on one device. Scenes and programs are kept between jobs of one runner.
class JobRunner {
 public:
  JobRunner(Device& device, ShaderTarget target);
  ~JobRunner();
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;

  [[nodiscard]] Expected<JobResult> run(const Job& job, const Progress& progress);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ssrkit
