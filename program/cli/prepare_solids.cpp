#include "program/cli/prepare_solids.h"

#include <spdlog/fmt/fmt.h>

#include "engine/support/memory.h"
#include "models/tree/solid_part.h"
#include "program/cli/progress.h"

namespace spoke::cli {

SolidProgress::~SolidProgress() {
  if (!last_.empty()) show_progress("");
}

void SolidProgress::show(const std::string& step, double done) {
  constexpr std::chrono::milliseconds kPause{100};  // between drawings
  const auto now = Clock::now();
  if (step == last_ && now < next_) return;
  last_ = step;
  next_ = now + kPause;
  show_progress(fmt::format("{} {:.0f} %", step, 100.0 * done));
}

void prepare_solids(const Scenario& scenario, bool shows_progress) {
  if (!scenario.space) return;
  SolidProgress progress;
  const auto show = [&](const std::string& step, double done) {
    if (shows_progress) progress.show(step, done);
  };
  spatial::SolidParts(*scenario.space).make_constants({show, available_memory()});
}

}  // namespace spoke::cli
