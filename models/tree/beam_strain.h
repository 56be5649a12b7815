#pragma once

// Which strains suit a beam: linear ones know the tension of the undeformed tree alone
// (docs/formulation.md, sections 11 and 16).

#include <string>

#include "models/spatial_model.h"

namespace spoke::spatial {

/// Returns what of the tension in a blade or a subsystem of the model linear strains do not know,
/// as the end of a sentence: "joint J moves it". Empty if they know all: where the drive turns the
/// hub, and nothing on it moves by joints or is held by loops.
std::string find_unknown_tension(const Model& model, const Blade& blade);
std::string find_unknown_tension(const Model& model, const Subsystem& subsystem);

/// Returns what moves or pulls at a body of a subsystem besides the hub: a joint between it and the
/// hub, or a loop on the subsystem; as find_unknown_tension() does.
std::string find_joint_or_loop(const Model& model, const Subsystem& subsystem,
                               const std::string& body);

/// Returns whether the centres of mass or tension of a beam's sections lie so far beside its axis
/// that linear strains make its torsional frequencies in rotation wrong.
bool has_axis_beside(const Beam& beam);

/// Returns the strain of a beam: its own, or where that leaves the choice (BeamStrain::automatic)
/// the one that suits it. `unknown`: what find_unknown_tension() says.
BeamStrain choose_strain(const Beam& beam, const std::string& unknown);

}  // namespace spoke::spatial
