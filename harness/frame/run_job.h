#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/error.h"
#include "device/device.h"
#include "frame/job.h"
#include "shader/compiler.h"

namespace ssrkit {

// Told what is about to begin ("compile trace_hiz", "draw gbuffer"), so that a crash can be laid at its door.
using Progress = std::function<void(const std::string&)>;

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
