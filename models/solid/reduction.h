#pragma once

// Craig-Bampton reduction: modes of vibration and of interfaces, all made orthonormal.

#include <Eigen/Core>

#include "models/solid/constraints.h"
#include "models/solid/statics.h"
#include "models/solid/vibration.h"

namespace spoke::solid {

/// Shapes in the coordinates q with T^T M T = 1, T^T K T = diag(squares), ascending.
struct ReducedBasis {
  Eigen::MatrixXd T;          ///< nf x r
  Eigen::VectorXd squares;    ///< W^2 [1/s^2]
  Eigen::VectorXd vibration;  ///< W^2 of the modes of vibration before they were combined
};

/// Of a body that its frame holds: modes with the boundary at rest, the static modes of the
/// boundary, and the static shapes under the wrenches on `attached` (columns of nf).
ReducedBasis reduce(const Sparse& M, const Sparse& K, const ClampedStatics& statics,
                    const Eigen::MatrixXd& attached, const ModeChoice& choice,
                    const PartDone& done);

/// Of a body that flies by itself: modes without the rigid ones, and the static shapes under the
/// wrenches on `attached` with the relief of its acceleration.
ReducedBasis reduce(const Sparse& M, const Sparse& K, const FreeStatics& statics,
                    const Eigen::MatrixXd& attached, const ModeChoice& choice,
                    const PartDone& done);

}  // namespace spoke::solid
