#pragma once

// The states of inflow, shed wake and stall at a station, as BladeAir::evaluate() receives and
// returns them.

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "engine/bodies/air/annulus.h"
#include "engine/bodies/air/inflow.h"

namespace spoke::air {

/// Doubles of state per station: of the inflow its intermediate and its induced velocity (axial,
/// tangential), the quasi-steady induced velocity at the beginning and the rate of the first filter
/// there; of the stall the separation point, its steady value at the beginning and the rate there.
inline constexpr std::size_t kStates = 10;
/// Those of attached flow that is unsteady, behind them: of the shed wake two velocities, and the
/// velocity across the chord that they follow and the rate there.
inline constexpr std::size_t kShedStates = 4;

/// The state of a station.
struct StationState {
  InflowState axial, tangential;
  InducedFlow steady;  // the solution of the annulus
  double inflow_rate;
  double separation, steady_separation, stall_rate;
  double shed[2], across, shed_rate;

  /// Takes the states of inflow of another.
  void take_inflow(const StationState& other) {
    axial = other.axial;
    tangential = other.tangential;
    steady = other.steady;
    inflow_rate = other.inflow_rate;
  }
};
static_assert(sizeof(StationState) == (kStates + kShedStates) * sizeof(double));

/// Reads a state from kStates numbers, and of a shed wake kShedStates more.
inline StationState load_state(const double* state, bool has_shed) noexcept {
  StationState s{{state[0], state[1]},
                 {state[2], state[3]},
                 {state[4], state[5]},
                 state[6],
                 state[7],
                 state[8],
                 state[9],
                 {},
                 0.0,
                 0.0};
  if (has_shed) {
    s.shed[0] = state[10];
    s.shed[1] = state[11];
    s.across = state[12];
    s.shed_rate = state[13];
  }
  return s;
}

/// Writes it to as many.
inline void save_state(const StationState& s, bool has_shed, double* state) noexcept {
  const double values[kStates + kShedStates] = {
      s.axial.own,         s.axial.induced, s.tangential.own, s.tangential.induced, s.steady.axial,
      s.steady.tangential, s.inflow_rate,   s.separation,     s.steady_separation,  s.stall_rate,
      s.shed[0],           s.shed[1],       s.across,         s.shed_rate};
  std::copy_n(std::begin(values), has_shed ? kStates + kShedStates : kStates, state);
}

}  // namespace spoke::air
