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

}  // namespace spoke
