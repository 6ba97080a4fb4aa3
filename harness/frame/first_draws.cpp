#include "frame/first_draws.h"

#include "base/check.h"
#include "device/pass_clock.h"

namespace ssrkit {

void FirstDraws::startJob(const Progress& progress) {
  progress_ = &progress;
  drawn_.clear();
}

Expected<PassTime> FirstDraws::draw(const PassDesc& pass) {
  SSRKIT_CHECK(progress_ != nullptr);
  if (!drawn_.insert(pass.program).second) {
    return behind().draw(pass);
  }
  (*progress_)("build " + pass.name);
  PassDesc nothing = pass;
  nothing.scissor = Rect{pass.viewport.x, pass.viewport.y, 0, 0};
  const auto built = behind().draw(nothing);
  if (!built) {
    return built;
  }
  (*progress_)("draw " + pass.name);
  auto time = behind().draw(pass);
  if (time) {
    *time += *built;
  }
  return time;
}

}  // namespace ssrkit
