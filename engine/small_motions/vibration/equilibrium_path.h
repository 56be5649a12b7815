#pragma once

// Equilibria followed over a parameter, each from the one before.

#include <functional>
#include <memory>

#include "engine/small_motions/steady/find_equilibrium.h"

namespace spoke::vibration {

/// An equilibrium on a path, with the model that stands there.
struct PathState {
  double value = 0.0;  ///< of the parameter
  std::unique_ptr<steady::SteadyModel> model;
  steady::Equilibrium equilibrium;
};
using PathPlace = std::shared_ptr<PathState>;

class EquilibriumPath {
 public:
  using MakeModel = std::function<std::unique_ptr<steady::SteadyModel>(double)>;

  /// `make`: makes the model at a value of the parameter, of the same bodies each time.
  /// `resolution`: the step below which a path is taken to end, or to jump [of the parameter].
  EquilibriumPath(MakeModel make, double resolution)
      : make_(std::move(make)), resolution_(resolution) {}

  double resolution() const { return resolution_; }

  /// Finds the equilibrium at a value by itself. Throws DivergenceError.
  PathPlace begin(double value) const;

  struct Reached {
    PathPlace place;       ///< the last one, at the value asked for unless the path ends
    bool is_lost = false;  ///< whether it ends before: Newton's method finds none that is near
  };
  /// Goes on from a place to a value, in steps within which the equilibrium changes smoothly: where
  /// it jumps the path ends. Throws InputError where forces on a free hub are not in balance.
  Reached go(PathPlace from, double value) const;

 private:
  PathPlace follow(const PathState& from, double value) const;
  bool is_smooth(const PathState& from, const PathState& to) const;

  MakeModel make_;
  double resolution_;
};

}  // namespace spoke::vibration
