#pragma once

// Which strains suit the beams of a tree: linear ones know the tension of the undeformed tree alone
// (docs/formulation.md, sections 11 and 16).

#include <string>

#include "models/tree/tree.h"

namespace spoke::spatial {

/// Returns what of a tree's tension linear strains do not know, as the end of a sentence: "joint
/// \"J\" moves it". Empty if they know all: where the drive turns the hub, and the tree is fixed to
/// it, without joints that move and loops.
std::string find_unknown_tension(const Model& model, const Tree& tree);

/// Returns whether the centres of mass or tension of a beam's sections lie so far beside its axis
/// that linear strains take its torsion in rotation for stiffer than it is.
bool has_axis_beside(const Beam& beam);

/// Sets the strain of beams that leave the choice (BeamStrain::automatic).
void choose_strains(const Model& model, Tree& tree);

}  // namespace spoke::spatial
