#pragma once

// Modes of vibration of large sparse matrices, by Spectra with the inverse of K.

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "models/solid/assembly.h"

namespace spoke::solid {

/// Modes in ascending order: K phi = W^2 M phi, phi^T M phi = 1.
struct VibrationModes {
  Eigen::VectorXd squares;  ///< W^2 [1/s^2]
  Eigen::MatrixXd shapes;   ///< a column each
};

/// Which modes are wanted: so many, or all whose W^2 is at most `up_to`.
struct ModeChoice {
  int count = 0;
  std::optional<double> up_to{};  ///< [1/s^2]
  /// Told how many modes are looked for up to `up_to`, before they are; may be empty. What it
  /// throws ends the search.
  std::function<void(int)> require{};
};

/// K^-1 of columns; of a body that nothing holds, without rigid motions.
using Inverse = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;
/// Says how much is done, 0 to 1.
using PartDone = std::function<void(double)>;

/// Finds the lowest modes of K, M but the rigid motions (orthonormal with M, or none). Equal
/// frequencies are all found. Precondition: count <= rows - rigid.
VibrationModes find_modes(const Sparse& M, const Inverse& inverse, const Eigen::MatrixXd& rigid,
                          const ModeChoice& choice, const PartDone& done = {});

/// Turns columns so that the largest component of each is positive; of components that
/// differ by round-off only the first counts.
void fix_signs(Eigen::MatrixXd& columns);

/// Subtracts from X its parts along the columns of Q, which are orthonormal with M: X - Q (MQ)^T X.
void remove_parts(const Eigen::Ref<const Eigen::MatrixXd>& Q,
                  const Eigen::Ref<const Eigen::MatrixXd>& MQ, Eigen::MatrixXd& X);

}  // namespace spoke::solid
