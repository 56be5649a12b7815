// Advances the air turn by turn.

#include "engine/small_motions/vibration/periodic_wake.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::vibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Returns the largest difference of two lists by their size, of less than 1 by 1.
double differ(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    most = std::max(most, std::abs(a[k] - b[k]) / std::max(1.0, std::abs(b[k])));
  return most;
}

}  // namespace

bool PeriodicWake::acts() const {
  return std::any_of(states_.begin(), states_.end(),
                     [](const States& own) { return !own.empty(); });
}

void PeriodicWake::hold(std::size_t i, Index l, steady::SteadyModel& model) const {
  if (i < states_.size() && !states_[i].empty())
    model.hold_states_at(i, states_[i][static_cast<std::size_t>(l)]);
}

/// Takes the air once around from `states` at the last azimuth, or from equilibrium. Returns false
/// beyond the limits of the model.
bool PeriodicWake::turn(std::size_t i, const TurnMotion& motion, const PeriodicSystem& mean,
                        const VectorXd& q, States& states, steady::SteadyModel& model) const {
  const Index parts = motion.parts(), at = mean.starts[i], n = q.size();
  const double step = 2.0 * std::numbers::pi / (std::abs(mean.speed) * static_cast<double>(parts));
  for (Index k = 0; k < parts; ++k) {
    const Index l = mean.speed > 0.0 ? k : parts - 1 - k;
    const VectorXd now = q + motion.x.col(l).segment(at, n), rate = motion.v.col(l).segment(at, n);
    place_hub(motion, l, mean.hub, model);
    steady::SubsystemResponse response;
    model.evaluate(i, {now, rate, now, rate}, model.no_offset(), response);
    if (!response.is_valid) return false;
    std::vector<double> own = model.advance_states(i, step);
    if (own.empty()) {
      states.clear();
      return true;
    }
    states.resize(static_cast<std::size_t>(parts));
    states[static_cast<std::size_t>(l)] = std::move(own);
  }
  return true;
}

bool PeriodicWake::follow(const TurnMotion& motion, const PeriodicSystem& mean,
                          const std::vector<VectorXd>& equilibrium, steady::SteadyModel& model) {
  constexpr int kMostTurns = 1000;
  constexpr double kSettled = 1e-12;
  const auto parts = static_cast<std::size_t>(motion.parts());
  const std::size_t last = mean.speed > 0.0 ? parts - 1 : 0;
  states_.resize(model.subsystems());
  for (std::size_t i = 0; i < states_.size(); ++i) {
    States& own = states_[i];
    if (own.size() == parts)
      model.hold_states_at(i, own[last]);
    else
      model.hold_states(i, false);
    std::vector<double> before = own.size() == parts ? own[last] : std::vector<double>{};
    for (int turns = 0;; ++turns) {
      if (turns == kMostTurns || !turn(i, motion, mean, equilibrium[i], own, model)) return false;
      if (own.empty()) break;
      if (!before.empty() && differ(own[last], before) <= kSettled) break;
      before = own[last];
    }
  }
  return true;
}

}  // namespace spoke::vibration
