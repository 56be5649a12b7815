#pragma once

// The assignment problem: pairs of rows and columns with the largest sum.

#include <Eigen/Core>
#include <vector>

namespace spoke::vibration {

/// Returns for each row of a matrix of gains the column that it is paired with, -1 for none, so
/// that the sum of the gains of all pairs is as large as possible: as many pairs as there are rows
/// or columns, whichever are fewer. Takes n^2 m operations (the Hungarian method in the form of
/// Jonker and Volgenant 1987: shortest augmenting paths under dual prices).
std::vector<Eigen::Index> find_best_assignment(const Eigen::MatrixXd& gains);

}  // namespace spoke::vibration
