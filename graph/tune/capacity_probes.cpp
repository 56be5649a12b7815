// Probes of the machine's capacity, their pauses and their budget.

#include "graph/tune/capacity_probes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <cstdio>

#include "graph/calibrate/capacity.h"
#include "graph/machine/time_stamp.h"

namespace spoke::graph {
namespace {

constexpr double kLeastCapacity = 1.2;  // below it, other threads are not worth waking
constexpr double kFirstPause = 5e-3;    // s; the next ones are ...
constexpr double kLongerPause = 3.0;    // ... times as long
// So many probes are made whatever they cost: threads that were just made may all wait on one
// processor.
constexpr int kLeastProbes = 2;

}  // namespace

CapacityProbes::CapacityProbes(int threads, double seconds)
    : threads_(threads), expected_(seconds), pause_(kFirstPause) {
  assert(threads >= 1);
}

bool CapacityProbes::find_worth(double elapsed) {
  const std::uint64_t begin = time_stamp();
  capacity_ = measure_capacity(threads_);
  spent_ += seconds_since(begin);
  ++count_;
  if (capacity_ >= kLeastCapacity) return true;
  begin_pause(elapsed, false);
  return false;
}

void CapacityProbes::begin_pause(double elapsed, bool is_passing) {
  constexpr double probe = 2e-3;  // s
  if (is_passing) pause_ = kFirstPause;
  resume_at_ = elapsed + pause_;
  pause_ *= kLongerPause;
  if (count_ < kLeastProbes) return;
  const double payable_at = (spent_ + probe) / kTuningShare;
  if (payable_at > expected_) resume_at_ = std::max(resume_at_, payable_at);
}

std::string CapacityProbes::describe() const {
  assert(capacity_ > 0.0 && "measured once");
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "%d threads do %.2g times the work of one here", threads_,
                capacity_);
  return text.data();
}

}  // namespace spoke::graph
