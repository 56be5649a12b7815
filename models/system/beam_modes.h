#pragma once

// Modes of beams that are held at their roots, and the damping by them (docs/formulation.md,
// section 10).

#include <Eigen/Core>
#include <vector>

#include "models/damping.h"
#include "models/plane/flexible_body.h"
#include "models/rotor.h"
#include "models/space/beam.h"
#include "models/space/flexible_body.h"

namespace spoke {

/// The damping of a beam by its modes, D = b K + sum_k f_k w_k w_k^T, w_k = K phi_k / W_k^2.
struct BeamModes {
  double stiffness_factor = 0.0;    ///< b [s]
  std::vector<double> factors;      ///< f_k = 2 zeta_k W_k - b W_k^2 [1/s]
  std::vector<double> frequencies;  ///< W_k, ascending [rad/s]
  /// Columns phi_k, phi_k^T M phi_k = 1: the coordinates of all nodes of the beam, in the beam's
  /// axes; those of the root are 0.
  Eigen::MatrixXd shapes;
};

/// The share of a body in the modes that damp its beam.
struct ModalShare {
  int first = 0;            ///< number of the beam's first mode among those of the subsystem
  Eigen::MatrixXd weights;  ///< w by coordinate of the body and mode
  Eigen::MatrixXd shapes;   ///< K^-1 w, K of the body: the deformation that has the forces w

  bool is_empty() const { return weights.cols() == 0; }
};

/// Find the modes that damp a beam whose nodes, from root to tip, are at these stations; in the
/// plane a blade. Precondition: there are ratios, no more than the beam has coordinates.
BeamModes find_damped_modes(const space::Beam& beam, const std::vector<double>& nodes,
                            const ModeDamping& damping);
BeamModes find_damped_modes(const Blade& blade, const ModeDamping& damping);

/// Returns the damping of a blade's strains by direction and, in proportion to stiffness, by modes.
plane::StrainDamping find_strain_damping(const Blade& blade, const Damping& damping);

/// Returns a body's share, its first mode 0; `node`: number of its first node on the beam.
ModalShare make_modal_share(const BeamModes& modes, const space::FlexibleBody& body, int node);
/// Returns the share of body number j of a blade.
ModalShare make_modal_share(const BeamModes& modes, const Blade& blade,
                            const plane::FlexibleBody& body, int j);

}  // namespace spoke
