// Words the line.

#include "engine/cli/study_progress.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <string>

#include "engine/cli/progress_line.h"

namespace spoke::cli {
namespace {

/// "45 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

StudyProgress::StudyProgress(std::int64_t done, std::int64_t planned)
    : before_(done), planned_(planned) {}

StudyProgress::~StudyProgress() { show_progress(""); }

double StudyProgress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void StudyProgress::update(std::int64_t done) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + kPause;
  const double rate = static_cast<double>(done - before_) / seconds();
  std::string text = fmt::format("{} of {} runs, {:.0f} %", done, planned_,
                                 100.0 * static_cast<double>(done) / static_cast<double>(planned_));
  if (rate > 0.0)
    text += fmt::format(", {:.3g} runs/s, {} left", rate,
                        duration_text(static_cast<double>(planned_ - done) / rate));
  show_progress(text);
}

}  // namespace spoke::cli
