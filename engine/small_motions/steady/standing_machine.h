#pragma once

// Machines at rest whose rotors are more than hubs on a support: they are taken as a whole. While a
// rotor turns, rotors and support are taken apart (supported_model.h).

#include <memory>
#include <string>

#include "engine/small_motions/steady/make_supported.h"
#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Returns what ties hubs of a model on a support to one another, or to the support, besides their
/// axles: a loop or a coupling between what they carry, an anchor beside an axle, a coupling on an
/// axle, or a rotor on what another rotor carries. Its key in a scenario, and what it is; empty:
/// there is none.
std::string find_tie_of_hubs(const spatial::Model& model);

/// Makes the model of all rotors and their support at rest, in which all are one subsystem. Throws
/// InputError if the drive of a rotor is a torque: nothing says which one it then gives.
std::unique_ptr<SteadyModel> make_standing(const Scenario& scenario, const SteadyWinds& winds,
                                           const SteadyOptions& options);

}  // namespace spoke::steady
