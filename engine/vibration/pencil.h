#pragma once

// The quadratic eigenproblem (s^2 M + s C + K) x = 0 of a hub and trees that meet there, without
// ever forming a matrix of all.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "engine/steady/linear_model.h"
#include "engine/support/dense.h"

namespace spoke::vibration {

/// Coordinates of the hub first, then tree by tree, each scaled to a mass of one. Refers to the
/// model, which must outlive it.
class Pencil {
 public:
  /// Of these trees, and of the hub if the model is coupled.
  Pencil(const steady::LinearModel& model, std::vector<std::size_t> trees);
  /// Of all trees.
  explicit Pencil(const steady::LinearModel& model);

  Eigen::Index size() const { return scale_.size(); }
  bool has_hub() const { return model_.is_coupled(); }
  const std::vector<std::size_t>& trees() const { return trees_; }
  /// Where a tree's coordinates begin; by place in trees().
  Eigen::Index start(std::size_t place) const { return starts_[place]; }
  /// Factors that take scaled coordinates to those of the model.
  const Eigen::VectorXd& scale() const { return scale_; }
  /// Frequencies of the softest and of the stiffest coordinate by itself [rad/s].
  double softest() const { return softest_; }
  double stiffest() const { return stiffest_; }
  /// Whether each coordinate by itself is held, by more than round-off.
  bool is_held() const { return is_held_; }
  /// The largest round-off of an entry of K that is a difference of forces [1/s^2].
  double largest_round_off() const { return largest_round_off_; }

  /// Up to what round-off of M, C and K leaves x^H (s^2 M + s C + K) x [1/s^2]: that of the terms
  /// which make up the forces of this very shape, and no others. x in scaled coordinates.
  double calc_round_off(const Eigen::VectorXcd& x, double magnitude_of_s) const;

  /// M x, K x, and C x + s M x, in scaled coordinates.
  Eigen::MatrixXd mass(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd stiffness(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd damping(double s, const Eigen::MatrixXd& x) const;
  /// The whole matrices, in scaled coordinates.
  Eigen::MatrixXd dense_mass() const;
  Eigen::MatrixXd dense_damping() const;
  Eigen::MatrixXd dense_stiffness() const;

 private:
  friend class PencilFactor;
  Eigen::MatrixXd apply(Eigen::MatrixXd steady::LinearTree::*tree,
                        Eigen::MatrixXd steady::HubCoupling::*tree_hub,
                        Eigen::MatrixXd steady::HubCoupling::*hub_tree,
                        Eigen::MatrixXd steady::LinearModel::*hub, const Eigen::MatrixXd& x) const;
  double sum_terms(Eigen::MatrixXd steady::LinearTree::*tree,
                   Eigen::MatrixXd steady::HubCoupling::*tree_hub,
                   Eigen::MatrixXd steady::HubCoupling::*hub_tree,
                   Eigen::MatrixXd steady::LinearModel::*hub, const Eigen::VectorXd& x) const;

  const steady::LinearModel& model_;
  std::vector<std::size_t> trees_;
  std::vector<Eigen::Index> starts_;
  Eigen::VectorXd scale_;
  double softest_ = 1.0;
  double stiffest_ = 1.0;
  bool is_held_ = true;
  double largest_round_off_ = 0.0;
};

/// A matrix factorised after it was scaled to a diagonal of ones, so that coordinates of unlike
/// stiffness cost no digits. Zeros stay.
class BalancedFactor {
 public:
  explicit BalancedFactor(const Eigen::MatrixXd& matrix);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  Eigen::Index rows() const { return balance_.size(); }
  /// About the reciprocal condition of what was factorised; 0 if it is singular.
  double rcond() const;

 private:
  Eigen::VectorXd balance_;
  LuFactors factor_;
};

/// What M, C and K count in a sum of them.
struct PencilWeights {
  double mass = 0.0, damping = 0.0, stiffness = 0.0;
};

/// A weighted sum of M, C and K, factorised: the trees, those that are alike once, then what they
/// leave of the hub.
class PencilFactor {
 public:
  /// s^2 M + s C + K.
  PencilFactor(const Pencil& pencil, double s) : PencilFactor(pencil, {s * s, s, 1.0}) {}
  PencilFactor(const Pencil& pencil, const PencilWeights& weights);

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;
  /// A bound of what is lost in solving: the least reciprocal condition of its parts.
  double rcond() const { return rcond_; }

 private:
  const Pencil& pencil_;
  double rcond_ = 1.0;
  const BalancedFactor& tree(std::size_t place) const { return factors_[factor_of_[place]]; }

  std::vector<BalancedFactor> factors_;
  std::vector<std::size_t> factor_of_;   ///< by place in the pencil's trees()
  std::vector<Eigen::MatrixXd> by_hub_;  ///< what a motion of the hub does to each tree
  std::vector<Eigen::MatrixXd> on_hub_;
  std::optional<BalancedFactor> hub_;
};

}  // namespace spoke::vibration
