#include "engine/space/hub_equation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/space/rigid_body_terms.h"
#include "tests/models/space/random_space.h"

using namespace spoke::space;
using namespace spoke::space::testing;

TEST_CASE("a free hub moves by its stiffened inertia") {
  std::mt19937 random(1);
  const SymmetricTwistMatrix mass = random_inertia(random);
  const Twist twist = random_twist(random), applied = random_twist(random);
  HubStiffening stiffening;
  stiffening.inertia = 0.01 * random_inertia(random).rr;
  stiffening.rate = 0.01 * random_inertia(random).rr;
  const HubEquation equation = sum_hub_equation(mass, twist, applied, stiffening, {});
  const HubAcceleration solution = solve_hub(equation, {}, Twist::Zero());
  CHECK(solution.reaction.norm() == 0.0);
  CHECK(solution.least_pivot > 0.0);
  // d/dt of the angular momentum that stiffening takes, L = - Lambda w, in the turning frame.
  const Angular w = angular(twist);
  const Angular lost = stiffening.inertia * angular(solution.acceleration) + stiffening.rate * w +
                       cross(w, stiffening.inertia * w);
  Twist left = mass * solution.acceleration - calc_gyroscopic_force(mass, twist);
  angular(left) -= stiffening.inertia * angular(solution.acceleration) + stiffening.rate * w +
                   cross(w, stiffening.inertia * w);
  CHECK(lost.norm() > 1e-3);
  CHECK((left - applied).norm() < 1e-12);
}

TEST_CASE("prescribed components of a hub are as given, and have the reaction") {
  std::mt19937 random(2);
  const TwistMatrix matrix = random_inertia(random).matrix();
  const HubEquation equation{matrix, random_twist(random)};
  const Rotation R = random_rotation(random);
  const Position gravity{0.0, 0.0, -9.81}, acceleration = random_vector(random);
  const Angular alpha{0.0, 0.0, 0.5};
  for (int kind = 0; kind < 64; ++kind) {
    Prescribed prescribed{};
    for (int c = 0; c < kTwist; ++c) prescribed[static_cast<std::size_t>(c)] = (kind >> c) & 1;
    const Twist given = calc_given(prescribed, R, gravity, Position::Zero(), alpha);
    const HubAcceleration solution = solve_hub(equation, prescribed, given);
    CHECK((matrix * solution.acceleration - equation.force - solution.reaction).norm() < 1e-10);
    for (int c = 0; c < kTwist; ++c) {
      if (prescribed[static_cast<std::size_t>(c)])
        CHECK(std::abs(solution.acceleration[c] - given[c]) < 1e-14);
      else
        CHECK(solution.reaction[c] == 0.0);
    }
  }
  Prescribed all;
  all.fill(true);
  const Twist moved = calc_given(all, R, gravity, acceleration, alpha);
  CHECK((R * Position(linear(moved)) + gravity - acceleration).norm() < 1e-14);
  CHECK((angular(moved) - alpha).norm() == 0.0);
  // Free coordinates take what prescribed ones are given.
  const Twist taken = calc_coordinate_accelerations({}, R, gravity, moved);
  CHECK((linear(taken) - acceleration).norm() < 1e-14);
  CHECK((angular(taken) - alpha).norm() == 0.0);
  CHECK(calc_coordinate_accelerations(all, R, gravity, moved).norm() == 0.0);
}

TEST_CASE("a hub whose inertia stiffening takes away is reported") {
  SymmetricTwistMatrix mass;
  mass.tt.setIdentity();
  mass.rr.setIdentity();
  HubStiffening stiffening;
  const auto solve_with = [&](double loss) {
    stiffening.inertia(2, 2) = loss;
    const HubEquation equation =
        sum_hub_equation(mass, Twist::Zero(), Twist::Zero(), stiffening, {});
    return solve_hub(equation, {}, Twist::Zero()).least_pivot;
  };
  CHECK(solve_with(0.9) > 0.0);
  CHECK(solve_with(1.1) <= 0.0);
}
