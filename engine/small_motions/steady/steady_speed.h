#pragma once

// The speeds at which the rotors of a scenario's model turn steadily.

#include <optional>
#include <string>
#include <vector>

#include "engine/equilibrium.h"
#include "engine/small_motions/steady/steady_model.h"
#include "models/scenario.h"

namespace spoke::steady {

/// Returns the speed that was asked for, else the one that the drive leads to and holds, else, for
/// a hub without a drive, the one at the start [rad/s], of a rotor by its number. Throws InputError
/// if it is not finite, or if there is none: a torque has no steady speed by itself.
double find_steady_speed(const Scenario& scenario, int rotor, std::optional<double> asked);

/// Returns the speeds of all rotors in their order, see find_steady_speed(). Throws InputError also
/// if a speed is for a rotor that there is not, or the first one has two.
std::vector<double> find_steady_speeds(const Scenario& scenario, const SteadyState& asked);

/// Returns the speeds of all rotors where the first turns at `first`, and the others by the ratios
/// of the speeds that their drives lead to. Throws InputError if the first one's lets it stand
/// while there are others.
std::vector<double> scale_steady_speeds(const Scenario& scenario, double first);
/// Returns the state in which they have these speeds.
SteadyState scale_steady_state(const Scenario& scenario, double first);

/// Returns the options of a steady model in which the rotors have these speeds.
SteadyOptions at_speeds(const std::vector<double>& speeds, const SteadyOptions& others = {});

}  // namespace spoke::steady
