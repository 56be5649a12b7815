#pragma once

#include <Eigen/Core>

namespace spoke::test {

/// Returns the largest difference, relative to the largest value of `b`.
inline double relative_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

}  // namespace spoke::test
