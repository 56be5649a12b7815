#pragma once

// All that `spoke reproduce` computes and measures.

#include "bench/compare/comparison.h"
#include "bench/reproduce/figures.h"
#include "bench/reproduce/timings.h"

namespace spoke::reproduce {

/// The whole simulation by generalized_alpha: its step and its accuracy.
struct ImplicitRun {
  double step = 0.05;  ///< [s]
  double lag = 0.0;    ///< largest lag of the tip that it finds [m]
  double error = 0.0;  ///< error of that lag, relative to the converged lag of the same model
};

/// All computed and measured values.
struct Reproduction {
  Scenario scenario;  ///< scenario whose steps are timed, with rk4
  bool is_quick = false;
  Machine machine = {};
  compare::Loads loads = {};
  int rounds = 0;  ///< number of planned rounds
  std::vector<DrivePoint> drive = {};
  Deflection paper = {};      ///< without stiffening, 4 bodies of 4 elements
  Deflection stiffened = {};  ///< with stiffening, 4 bodies of 4 elements
  Deflection finest = {};     ///< Spoke's finest stiffened model
  ImplicitRun implicit = {};
  double inverse_share = 0.0;  ///< inverse nodes in a serial step, formulation subsystem
  Timings timings = {};
};

/// Whether other programs took the processors, so that small differences mean nothing.
inline bool is_disturbed(const Reproduction& all) {
  return is_busy(all.loads.before, all.machine.cores);
}
inline constexpr const char* kDisturbed =
    "The machine was busy with other things: times are disturbed, and what is said of threads "
    "stays "
    "open.";

}  // namespace spoke::reproduce
