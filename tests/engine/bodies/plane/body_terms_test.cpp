#include "engine/bodies/kernels/plane/body_terms.h"

#include <doctest/doctest.h>

#include "engine/bodies/kernels/dense_body.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/simulation/sensors.h"
#include "tests/approx.h"
#include "tests/engine/lagrangian.h"
#include "tests/engine/rotors.h"

using namespace spoke;
using namespace spoke::test;
using spoke::testing::approx;

namespace {

/// One blade of one body on a hub without inertia: its independent coordinates are the body's.
struct SingleBody {
  SystemContext<Plane> context;

  SingleBody(ReferenceFrame frame, int elements, std::mt19937& random) {
    Blade blade = wu_haug_blade(1, elements);
    blade.reference_frame = frame;
    blade.geometric_stiffening = false;
    Rotor rotor = make_rotor(blade, 1);
    rotor.hub.support = HubSupport::free;
    rotor.hub.drive = FreeDrive{};
    rotor.hub.mass = rotor.hub.inertia = 0.0;
    make_context(rotor, Formulation::structured, Rk4{1e-5}, context);
    randomize_state(random, context);
    context.data.hub_coordinates.q[kRotation] = 0.0;  // inertial components are the hub's
  }
};

}  // namespace

TEST_CASE("the mass matrix of a body is the Hessian of its kinetic energy") {
  std::mt19937 random(3);
  for (const ReferenceFrame frame : {ReferenceFrame::clamped, ReferenceFrame::chord})
    for (const int elements : {1, 2, 5}) {
      SingleBody single(frame, elements, random);
      if (frame == ReferenceFrame::chord) {
        // The body's frame is turned against the hub by psi_0: leave that to the system's test.
        BodyData<Plane>& body = single.context.data.subsystems[0].bodies[0];
        body.coordinates.q[body.layout.v()] = 0.0;
      }
      const Lagrangian lagrangian(single.context.system);
      const Eigen::MatrixXd expected = lagrangian.mass(independent_coordinates(single.context));
      evaluate(0.0, single.context);
      const BodyData<Plane>& body = single.context.data.subsystems[0].bodies[0];
      Eigen::MatrixXd mass(expected.rows(), expected.cols());
      calc_dense_mass(body, make_dense_elastic_block(*body.model->body, 1.0, 0.0), false, mass);
      if (frame == ReferenceFrame::chord) {
        // psi_0 is an independent coordinate that turns the frame back: theta = angle - psi_0.
        Eigen::MatrixXd T = Eigen::MatrixXd::Identity(mass.rows(), mass.cols());
        T(kRotation, kTwist + body.model->body->axial()) = -1.0;
        mass = (T.transpose() * mass * T).eval();
      }
      CAPTURE(elements);
      CHECK((mass - expected).lpNorm<Eigen::Infinity>() <
            1e-12 * expected.lpNorm<Eigen::Infinity>());
    }
}

TEST_CASE("accelerations satisfy Lagrange's equations of the whole system") {
  // Free hub, gravity, torque, stiffened and linear blades in both reference frames: everything but
  // damping, which has no potential, and point loads, below.
  std::mt19937 random(11);
  for (int round = 0; round < 6; ++round) {
    Rotor rotor = make_random_rotor({1 + round % 3, HubSupport::free, false}, random);
    rotor.damping = {};
    SystemContext<Plane> context;
    make_context(rotor, Formulation::structured, Rk4{1e-5}, context);
    randomize_state(random, context);
    evaluate(1.0, context);
    const Lagrangian lagrangian(context.system);
    const Eigen::VectorXd a = independent_accelerations(context);
    const Eigen::VectorXd y = independent_coordinates(context);
    Eigen::VectorXd force = lagrangian.residual(y, independent_velocities(context), a);
    force[kRotation] -= calc_torque(rotor.hub.drive, 1.0, 0.0);
    // Differences of energies of about 1e2 J over steps of 1e-4: 1e-10 of the inertial forces.
    const double scale = (lagrangian.mass(y) * a).lpNorm<Eigen::Infinity>();
    CAPTURE(round);
    CHECK(force.lpNorm<Eigen::Infinity>() < 1e-8 * scale);
  }
}

TEST_CASE("a prescribed hub's reaction is what Lagrange's equations ask of drive and support") {
  std::mt19937 random(12);
  for (int round = 0; round < 4; ++round) {
    Rotor rotor = make_random_rotor({2, HubSupport::axle, true}, random);
    rotor.damping = {};
    SystemContext<Plane> context;
    make_context(rotor, Formulation::structured, Rk4{1e-5}, context);
    randomize_state(random, context);
    // Evaluation imposes the drive's motion first.
    const double t = 6.0;
    const Evaluation found = evaluate(t, context);
    evaluate(t, context);
    const Lagrangian lagrangian(context.system);
    const Eigen::VectorXd a = independent_accelerations(context);
    const Eigen::VectorXd y = independent_coordinates(context);
    const Eigen::VectorXd force = lagrangian.residual(y, independent_velocities(context), a);
    const double scale = (lagrangian.mass(y) * a).lpNorm<Eigen::Infinity>();
    CHECK(force.tail(force.size() - kTwist).lpNorm<Eigen::Infinity>() < 1e-8 * scale);
    const Twist reaction = plane::Rotation::from_angle(y[kRotation]) * found.hub_reaction;
    CHECK((force.head<kTwist>() - reaction).lpNorm<Eigen::Infinity>() < 1e-8 * scale);
  }
}

TEST_CASE("energies of a state are those of its Lagrangian") {
  std::mt19937 random(8);
  for (int round = 0; round < 4; ++round) {
    SystemContext<Plane> context;
    make_context(make_random_rotor({3, HubSupport::free, false}, random), Formulation::structured,
                 Rk4{1e-5}, context);
    const Lagrangian lagrangian(context.system);
    const double potential_at_start = lagrangian.potential_energy(independent_coordinates(context));
    const Energies at_start = calc_energies(context.system, context.data);
    randomize_state(random, context);
    const Energies energies = calc_energies(context.system, context.data);
    const Eigen::VectorXd y = independent_coordinates(context);
    CHECK(energies.kinetic ==
          approx(lagrangian.kinetic_energy(y, independent_velocities(context))).epsilon(1e-12));
    CHECK(energies.strain - (energies.gravity - at_start.gravity) ==
          approx(lagrangian.potential_energy(y) - potential_at_start).epsilon(1e-11));
  }
}
