#pragma once

// Trees that are alike, so that what is found of one of them holds for all.

#include <vector>

#include "engine/steady/steady_model.h"

namespace spoke::steady {

/// By tree, the first one whose coordinates feel the same forces at equal states, the hub in its
/// steady rotation.
std::vector<std::size_t> find_alike(SteadyModel& model);

/// Of trees at equilibria `q` that are `alike` so far, those that answer alike to the hub's motion,
/// too, once they are turned about the hub's axis to the same azimuth.
std::vector<std::size_t> find_alike_about_hub(std::vector<std::size_t> alike,
                                              const std::vector<Eigen::VectorXd>& q,
                                              SteadyModel& model);

/// Turns a twist by an angle about the hub's axis, components as in the model.
Eigen::MatrixXd turn_hub(double angle, const SteadyModel& model);

}  // namespace spoke::steady
