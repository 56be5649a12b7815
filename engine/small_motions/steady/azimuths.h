#pragma once

// A rotor at other azimuths than zero. What springs between it and the mount do depends on the
// azimuth, seen from the frame that turns with the hub.

#include "engine/small_motions/steady/linear_model.h"

namespace spoke::steady {

/// Whether the forces on a model depend on the azimuth of its hub.
bool depends_on_azimuth(const SteadyModel& model);

/// Linearises a model, or a rotor on its support, where its hub has turned to an azimuth [rad].
LinearModel linearize_at(double azimuth, const Equilibrium& equilibrium, SteadyModel& model);

/// Matrices that multiply x'', x' and x, with the sizes of the terms of which K consists.
struct SizedMatrices {
  Eigen::MatrixXd M, C, K, K_terms;
};
/// Returns whether two sets of matrices are the same but for round-off, each entry by the sizes of
/// the terms on its row and column.
bool are_same(const SizedMatrices& a, const SizedMatrices& b, double speed);
SizedMatrices with_sizes(const LinearSubsystem& subsystem);

/// Throws InputError, which names a loop, unless a model that is linearised at azimuth zero has the
/// same matrices at every other.
void require_constant(const LinearModel& linear, const Equilibrium& equilibrium,
                      SteadyModel& model);

}  // namespace spoke::steady
