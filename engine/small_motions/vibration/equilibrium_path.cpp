// Goes along a path with steps that adapt.

#include "engine/small_motions/vibration/equilibrium_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/small_motions/steady/supported_model.h"

namespace spoke::vibration {
namespace {

/// Change of a coordinate, by its scale, up to which a step is not looked into: of round-off's
/// order. Branches may be near: an unbalanced shaft jumps by a hundredth of its length.
constexpr double kSmallChange = 1e-6;
/// Share of a change that may come in one half of a step. Near a limit point, where an equilibrium
/// goes with the square root of the distance, it is 0.71; where it jumps it tends to 1.
constexpr double kLargestShare = 0.8;

/// Returns the largest change of a coordinate by its scale.
double calc_change(const PathState& from, const PathState& to) {
  double change = 0.0;
  for (std::size_t i = 0; i < to.model->subsystems(); ++i) {
    const Eigen::VectorXd moved =
        to.model->absolute(i, to.equilibrium.q[i]) - from.model->absolute(i, from.equilibrium.q[i]);
    const auto& coordinates = to.model->coordinates(i);
    for (Eigen::Index k = 0; k < moved.size(); ++k)
      change =
          std::max(change, std::abs(moved[k]) / coordinates[static_cast<std::size_t>(k)].scale);
  }
  return change;
}

}  // namespace

PathPlace EquilibriumPath::begin(double value) const {
  std::unique_ptr<steady::SteadyModel> model = make_(value);
  steady::Equilibrium found = steady::find_machine_equilibrium(*model);
  steady::require_steady_machine(*model, found);
  return std::make_shared<PathState>(PathState{value, std::move(model), std::move(found)});
}

PathPlace EquilibriumPath::follow(const PathState& from, double value) const {
  std::unique_ptr<steady::SteadyModel> model = make_(value);
  std::optional<steady::Equilibrium> found =
      steady::continue_machine_equilibrium(from.equilibrium, *from.model, *model);
  if (!found) return nullptr;
  steady::require_steady_machine(*model, *found);
  return std::make_shared<PathState>(PathState{value, std::move(model), std::move(*found)});
}

bool EquilibriumPath::is_smooth(const PathState& from, const PathState& to) const {
  const double change = calc_change(from, to);
  if (change <= kSmallChange) return true;
  const PathPlace middle = follow(from, 0.5 * (from.value + to.value));
  if (!middle) return false;
  return std::max(calc_change(from, *middle), calc_change(*middle, to)) <= kLargestShare * change;
}

EquilibriumPath::Reached EquilibriumPath::go(PathPlace from, double value) const {
  double step = value - from->value;
  while (from->value != value) {
    const double left = value - from->value;
    const double target = std::abs(step) >= std::abs(left) ? value : from->value + step;
    PathPlace next = follow(*from, target);
    if (next && is_smooth(*from, *next)) {
      from = std::move(next);
      step *= 2.0;
    } else if (std::abs(target - from->value) <= resolution_) {
      return {std::move(from), true};
    } else {
      step = 0.5 * (target - from->value);
    }
  }
  return {std::move(from), false};
}

}  // namespace spoke::vibration
