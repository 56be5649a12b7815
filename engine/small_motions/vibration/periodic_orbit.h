#pragma once

// The periodic motion of a rotor under gravity and loads that turn against it.

#include <optional>

#include "engine/small_motions/vibration/mode_parts.h"
#include "engine/small_motions/vibration/periodic_system.h"
#include "engine/small_motions/vibration/periodic_wake.h"

namespace spoke::vibration {

/// A motion over a turn, as the offset of all coordinates of a PeriodicSystem from the equilibrium.
/// The mean angle of the hub is zero.
struct PeriodicOrbit {
  /// By multiple of the azimuth, from 0: x(psi) = c_0 + 2 Re sum c_k exp(i k psi).
  Eigen::MatrixXcd harmonics;
  PeriodicWake wake;  ///< at parts() azimuths

  /// Number of equal parts of a turn at which it is known.
  Eigen::Index parts() const { return 2 * harmonics.cols() - 1; }
};

/// Whether the motion of this model can be found: if the hub has no coordinates but its angle, and
/// if springs hold all closures of loops, and no joint relaxes.
bool can_have_orbit(const Linearised& all);

/// Whether forces on the model in its equilibrium change with the azimuth. `whole`: as below.
bool is_turned_against(const Linearised& all, steady::SteadyModel& whole);

/// Finds the motion. `mean`: the linear model without what turns against it; `whole`: the same
/// model made with SteadyOptions::is_whole, which is left in some state of the motion. None:
/// nothing turns against the model. Forces are those of the model, without a bound of amplitude;
/// correction is by the harmonics of `mean` and Anderson's acceleration (1965, J. ACM 12:547).
/// Throws DivergenceError if no motion is found, as in a resonance with the speed. Precondition:
/// can_have_orbit().
std::optional<PeriodicOrbit> find_periodic_orbit(const Linearised& all, const PeriodicSystem& mean,
                                                 steady::SteadyModel& whole);

/// Linearises the model along the motion, for the coordinates of `mean`.
PeriodicSystem linearise_along(const PeriodicOrbit& orbit, const Linearised& all,
                               const PeriodicSystem& mean, steady::SteadyModel& whole);

}  // namespace spoke::vibration
