// The laws of motion know no direction and no place: a model that is turned and moved as a whole,
// with all that acts on it, makes the motion turned and moved.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/system/models.h"

using namespace spoke;
using namespace spoke::test;

namespace {

using Eigen::Vector3d;

/// A turn of all about the inertial origin, and then a displacement, which an axle has by a mount.
struct Move {
  Eigen::Matrix3d R;
  Vector3d p = Vector3d::Zero();
};

Eigen::Matrix3d turn_by(const Vector3d& vector) {
  return Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix();
}

/// From z to an axis, the smallest one.
Eigen::Matrix3d turn_to(const Vector3d& axis) {
  return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
}

/// Azimuths count from a direction that the axis has by itself: psi more.
void turn_blade(spatial::Blade& blade, double psi) {
  blade.azimuth += psi;
  for (spatial::BladeJoint& joint : blade.joints)
    for (spatial::JointCoordinate& coordinate : joint.joint.coordinates) {
      if (!coordinate.motion) continue;
      if (auto* pitch = std::get_if<spatial::AzimuthMotion>(&*coordinate.motion)) {
        const double c = pitch->cosine, s = pitch->sine;
        pitch->cosine = c * std::cos(psi) - s * std::sin(psi);
        pitch->sine = c * std::sin(psi) + s * std::cos(psi);
      }
    }
}

void turn_course(spatial::VectorCourse& course, const Eigen::Matrix3d& R) {
  auto& harmonic = std::get<spatial::VectorHarmonic>(course);
  for (Vector3d* vector : {&harmonic.constant, &harmonic.rate, &harmonic.amplitude})
    *vector = R * *vector;
}

void move_hub(spatial::Hub& hub, const Move& move) {
  const Eigen::Matrix3d& R = move.R;
  for (Vector3d* vector : {&hub.axis, &hub.center, &hub.velocity, &hub.angular_velocity})
    *vector = R * *vector;
  hub.inertia = R * hub.inertia * R.transpose();
  if (!hub.mount) return;
  turn_course(hub.mount->translation, R);
  turn_course(hub.mount->rotation, R);
  std::get<spatial::VectorHarmonic>(hub.mount->translation).constant += move.p;
}

/// The hub's frame is the inertial one at t = 0, which does not turn along.
void move_model(spatial::Model& model, const Move& move) {
  const Eigen::Matrix3d& R = move.R;
  const Eigen::Matrix3d about =
      turn_to(R * model.hub.axis).transpose() * R * turn_to(model.hub.axis);
  const double psi = std::atan2(about(1, 0), about(0, 0));
  for (spatial::Blade& blade : model.blades) turn_blade(blade, psi);
  move_hub(model.hub, move);
  model.gravity = R * model.gravity;
  for (spatial::PointLoad& load : model.loads) {
    load.force = R * load.force;
    load.moment = R * load.moment;
  }
  for (spatial::HubLoad& load : model.hub_loads) {
    load.position = R * load.position;
    load.force = R * load.force;
    load.torque = R * load.torque;
  }
  for (spatial::Subsystem& subsystem : model.subsystems)
    for (spatial::SubsystemJoint& joint : subsystem.joints) {
      if (joint.parent != "hub") continue;
      const Eigen::AngleAxisd turned(R * turn_by(joint.joint.orientation));
      joint.joint.offset = R * joint.joint.offset;
      joint.joint.orientation = turned.angle() * turned.axis();
    }
}

/// A run: the text of its scenario, the method and size of its steps, and the number of bodies of
/// its first tree.
struct MovedCase {
  std::string text;
  IntegrationMethod method;
  double step;
  int bodies;
};

/// At the end the largest of what the hub and the bodies of the first tree are apart from where
/// turning and moving the motion of the other model would have brought them, and of the differences
/// of deformations [m, m/s, rad].
double find_difference(const MovedCase& run, const Move& move) {
  Scenario scenario = make_scenario(run.text, run.step, 0.2, run.method);
  scenario.integration.tolerance = 1e-13;
  Scenario moved = scenario;
  move_model(*moved.space, move);
  const SimulationOptions serial{Formulation::structured, ExecutorKind::serial, 1, 0};
  Simulation a(scenario, serial), b(moved, serial);
  a.run_until(0.2);
  b.run_until(0.2);
  const auto place = [&move](const Vector3d& p) -> Vector3d { return move.R * p + move.p; };
  double most = (place(a.hub_frame().position) - b.hub_frame().position).norm();
  for (int j = 0; j < run.bodies; ++j) {
    const MarkerState of_a = a.marker({0, j, 0.0}), of_b = b.marker({0, j, 0.0});
    most = std::max(most, (place(of_a.position) - of_b.position).norm());
    most = std::max(most, (move.R * of_a.velocity - of_b.velocity).norm());
    const BodyState shape = a.body(0, j), other = b.body(0, j);
    for (std::size_t k = 0; k < shape.coordinates.size(); ++k)
      most = std::max(most, std::abs(shape.coordinates[k] - other.coordinates[k]));
  }
  return most;
}

const Move kTurn{turn_by({0.7, -1.1, 0.4})};

}  // namespace

TEST_CASE("a rotor with hinges that is turned and moved makes the same motion there") {
  const std::string mount =
      "[hub.mount]\n"
      "translation = { rate = [3.0, 0.5, 0.0], amplitude = [0.1, 0.1, 0.2], frequency = 5.0 }\n"
      "rotation = { constant = [0.1, 0.0, 0.2], amplitude = [0.2, -0.1, 0.0], frequency = 4.0 }\n";
  const std::string loads =
      "[[load]]\nframe = \"inertial\"\nforce = [1.0, -0.5, 2.0]\nmoment = [0.1, 0.2, -0.1]\n"
      "[[hub_load]]\nposition = [0.1, 0.2, 0.0]\nforce = [1.0, 2.0, 3.0]\ntorque = [0, 0.3, "
      "0.8]\n";
  for (const std::string& hub : {kDrivenHub, kTurnedHub}) {
    const MovedCase run{make_text(hub + mount, kBooms + kHinges + kPitch, kGravity + loads),
                        IntegrationMethod::generalized_alpha, 2e-3, 2};
    CHECK(find_difference(run, {kTurn.R, {20.0, -7.0, 3.0}}) < 1e-10);
  }
}

TEST_CASE("a tree on a free hub that is turned makes the same motion there") {
  const std::string loads =
      "[[load]]\nsubsystem = \"arm\"\nbody = \"mirror\"\nframe = \"hub\"\nforce = [1.0, -0.5, "
      "2.0]\n[[hub_load]]\nposition = [0.1, 0.2, 0.0]\nforce = [1.0, 2.0, 3.0]\n";
  for (const IntegrationMethod method :
       {IntegrationMethod::rk4, IntegrationMethod::generalized_alpha}) {
    const MovedCase run{make_text(kFlyingHub, kTree, kGravity + loads), method, 1e-3, 6};
    CHECK(find_difference(run, kTurn) < 1e-10);
  }
}
