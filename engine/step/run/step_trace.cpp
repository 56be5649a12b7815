// Finds the slices of one step, and joins traces.

#include "engine/step_trace.h"

#include <algorithm>
#include <iterator>

namespace spoke {

std::vector<NodeSlice> StepTrace::slices_of(std::int64_t step) const {
  std::vector<NodeSlice> found;
  const bool is_recorded = std::any_of(
      steps.begin(), steps.end(), [step](const TracedStep& traced) { return traced.step == step; });
  if (is_recorded)
    std::copy_if(slices.begin(), slices.end(), std::back_inserter(found),
                 [step](const NodeSlice& slice) { return slice.step == step; });
  return found;
}

void StepTrace::append(const StepTrace& later) {
  std::int64_t end = runs.empty() ? 0 : runs.back().end;
  for (const NodeSlice& slice : slices) end = std::max(end, slice.end);
  asked_steps = static_cast<std::int64_t>(steps.size()) + dropped_steps + later.asked_steps;
  steps.insert(steps.end(), later.steps.begin(), later.steps.end());
  for (NodeSlice slice : later.slices) {
    slice.begin += end;
    slice.end += end;
    slices.push_back(slice);
  }
  for (const TracedRun& run : later.runs) runs.push_back({run.begin + end, run.end + end});
  threads = std::max(threads, later.threads);
  window_steps = std::max(window_steps, later.window_steps);
  if (choice == ChoiceState::made) choice = later.choice;
  unused_window = std::max(unused_window, later.unused_window);
  bytes_of_all += later.bytes_of_all;
  dropped_steps += later.dropped_steps;
}

}  // namespace spoke
