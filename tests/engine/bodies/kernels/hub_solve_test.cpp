#include "engine/bodies/kernels/hub_solve.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/bodies/space/rigid_body_terms.h"
#include "tests/engine/bodies/space/hub_table.h"
#include "tests/models/space/random_space.h"

using namespace spoke;
using namespace spoke::space::testing;

namespace {

space::SymmetricTwistMatrix random_mass(std::mt19937& random) {
  space::RigidBody body;
  body.mass = 2.0 + random_number(random);
  body.centre = random_vector(random);
  body.inertia = random_inertia(random).rr();
  return space::calc_mass(body);
}

}  // namespace

TEST_CASE("a free hub in space moves by its stiffened inertia") {
  std::mt19937 random(1);
  const tree::HubShare<Space> nothing{{}, space::Twist::Zero()};
  HubTable table({&nothing, 1});
  const space::SymmetricTwistMatrix mass = random_mass(random);
  const space::Twist twist = random_twist(random), applied = random_twist(random);
  table.system.hub.support = HubSupport::free;
  table.system.hub.inertia = mass;
  table.system.hub_loads.emplace_back().force = linear(applied);
  table.system.hub_loads.back().moment = angular(applied);
  table.data.hub.twist = twist;
  space::HubStiffening& stiffening = table.data.subsystems[0].effective.stiffening;
  stiffening.inertia = 0.01 * random_inertia(random).rr();
  stiffening.rate = 0.01 * random_inertia(random).rr();
  const HubSolution<Space>& solution = table.solve();
  CHECK(solution.reaction.norm() == 0.0);
  // d/dt of the angular momentum that stiffening takes, L = - Lambda w, in the turning frame.
  const space::Angular w = angular(twist);
  const space::Angular lost = stiffening.inertia * angular(solution.acceleration) +
                              stiffening.rate * w + cross(w, stiffening.inertia * w);
  CHECK(lost.norm() > 1e-3);
  space::Twist left = mass * solution.acceleration - calc_gyroscopic_force(mass, twist);
  angular(left) -= lost;
  CHECK((left - applied).norm() < 1e-12);
}

TEST_CASE("prescribed components of a hub in space are as given, and have the reaction") {
  std::mt19937 random(2);
  const double alpha = 0.5;
  const Drive drives[] = {FixedDrive{}, TorqueDrive{Curve{1.5}}};
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const Drive& drive : drives) {
      const tree::HubShare<Space> share{random_inertia(random), random_twist(random)};
      HubTable table({&share, 1});
      space::Hub& hub = table.system.hub;
      hub.support = support;
      hub.drive = drive;
      hub.inertia = random_mass(random);
      table.system.gravity = {0.0, 0.0, -9.81};
      table.data.hub.R = random_rotation(random);
      table.data.hub.twist = random_twist(random);
      table.data.hub_coordinates.a[Space::kAxial] = alpha;
      const HubSolution<Space>& solution = table.solve();
      const HubEquation<Space> equation = sum_hub_equation(table.system, table.data);
      CHECK((equation.mass * solution.acceleration - equation.force - solution.reaction).norm() <
            1e-10);
      space::Twist given = space::Twist::Zero();
      linear(given) = -(table.data.hub.R.inverse() * table.system.gravity);
      given[Space::kAxial] = alpha;
      for (int c = 0; c < space::kTwist; ++c) {
        if (is_prescribed(hub, c))
          CHECK(std::abs(solution.acceleration[c] - given[c]) < 1e-14);
        else
          CHECK(solution.reaction[c] == 0.0);
      }
      // In the inertial frame an axle stays where it is; a free hub falls as fast as it is let.
      const space::Twist moved =
          calc_inertial_acceleration(table.system, 0.0, table.data.hub, solution);
      const space::Position falling =
          table.data.hub.R * space::Position(linear(solution.acceleration)) + table.system.gravity;
      if (support == HubSupport::axle)
        CHECK(linear(moved).norm() == 0.0);
      else
        CHECK((linear(moved) - falling).norm() < 1e-14);
      CHECK(falling.norm() < (support == HubSupport::axle ? 1e-14 : 1e3));
    }
}
