#pragma once

// Which eigenvalues of a solver are roots of a model, and how far they are known.

#include <complex>
#include <functional>
#include <vector>

#include "engine/vibration/pencil.h"
#include "engine/vibration/root.h"

namespace spoke::vibration {

/// What a solver has found. Vectors are in scaled coordinates of the pencil, of any length.
struct Spectrum {
  Eigen::VectorXcd values;  ///< s [1/s]; of conjugate ones both, or one
  std::function<Eigen::VectorXcd(Eigen::Index)> vector;  ///< x of one
  std::function<double(std::complex<double>)> lost;      ///< of s^2, by the solver at s [1/s^2]
};

/// x^H M x = 1.
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
/// The `count` roots of least magnitude of a spectrum, or as many as it has; of conjugate ones one.
/// First a root zero for each column of `rigid` (find_rigid_motions()), in place of the spectrum's
/// own: two for each motion that goes on at a constant rate.
///
/// Of others, round-off N of x^H P(s) x moves the root by min(N/|x^H P'(s) x|, sqrt(N)), the latter
/// where two roots meet. A real or imaginary part that is less is zero: undamped vibrations neither
/// grow nor decay by round-off.
ChosenRoots choose_roots(const Pencil& pencil, const Spectrum& spectrum,
                         const Eigen::MatrixXd& rigid, Eigen::Index count);

}  // namespace spoke::vibration
