// Writes lines to stderr, if that is a terminal, a few times a second at most.

#include "program/cli/progress.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace spoke::cli {
namespace {

/// Returns "45 s", "3 min 20 s" or "2 h 5 min".
std::string duration_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

void show_progress(const std::string& text) {
  static const bool shown = isatty(STDERR_FILENO) == 1;
  if (!shown) return;
  std::fputs(("\r" + text + "\033[K").c_str(), stderr);
  std::fflush(stderr);
}

void CountProgress::show(std::size_t done) const {
  show_progress(fmt::format("{} of {} {}", done, all_, what_));
}

ProgressBar::ProgressBar(double start, double duration, bool wanted)
    : from_(start), duration_(duration), shown_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::update(double t) {
  if (!shown_) return;
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + kPause;
  draw(t, now);
}

void ProgressBar::draw(double t, Clock::time_point now) const {
  constexpr int width = 30;
  const double fraction = std::clamp(t / duration_, 0.0, 1.0);
  const int filled = static_cast<int>(fraction * width);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double speed = elapsed > 0.0 ? (t - from_) / elapsed : 0.0;
  const std::string line =
      fmt::format("\r[{:#<{}}{:.<{}}] {:3.0f} %  t = {:.4g} of {:.4g} s  {:.3g} s/s\033[K", "",
                  filled, "", width - filled, 100.0 * fraction, t, duration_, speed);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

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
