#pragma once

// The quadratic eigenproblem (s^2 M + s C + K) x = 0 of a hub and subsystems that meet there. No
// matrix of the whole is ever formed.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/support/dense.h"

namespace spoke::vibration {

/// The eigenproblem in coordinates of the hub, then subsystem by subsystem, each scaled to a mass
/// of one. Refers to the model, which must outlive it.
class Pencil {
 public:
  /// Makes the pencil of these subsystems, and of the hub if the model is coupled.
  Pencil(const steady::LinearModel& model, std::vector<std::size_t> subsystems);
  /// Makes the pencil of all subsystems.
  explicit Pencil(const steady::LinearModel& model);

  Eigen::Index size() const { return scale_.size(); }
  bool has_hub() const { return model_.is_coupled(); }
  const std::vector<std::size_t>& subsystems() const { return subsystems_; }
  /// Returns the first coordinate of a subsystem, by place in subsystems().
  Eigen::Index start(std::size_t place) const { return starts_[place]; }
  /// Returns the factors that take scaled coordinates to those of the model.
  const Eigen::VectorXd& scale() const { return scale_; }
  /// Return the frequencies of the softest and of the stiffest single coordinate [rad/s].
  double softest() const { return softest_; }
  double stiffest() const { return stiffest_; }
  /// Whether every single coordinate is held, by more than round-off.
  bool is_held() const { return is_held_; }
  /// Whether there are no forces of damping or gyroscopic ones, and the stiffness is symmetric, up
  /// to round-off of the differences of forces.
  bool is_symmetric() const;

  /// Returns a bound of the error of x^H (s^2 M + s C + K) x by round-off of M, C and K [1/s^2]:
  /// that of the terms which make up the forces of this shape, and no others. x is in scaled
  /// coordinates.
  double calc_round_off(const Eigen::VectorXcd& x, double magnitude_of_s) const;

  /// Return M x, K x, and C x + s M x, in scaled coordinates.
  Eigen::MatrixXd mass(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd stiffness(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd damping(double s, const Eigen::MatrixXd& x) const;
  /// Return the full matrices, in scaled coordinates.
  Eigen::MatrixXd dense_mass() const;
  Eigen::MatrixXd dense_damping() const;
  Eigen::MatrixXd dense_stiffness() const;

 private:
  friend class PencilFactor;
  Eigen::MatrixXd apply(Eigen::MatrixXd steady::LinearSubsystem::*subsystem,
                        Eigen::MatrixXd steady::HubCoupling::*subsystem_hub,
                        Eigen::MatrixXd steady::HubCoupling::*hub_subsystem,
                        Eigen::MatrixXd steady::LinearModel::*hub, const Eigen::MatrixXd& x) const;
  double sum_terms(Eigen::MatrixXd steady::LinearSubsystem::*subsystem,
                   Eigen::MatrixXd steady::HubCoupling::*subsystem_hub,
                   Eigen::MatrixXd steady::HubCoupling::*hub_subsystem,
                   Eigen::MatrixXd steady::LinearModel::*hub, const Eigen::VectorXd& x) const;

  const steady::LinearModel& model_;
  std::vector<std::size_t> subsystems_;
  std::vector<Eigen::Index> starts_;
  Eigen::VectorXd scale_;
  double softest_ = 1.0;
  double stiffest_ = 1.0;
  bool is_held_ = true;
  double largest_round_off_ = 0.0;  ///< of an entry of K that is a difference of forces [1/s^2]
};

/// A factorised matrix, scaled to a diagonal of ones beforehand, so that coordinates of unlike
/// stiffness cost no digits. Zeros on the diagonal stay.
class BalancedFactor {
 public:
  explicit BalancedFactor(const Eigen::MatrixXd& matrix);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  Eigen::Index rows() const { return balance_.size(); }
  /// Returns an estimate of the reciprocal condition of the scaled matrix; 0 if it is singular.
  double rcond() const;

 private:
  Eigen::VectorXd balance_;
  LuFactors factor_;
};

/// Weights of M, C and K in a sum of them.
struct PencilWeights {
  double mass = 0.0, damping = 0.0, stiffness = 0.0;
};

/// A weighted sum of M, C and K, factorised: first the subsystems, those that are alike once, then
/// the Schur complement of the hub.
class PencilFactor {
 public:
  /// Factorises s^2 M + s C + K.
  PencilFactor(const Pencil& pencil, double s) : PencilFactor(pencil, {s * s, s, 1.0}) {}
  PencilFactor(const Pencil& pencil, const PencilWeights& weights);

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  /// Returns a bound of the loss of digits in solving: the smallest reciprocal condition of the
  /// parts.
  double rcond() const { return rcond_; }

 private:
  const Pencil& pencil_;
  double rcond_ = 1.0;
  const BalancedFactor& subsystem(std::size_t place) const { return factors_[factor_of_[place]]; }

  std::vector<BalancedFactor> factors_;
  std::vector<std::size_t> factor_of_;   ///< by place in the pencil's subsystems()
  std::vector<Eigen::MatrixXd> by_hub_;  ///< response of each subsystem to a motion of the hub
  std::vector<Eigen::MatrixXd> on_hub_;
  std::optional<BalancedFactor> hub_;
};

}  // namespace spoke::vibration
