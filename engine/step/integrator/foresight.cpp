// Rounds of trials, and what is kept of them.

#include "engine/step/integrator/foresight.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace spoke {
namespace {

constexpr double kRound = IterationMemory::kRound, kRounds = 8.0, kMostOrder = 3.0;

/// Whether the next step is the last of so many.
bool is_last_of(double steps, const IterationMemory& memory) {
  return std::fmod(memory.turn, steps) == steps - 1.0;
}

bool tries_order(const IterationMemory& memory) { return is_last_of(memory.order_every, memory); }

double other_order(double order) { return order == kMostOrder ? 2.0 : kMostOrder; }

}  // namespace

int choose_order(int highest, const IterationMemory& memory) noexcept {
  assert(highest >= 1 && highest <= static_cast<int>(kMostOrder));
  const double order = tries_order(memory) ? other_order(memory.order) : memory.order;
  return std::min(highest,
                  static_cast<int>(std::clamp(std::min(order, memory.known), 1.0, kMostOrder)));
}

void learn_order(double first_change, StepProgress& progress) noexcept {
  constexpr double kClearlyLess = 0.8;
  IterationMemory& memory = progress.remembered;
  if (!tries_order(memory)) {
    memory.first_change = first_change;
  } else if (first_change < kClearlyLess * memory.first_change) {
    memory.order = progress.control.order;
    memory.first_change = first_change;
    memory.order_every = kRound;
  } else {
    memory.order_every = std::min(2.0 * memory.order_every, kRounds * kRound);
  }
}

double foretell_contraction(const StepProgress& progress) noexcept {
  constexpr double kMargin = 30.0;
  if (progress.contraction > 0.0) return std::min(progress.contraction, 1.0);
  const IterationMemory& memory = progress.remembered;
  if (progress.passes > 1 || memory.contraction == 0.0 || is_last_of(kRound, memory)) return 1.0;
  return std::min(kMargin * memory.contraction, 1.0);
}

void remember_step(bool is_plain, StepProgress& progress) noexcept {
  // A contraction of less saves nothing more; 0 means that none is known.
  constexpr double kLeast = 1e-9, kFade = 0.5;
  IterationMemory& memory = progress.remembered;
  if (progress.contraction > 0.0)
    memory.contraction = std::max({progress.contraction, kFade * memory.contraction, kLeast});
  memory.turn = is_plain ? 0.0 : std::fmod(memory.turn + 1.0, kRounds * kRound);
  memory.known = std::min(memory.known + 1.0, kMostOrder);
}

void forget_accelerations(StepProgress& progress) noexcept { progress.remembered.known = 1.0; }

}  // namespace spoke
