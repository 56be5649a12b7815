// Draws the bar, a few times a second at most.

#include "engine/cli/progress_bar.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace spoke::cli {

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

}  // namespace spoke::cli
