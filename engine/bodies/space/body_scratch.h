#pragma once

// Memory of a flexible body within one kernel. What a kernel leaves there is lost, so that it lies
// on the stack, in the same cache lines for all bodies that a thread takes one after another: long
// chains would else stream it through the cache. A body of so many elements that they would not fit
// there has memory of its own.

#include <array>

#include "engine/bodies/space/body_data.h"

namespace spoke::space {

/// Doubles that lie on the stack.
inline constexpr std::size_t kStackScratch = 4096;

/// What there is room for.
struct BodyScratch {
  double* slots;    ///< by node four slots, each with its rate, and then by element one
  double* momenta;  ///< mu = m rho and mu', laid out as the slots
  double* force;    ///< forces by node
  std::array<double*, 4> nodal;  ///< flex vectors by node
  double* lanes;  ///< kLaneRows rows of lane_stride() values, for bodies with directions
};

/// Makes room for a kernel.
class ScratchRoom {
 public:
  ScratchRoom(const FlexibleBody& body, const BodyWork& work) noexcept;
  ScratchRoom(const ScratchRoom&) = delete;
  ScratchRoom& operator=(const ScratchRoom&) = delete;

  const BodyScratch& operator*() const { return scratch_; }
  const BodyScratch* operator->() const { return &scratch_; }

 private:
  alignas(64) double stack_[kStackScratch];
  BodyScratch scratch_;
};

}  // namespace spoke::space
