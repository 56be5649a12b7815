#pragma once

// The largest eigenvalue of a symmetric matrix against the mass matrix of a hub and its trees.

#include "engine/steady/linear_model.h"

namespace spoke::vibration {

/// A matrix of the same form as a LinearModel's: of the hub, of the trees, and between them. Refers
/// to the model and to which of its matrices is meant.
struct ArrowMatrix {
  const steady::LinearModel& model;
  Eigen::MatrixXd steady::LinearModel::*hub;
  Eigen::MatrixXd steady::LinearTree::*tree;
  Eigen::MatrixXd steady::HubCoupling::*tree_hub;
};

/// The largest w of A x = w M x, A symmetric, by a Lanczos iteration; 0 of an empty model. Trees
/// that are alike share the factors of M.
double find_largest_root(const ArrowMatrix& matrix);

}  // namespace spoke::vibration
