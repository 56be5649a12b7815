// Runs of beams with strains of second order: however a beam is cut, and whatever turns it, it
// moves alike, in few iterations a step.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "engine/simulation.h"
#include "tests/engine/bodies/space/nonlinear_beams.h"

namespace spoke::test {
namespace {

using doctest::Approx;
using spatial::JointKind;
using spatial::LoadFrame;
using spatial::Vector;
using std::numbers::pi;

constexpr Cut kSixteen{16, 1};

const SimulationOptions kSerial{Formulation::structured, ExecutorKind::serial, 1, 0};

/// A sensor's place over the undeformed one, `x` along the axis of the tree.
Vector place_of(const Simulation& simulation, const std::string& name, double x) {
  const auto value = [&](const char* component) {
    return simulation.sensor("s." + name + "." + component);
  };
  return {x + value("x"), value("y"), value("z")};
}

double passes_of(const Simulation& simulation) {
  return static_cast<double>(simulation.evaluations()) / static_cast<double>(simulation.steps());
}

/// From 0 to 1 in a second, smoothly, and then still.
spatial::MotionTable rise(double value) {
  std::vector<double> times, values;
  for (int k = -2; k <= 14; ++k) {
    const double t = std::clamp(0.1 * k, 0.0, 1.0);
    times.push_back(0.1 * k);
    values.push_back(value * (t - std::sin(2.0 * pi * t) / (2.0 * pi)));
  }
  return move(times, values);
}

/// The crank of 0.15 m is the hub, which reaches 150 rad/s in 0.1 s; a steel rod of 5.5 mm by 5.5
/// mm leads from it to a slider of 0.25 kg. Its force of inertia is three quarters of the rod's
/// buckling load.
BeamTree make_slider_crank(const Cut& cut) {
  const double area = 5.5e-3 * 5.5e-3, second = area * area / 12.0;
  BeamTree beams;
  beams.model().hub.drive = SpinUp{150.0, 0.1};
  beams
      .add("rod",
           make_nonlinear_beam({.axial = 2e11 * area,
                                .torsion = 1.35e11 * second,
                                .flap = 2e11 * second,
                                .lag = 2e11 * second,
                                .mass = 7870.0 * area,
                                .flap_inertia = 7870.0 * second,
                                .lag_inertia = 7870.0 * second},
                               0.3, cut),
           JointKind::revolute, Vector::UnitZ())
      .joint.offset = {0.15, 0.0, 0.0};
  beams.add("slider", make_ball(0.25, 1e-4), JointKind::revolute, Vector::UnitZ());
  Loop& guide = beams.close(LoopKind::prismatic, "slider", Vector::Zero());
  guide.to.carrier = LoopPlace::Carrier::mount;
  guide.axes[0] = Vector::UnitX();
  beams.watch("root", "rod", 0.0);
  beams.watch("middle", "rod", 0.15);
  beams.watch("end", "rod", 0.3);
  beams.run_for(1e-3, 0.2);
  return beams;
}

/// Returns the largest distance of the rod's middle from the line between its ends, at full speed.
double find_bow(const Cut& cut) {
  Simulation simulation(make_slider_crank(cut).scenario, kSerial);
  double most = 0.0;
  simulation.run_until(0.2, [&](double, std::span<const double>) {
    if (simulation.time() < 0.1) return;
    const Vector root = place_of(simulation, "root", 0.15),
                 along = place_of(simulation, "end", 0.45) - root,
                 middle = place_of(simulation, "middle", 0.3) - root;
    most = std::max(most, along.cross(middle).norm() / along.norm());
  });
  CHECK(passes_of(simulation) < 5.0);
  return most;
}

/// An arm of two soft links that slews by 3 rad and back at its elbow by 2.5 rad, under its weight.
BeamTree make_arm(const Cut& cut) {
  BeamTree beams;
  beams.model().gravity = {0.0, -9.81, 0.0};
  const auto link = [&cut](double stiffness) {
    return make_nonlinear_beam({.axial = 1e6,
                                .torsion = 0.8 * stiffness,
                                .flap = stiffness,
                                .lag = stiffness,
                                .mass = 0.5,
                                .flap_inertia = 1e-5,
                                .lag_inertia = 1e-5},
                               0.5, cut);
  };
  beams.add("upper", link(10.0), JointKind::revolute, Vector::UnitZ()).joint.coordinates[0].motion =
      rise(3.0);
  beams.add("elbow", make_ball(0.3, 1e-4));
  beams.add("lower", link(3.0), JointKind::revolute, Vector::UnitZ()).joint.coordinates[0].motion =
      rise(-2.5);
  beams.add("hand", make_ball(0.2, 1e-4));
  beams.watch("hand", "hand");
  beams.run_for(4e-3, 1.2);
  return beams;
}

/// Returns where a sensor's place is, step by step.
std::vector<Vector> follow(const Scenario& scenario, const std::string& sensor) {
  Simulation simulation(scenario, kSerial);
  std::vector<Vector> places;
  simulation.run_until(scenario.integration.duration, [&](double, std::span<const double>) {
    places.push_back(place_of(simulation, sensor, 0.0));
  });
  CHECK(passes_of(simulation) < 3.0);
  return places;
}

double find_distance(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, (a[k] - b[k]).norm());
  return most;
}

/// A soft link that slews by 3 rad and carries a mass at its end and two more within.
BeamTree make_laden_link(const Cut& cut) {
  BeamTree beams;
  beams
      .add("link",
           make_nonlinear_beam({.axial = 1e6,
                                .torsion = 1.5,
                                .flap = 1.5,
                                .lag = 1.5,
                                .mass = 0.5,
                                .flap_inertia = 1e-5,
                                .lag_inertia = 1e-5},
                               0.5, cut),
           JointKind::revolute, Vector::UnitZ())
      .joint.coordinates[0]
      .motion = rise(3.0);
  for (const double station : {0.5, 0.125, 0.25}) {
    spatial::SubsystemJoint& joint = beams.add("mass" + std::to_string(beams.tree().bodies.size()),
                                               make_ball(station == 0.5 ? 0.3 : 0.05, 1e-4));
    joint.parent = "link";
    joint.station = station;
  }
  beams.watch("end", "link");
  beams.run_for(4e-3, 1.2);
  return beams;
}

/// A motor turns a hub with a soft beam, which weight bends.
BeamTree make_motor(const Cut& cut, const Curve& torque) {
  BeamTree beams;
  spatial::Hub& hub = beams.model().hub;
  hub.inertia = 0.1 * Eigen::Matrix3d::Identity();
  hub.drive = TorqueDrive{torque};
  beams.model().gravity = {0.0, 0.0, -9.81};
  beams.add("beam", make_nonlinear_beam({.axial = 1e6,
                                         .torsion = 5.0,
                                         .flap = 4.0,
                                         .lag = 20.0,
                                         .flap_inertia = 1e-5,
                                         .lag_inertia = 1e-5},
                                        1.0, cut));
  beams.scenario.sensors.emplace_back().quantity = SensorQuantity::momentum;
  beams.run_for(1e-3, 1.0);
  return beams;
}

/// A vehicle that tumbles in free flight, with a propeller of two blades at 60 rad/s: on a joint,
/// or on the axle of a hub. Each blade lifts 3 N/m.
BeamTree make_vehicle(const Cut& cut, bool on_joint) {
  const double speed = 60.0;
  const Eigen::Matrix3d inertia = Vector(0.3, 0.4, 0.5).asDiagonal();
  const Vector velocity(1.0, 0.0, 0.0), turn(0.5, 0.8, 0.0), place(0.1, 0.0, 0.2);
  BeamTree beams;
  spatial::Hub& hub = beams.model().hub;
  const std::string carrier = on_joint ? "shaft" : "hub";
  if (on_joint) {
    hub.support = HubSupport::free;
    hub.drive = FreeDrive{};
    hub.mass = 5.0;
    hub.inertia = inertia;
    hub.velocity = velocity;
    hub.angular_velocity = turn;
    spatial::Joint& joint =
        beams.add("shaft", make_ball(0.2, 1e-3), JointKind::revolute, Vector::UnitZ()).joint;
    joint.offset = place;
    joint.coordinates[0].motion = move({-1.0, 0.0, 10.0}, {-speed, 0.0, 10.0 * speed});
  } else {
    hub.mass = 0.2;
    hub.inertia = 1e-3 * Eigen::Matrix3d::Identity();
    hub.drive = ConstantSpeed{speed};
    beams.model().subsystems.push_back({.name = std::string(spatial::kSupportName)});
    spatial::Support& support = beams.model().support.emplace();
    support.from = spatial::SupportBase::free;
    support.fuselage = {
        .mass = 5.0, .inertia = inertia, .velocity = velocity, .angular_velocity = turn};
    support.axle.offset = place;
  }
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0.0 ? "blade" : "other";
    spatial::SubsystemJoint& root = beams.add(name, make_nonlinear_beam({.axial = 1e6,
                                                                         .torsion = 2.0,
                                                                         .flap = 2.0,
                                                                         .lag = 20.0,
                                                                         .mass = 0.3,
                                                                         .flap_inertia = 1e-5,
                                                                         .lag_inertia = 1e-5},
                                                                        0.6, cut));
    root.parent = carrier;
    root.joint.offset = {0.05 * side, 0.0, 0.0};
    root.joint.orientation = {0.0, 0.0, side > 0.0 ? 0.0 : pi};
    beams.push_along(name, LoadFrame::body, {0.0, 0.0, 3.0}).ramp = 0.2;
  }
  beams.run_for(5e-4, 0.5);
  return beams;
}

/// Where the vehicle has gone and how it has turned, and the energy in its blades [m, rad, J].
std::vector<double> fly(const Cut& cut, bool on_joint) {
  Simulation simulation(make_vehicle(cut, on_joint).scenario, kSerial);
  simulation.run_until(0.5);
  const std::string vehicle = on_joint ? "hub" : "fuselage";
  std::vector<double> end;
  for (const char* of : {".x", ".y", ".z", ".rotation.x", ".rotation.y", ".rotation.z"})
    end.push_back(simulation.sensor(vehicle + of));
  end.push_back(simulation.sensor("energy.strain"));
  return end;
}

/// A bob of 20 kg on two links of 0.1 kg, hinged at their ends, which a force pulls aside and lets
/// go.
BeamTree make_pendulum(const Cut& cut) {
  BeamTree beams;
  beams.model().gravity = {0.0, 0.0, -9.81};
  beams.scenario.initial.state = InitialState::equilibrium;
  const spatial::Beam link = make_nonlinear_beam({.axial = 1e6,
                                                  .flap = 0.5,
                                                  .lag = 0.5,
                                                  .mass = 0.1,
                                                  .flap_inertia = 1e-8,
                                                  .lag_inertia = 1e-8},
                                                 1.0, cut);
  beams.add("upper", link, JointKind::revolute, Vector::UnitY()).joint.orientation = {0.0, 0.5 * pi,
                                                                                      0.0};
  beams.add("lower", link, JointKind::revolute, Vector::UnitY());
  beams.add("bob", make_ball(20.0, 0.1));
  beams.push("bob", LoadFrame::inertial, {100.0, 0.0, 0.0}).factor =
      Curve({0.0, 0.2, 0.6, 0.8, 1.0}, {0.0, 1.0, 1.0, 0.0, 0.0});
  beams.watch("bob", "bob");
  beams.run_for(0.01, 3.0);
  return beams;
}

/// A strut between ball joints, under half its buckling load, whose lowest vibration has a period
/// of 0.03 s.
BeamTree make_strut(const Cut& cut, double step) {
  BeamTree beams;
  spatial::SubsystemJoint& foot = beams.add(
      "strut",
      make_nonlinear_beam({.axial = 1e6, .mass = 1e-3, .flap_inertia = 1e-8, .lag_inertia = 1e-8},
                          1.0, cut),
      JointKind::universal, Vector::UnitY());
  foot.joint.axes[1] = Vector::UnitZ();
  beams.add("top", make_ball(1.0, 1e-2));
  // Rods of 1 km keep the top on the line.
  beams.close(LoopKind::distance, "top", {1.0, 1000.0, 0.0});
  beams.close(LoopKind::distance, "top", {1.0, 0.0, 1000.0});
  beams.push("top", LoadFrame::inertial, {-5.0, 0.0, 0.0}).ramp = 2.0;
  beams.push_along("strut", LoadFrame::inertial, {0.0, 0.0, 0.1}).ramp = 2.0;
  beams.model().damping.stiffness_factor = 1e-3;
  beams.watch("top", "top");
  beams.watch("middle", "strut", 0.5);
  beams.run_for(step, 4.0);
  return beams;
}

}  // namespace

TEST_CASE("a slender rod of a fast slider-crank bows alike, however it is cut") {
  const double right = find_bow(kSixteen);
  CHECK(right > 3e-3);
  for (const Cut& cut : kCuts) CHECK(find_bow(cut) == Approx(right).epsilon(tolerance_of(cut)));
}

TEST_CASE("an arm of two soft links slews alike, however it is cut, in few iterations a step") {
  const std::vector<Vector> right = follow(make_arm(kSixteen).scenario, "hand");
  for (const Cut& cut : kCuts)  // of a reach of 1 m
    CHECK(find_distance(follow(make_arm(cut).scenario, "hand"), right) < tolerance_of(cut));
}

TEST_CASE("so does a link that carries masses within, and bends by a radian") {
  const std::vector<Vector> right = follow(make_laden_link(kSixteen).scenario, "end");
  for (const Cut& cut : kCuts)
    CHECK(find_distance(follow(make_laden_link(cut).scenario, "end"), right) <
          0.5 * tolerance_of(cut));
}

TEST_CASE("a motor spins a soft beam up alike, however it is cut") {
  const Curve torque({0.0, 0.1, 0.4, 0.5, 0.6}, {0.0, 20.0, 20.0, 0.0, 0.0});
  double impulse = 0.0;
  for (int k = 0; k < 6000; ++k) impulse += 1e-4 * torque.value(1e-4 * (k + 0.5));
  struct Motion {
    std::vector<Vector> tips;
    double speed = 0.0;
  };
  const auto spin = [&](const Cut& cut) {
    Simulation simulation(make_motor(cut, torque).scenario, kSerial);
    Motion motion;
    simulation.run_until(1.0, [&](double, std::span<const double>) {
      motion.tips.push_back(place_of(simulation, "tip", 0.0));
    });
    CHECK(passes_of(simulation) < 4.0);
    CHECK(simulation.sensor("momentum.angular.z") == Approx(impulse).epsilon(1e-4));
    motion.speed = simulation.sensor("hub.speed");
    return motion;
  };
  const Motion right = spin(kSixteen);
  double lag = 0.0;
  for (const Vector& tip : right.tips) lag = std::max(lag, std::abs(tip.y()));
  CHECK(lag > 0.35);
  for (const Cut& cut : kCuts) {
    CAPTURE(cut.bodies);
    const Motion found = spin(cut);
    CHECK(found.speed == Approx(right.speed).epsilon(tolerance_of(cut)));
    CHECK(find_distance(found.tips, right.tips) < tolerance_of(cut) * lag);
  }
}

TEST_CASE("a vehicle flies alike with its propeller on a joint or on an axle") {
  const std::vector<double> right = fly(kSixteen, true);
  for (const Cut& cut : kCuts) {
    const std::vector<double> on_joint = fly(cut, true), on_axle = fly(cut, false);
    for (std::size_t k = 0; k < right.size(); ++k) {
      CAPTURE(k);
      CHECK(on_joint[k] == Approx(on_axle[k]).epsilon(1e-6));
    }
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(std::abs(on_joint[k] - right[k]) < tolerance_of(cut) * std::abs(right[0]));
  }
}

TEST_CASE("light links under a heavy bob take few iterations a step") {
  const auto swing = [](const Cut& cut) {
    Simulation simulation(make_pendulum(cut).scenario, kSerial);
    simulation.run_until(3.0);
    CHECK(passes_of(simulation) < 3.0);
    return place_of(simulation, "bob", 0.0);
  };
  const Vector right = swing(kSixteen);
  CHECK(std::abs(right.x()) > 0.3);
  for (const Cut& cut : kCuts) CHECK((swing(cut) - right).norm() < tolerance_of(cut));
}

TEST_CASE("a strut bears its pressure in steps of many periods of its bending") {
  const auto bow = [](const Cut& cut, double step) {
    Simulation simulation(make_strut(cut, step).scenario, kSerial);
    simulation.run_until(4.0);
    return place_of(simulation, "middle", 0.0).z();
  };
  // A load q across: 5 q L^4/(384 EI) by 1/(1 - P/P_e), to 0.3 % (Timoshenko).
  const double right = 5.0 * 0.1 / 384.0 / (1.0 - 5.0 / (pi * pi));
  for (const Cut& cut : kCuts)
    for (const double step : {0.005, 0.05}) {
      CAPTURE(step);
      CHECK(bow(cut, step) == Approx(right).epsilon(0.01));
    }
}

}  // namespace spoke::test
