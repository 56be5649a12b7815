// Lays out the memory of a kernel.

#include "engine/bodies/space/body_scratch.h"

#include <cassert>
#include <utility>

namespace spoke::space {
namespace {

/// Calls `take(count)` for each stretch of doubles, and returns what it returns.
template <class Take>
BodyScratch lay_out(const FlexibleBody& body, Take&& take) {
  const auto nodes = static_cast<std::size_t>(body.node_count());
  const std::size_t slots = kSlot * (kNodeSlots * nodes + static_cast<std::size_t>(body.elements));
  BodyScratch scratch;
  scratch.slots = take(slots);
  scratch.momenta = take(slots);
  scratch.force = take(kTwist * nodes);
  for (double*& nodal : scratch.nodal) nodal = take(kTwist * nodes);
  scratch.lanes = take(count_lanes(body));
  return scratch;
}

/// Each stretch begins at an even place.
std::size_t rounded_up(std::size_t count) { return count + count % 2; }

}  // namespace

std::size_t count_scratch(const FlexibleBody& body) {
  std::size_t total = 0;
  lay_out(body, [&total](std::size_t count) -> double* {
    total += rounded_up(count);
    return nullptr;
  });
  return total > kStackScratch ? total : 0;
}

ScratchRoom::ScratchRoom(const FlexibleBody& body, const BodyWork& work) noexcept {
  assert(work.scratch || count_scratch(body) == 0);
  double* next = work.scratch ? work.scratch : stack_;
  scratch_ = lay_out(
      body, [&next](std::size_t count) { return std::exchange(next, next + rounded_up(count)); });
}

}  // namespace spoke::space
