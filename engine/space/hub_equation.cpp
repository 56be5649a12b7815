// Sums and solves the hub's equation of motion in space.

#include "engine/space/hub_equation.h"

#include <algorithm>
#include <cmath>

#include "engine/space/rigid_body_terms.h"

namespace spoke::space {
namespace {

/// Calls `visit(c)` for the components that are prescribed, or for those that are not.
template <class Visit>
void for_each(const Prescribed& prescribed, bool which, Visit&& visit) {
  for (int c = 0; c < kTwist; ++c)
    if (prescribed[static_cast<std::size_t>(c)] == which) visit(c);
}

/// L D L^T of a symmetric matrix, without pivoting: definite matrices need none, and others are
/// reported.
struct Factors {
  TwistMatrix L = TwistMatrix::Identity();
  Twist D;
};

Factors factorize(const TwistMatrix& m) {
  Factors factors;
  TwistMatrix rest = m;
  for (int c = 0; c < kTwist; ++c) {
    factors.D[c] = rest(c, c);
    for (int r = c + 1; r < kTwist; ++r) factors.L(r, c) = rest(r, c) / rest(c, c);
    for (int r = c + 1; r < kTwist; ++r) rest.row(r) -= factors.L(r, c) * rest.row(c);
  }
  return factors;
}

Twist solve(const Factors& factors, Twist x) {
  factors.L.triangularView<Eigen::UnitLower>().solveInPlace(x);
  x.array() /= factors.D.array();
  factors.L.transpose().triangularView<Eigen::UnitUpper>().solveInPlace(x);
  return x;
}

}  // namespace

HubEquation sum_hub_equation(const SymmetricTwistMatrix& mass, const Twist& twist,
                             const Twist& applied, const HubStiffening& stiffening,
                             std::span<const tree::HubShare<Space>> subsystems) noexcept {
  const Angular w = angular(twist);
  SymmetricTwistMatrix sum = mass;
  Twist force = calc_gyroscopic_force(mass, twist) + applied;
  for (const tree::HubShare<Space>& subsystem : subsystems) {
    sum = sum + subsystem.mass;
    force += subsystem.force;
  }
  sum.rr -= stiffening.inertia;
  angular(force) += calc_stiffening_moment(stiffening, w);
  return {sum.matrix(), force};
}

HubAcceleration solve_hub(const HubEquation& equation, const Prescribed& prescribed,
                          const Twist& given) noexcept {
  // (1) Of prescribed components the row becomes the identity's, the column goes to the right-hand
  // side.
  TwistMatrix mass = equation.mass;
  Twist right = equation.force;
  for_each(prescribed, true, [&](int c) { right -= given[c] * equation.mass.col(c); });
  for_each(prescribed, true, [&](int c) {
    mass.row(c) = Twist::Unit(c).transpose();
    mass.col(c) = Twist::Unit(c);
    right[c] = given[c];
  });
  const Factors factors = factorize(mass);
  HubAcceleration solution;
  solution.acceleration = solve(factors, right);
  // (2) The reaction is what is left of the equation; of free components there is none.
  solution.reaction = equation.mass * solution.acceleration - equation.force;
  solution.least_pivot = 1.0;
  for_each(prescribed, false, [&](int c) {
    solution.reaction[c] = 0.0;
    solution.least_pivot =
        std::min(solution.least_pivot, factors.D[c] / std::abs(equation.mass(c, c)));
  });
  return solution;
}

}  // namespace spoke::space
