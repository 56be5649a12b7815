#pragma once

// What state-space matrices of all frames are made of: sparse matrices in the making, and names.

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "engine/small_motions/steady/linear_model.h"
#include "engine/small_motions/steady/load_effects.h"

namespace spoke::steady {

/// Largest number of coordinates that move together: their matrices are full, 800 MB.
constexpr Eigen::Index kMostCoupled = 5000;

/// A sparse matrix in the making.
class MatrixEntries {
 public:
  /// Adds the entries of a block that are not zero.
  void add(Eigen::Index row, Eigen::Index column, const Eigen::MatrixXd& block);
  /// Adds a block whose rows and columns are at these numbers, counted from `row` and `column`.
  void add(Eigen::Index row, const std::vector<Eigen::Index>& rows, Eigen::Index column,
           const std::vector<Eigen::Index>& columns, const Eigen::MatrixXd& block);
  Eigen::SparseMatrix<double> matrix(Eigen::Index rows, Eigen::Index columns) const;

 private:
  std::vector<Eigen::Triplet<double, Eigen::Index>> list_;
};

/// Names component `c` of a hub's motion, or of its force.
LinearSignal name_hub_motion(std::size_t hub, int c, const SteadyModel& model);
LinearSignal name_hub_effort(std::size_t hub, int c, const SteadyModel& model);
/// Names the torque of a drive between a hub and what carries it.
LinearSignal name_drive_torque(std::size_t hub, const SteadyModel& model);
/// Names the coordinates of the hub that are free, or those of a support.
std::vector<LinearSignal> name_hub_states(const LinearModel& linear, const SteadyModel& model);
/// Returns the rate of a signal.
LinearSignal rate_of(const LinearSignal& signal);

/// Takes the rates of coordinates with next to no mass, forces by their numbers, out of the states:
/// they follow the other states at once.
void take_out_rates(std::vector<Eigen::Index> forces, LinearSystem& system);

/// Throws InputError if more than kMostCoupled coordinates move together.
void require_few_coupled(Eigen::Index coordinates);

}  // namespace spoke::steady
