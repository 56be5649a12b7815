#pragma once

// Choice of the eigenvalues of a solver that are roots of a model, and how far they are known.

#include <complex>
#include <functional>
#include <vector>

#include "engine/small_motions/vibration/pencil.h"
#include "engine/small_motions/vibration/root.h"

namespace spoke::vibration {

/// Results of a solver. Vectors are in scaled coordinates of the pencil, of any length.
struct Spectrum {
  Eigen::VectorXcd values;  ///< s [1/s]; one or both of a conjugate pair
  std::function<Eigen::VectorXcd(Eigen::Index)> vector;  ///< the vector x of an eigenvalue
  std::function<double(std::complex<double>)> lost;  ///< error of s^2 by the solver at s [1/s^2]
};

/// Returns the vector scaled to unit mass, x^H M x = 1.
Eigen::VectorXcd to_unit_mass(const Pencil& pencil, const Eigen::VectorXcd& x);

/// An eigenvalue that was looked at.
struct Checked {
  Eigen::Index column = 0;
  bool is_double = false;  ///< another root is near
};

struct ChosenRoots {
  std::vector<Root> roots;  ///< vectors of unit mass, in scaled coordinates
  std::vector<Checked> checked;
};
/// Returns the `count` roots of least magnitude of a spectrum, or as many as it has; one of each
/// conjugate pair. They begin with a root of zero for each column of `rigid`
/// (find_rigid_motions()), which replaces two roots of the spectrum: a motion that goes on at a
/// constant rate has two.
///
/// Round-off N of x^H P(s) x moves another root by min(N/|x^H P'(s) x|, sqrt(N)), the latter where
/// two roots meet. A real or imaginary part below this is set to zero: undamped vibrations neither
/// grow nor decay by round-off.
ChosenRoots choose_roots(const Pencil& pencil, const Spectrum& spectrum,
                         const Eigen::MatrixXd& rigid, Eigen::Index count);

}  // namespace spoke::vibration
