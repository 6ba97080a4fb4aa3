// Times of passes over several rounds: the first of each pass is cold, the later ones are steady.
#pragma once

#include <string>
#include <vector>

#include "device/device.h"
#include "frame/job.h"

namespace ssrkit {

class PassTimes {
 public:
  // Several draws of one pass in one round (samples, mips) count as one, with their sum.
  void add(const std::string& pass, const PassTime& time);
  void endRound();

  // In the order in which the passes were first drawn.
  [[nodiscard]] const std::vector<PassReport>& reports() const { return reports_; }

 private:
  struct Drawn {
    std::string pass;
    PassTime time;
  };
  std::vector<Drawn> round_;
  std::vector<PassReport> reports_;
};

}  // namespace ssrkit
