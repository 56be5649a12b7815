#pragma once

// The terms of a solid in nodal coordinates, from its tiles (nodal_terms.h), as those of a reduced
// one (solid_terms.h).

#include "engine/bodies/kinds/solid/solid_model.h"
#include "models/rotor.h"

namespace spoke::space {

/// Calculates the terms of tile p, into its rows and sums.
void calc_nodal_tile(const SolidModel& model, int p, const BodyState& state,
                     const BodyMotion& motion, const Damping& damping,
                     const BodyWork& work) noexcept;
/// Returns the terms, when all tiles are done.
BodyTerms sum_nodal_terms(const SolidModel& model, const BodyMotion& motion,
                          const BodyWork& work) noexcept;

/// Sums of a solid, and its stiffening in B.
struct ObservedSolid {
  NodalSums sums;
  SolidStiffening stiffening;
};
/// Calculates them for what sensors show, in memory of their own; gravity: in B.
ObservedSolid observe_nodal(const SolidModel& model, const BodyState& state,
                            const Position& gravity, const BodyWork& work) noexcept;

/// Returns q^T K q / 2 [J].
double calc_nodal_strain_energy(const NodalSolid& solid, const double* q) noexcept;

}  // namespace spoke::space
