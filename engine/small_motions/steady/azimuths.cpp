// Turns the hub of a model, and compares its matrices.

#include "engine/small_motions/steady/azimuths.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/small_motions/steady/at_azimuth.h"
#include "engine/small_motions/steady/linear_support.h"
#include "models/error.h"

namespace spoke::steady {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the sizes of terms on the rows of K, as entries and inertia give them.
VectorXd sizes_of(const SizedMatrices& m, double speed) {
  const VectorXd terms = m.K_terms.size() > 0 ? VectorXd(m.K_terms.diagonal().cwiseAbs())
                                              : VectorXd(m.K.diagonal().cwiseAbs());
  return terms + std::max(1.0, speed * speed) * m.M.diagonal();
}

}  // namespace

bool depends_on_azimuth(const SteadyModel& model) {
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    if (!model.standing_springs(i).empty()) return true;
  return false;
}

LinearModel linearize_at(double azimuth, const Equilibrium& equilibrium, SteadyModel& model) {
  const AtAzimuth turned(azimuth, model);
  return linearize_machine(equilibrium, model);
}

bool are_same(const SizedMatrices& a, const SizedMatrices& b, double speed) {
  constexpr double kSame = 1e-6;
  if (a.M.rows() == 0) return true;
  const VectorXd mass = a.M.diagonal().cwiseSqrt(), stiff = sizes_of(a, speed).cwiseSqrt();
  const VectorXd damp = mass.cwiseProduct(stiff).cwiseSqrt();
  const auto differs = [](const MatrixXd& one, const MatrixXd& other, const VectorXd& size) {
    const VectorXd scale = size.cwiseInverse();
    return !((scale.asDiagonal() * (one - other) * scale.asDiagonal()).cwiseAbs().maxCoeff() <=
             kSame);
  };
  return !differs(a.M, b.M, mass) && !differs(a.C, b.C, damp) && !differs(a.K, b.K, stiff);
}

SizedMatrices with_sizes(const LinearSubsystem& subsystem) {
  return {subsystem.M, subsystem.C, subsystem.K, subsystem.K_terms};
}

void require_constant(const LinearModel& linear, const Equilibrium& equilibrium,
                      SteadyModel& model) {
  if (!depends_on_azimuth(model)) return;
  const LinearModel there = linearize_at(kElsewhere, equilibrium, model);
  for (std::size_t i = 0; i < model.subsystems(); ++i)
    if (linear.alike[i] == i && !model.standing_springs(i).empty() &&
        !are_same(with_sizes(linear.subsystem(i)), with_sizes(there.subsystem(i)), model.speed()))
      throw InputError(
          "the frame \"turning\" expects springs alike in all directions across the hub's axis, as "
          "those of " +
          model.name_of(i) + " / loop \"" + model.standing_springs(i) +
          "\", against which the hub turns, are not: of modes the frames \"fixed\" and \"floquet\" "
          "take them");
}

}  // namespace spoke::steady
