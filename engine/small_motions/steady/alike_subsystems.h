#pragma once

// Finds subsystems that are alike, so that results for one of them hold for all.

#include <vector>

#include "engine/small_motions/steady/steady_model.h"

namespace spoke::steady {

/// Whether coordinates are equal up to round-off of closing loops at different azimuths.
bool are_same(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// Returns for each subsystem the first one whose coordinates feel the same forces at equal states
/// while the hub is in its steady rotation.
std::vector<std::size_t> find_alike(SteadyModel& model);

/// Parts subsystems that are `alike` so far, at the equilibria `q`, unless they also answer alike
/// to the hub's motion once they are turned about the hub's axis to the same azimuth.
std::vector<std::size_t> find_alike_about_hub(std::vector<std::size_t> alike,
                                              const std::vector<Eigen::VectorXd>& q,
                                              SteadyModel& model);

/// Returns the matrix that turns a twist by an angle about the hub's axis, components as in the
/// model.
Eigen::MatrixXd turn_hub(double angle, const SteadyModel& model);

}  // namespace spoke::steady
