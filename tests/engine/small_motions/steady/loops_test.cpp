// Tests equilibria and small motions of models with closed loops: against closed forms, against
// null spaces that are found here, and against models whose loops are cut open.

#include <doctest/doctest.h>

#include <cmath>

#include "engine/modes.h"
#include "tests/engine/small_motions/steady/loop_mechanisms.h"
#include "tests/message_of.h"

namespace spoke {
namespace {

using Eigen::Vector3d;
using spatial::JointKind;
using test::make_beam;
using test::make_joint;
using test::make_rigid;
using test::message_of;
using test::on_body;
using test::on_hub;

/// Returns the derivative of f at x, to fourth order.
template <class Function>
double differ(const Function& f, double x) {
  constexpr double h = 2e-3;
  return (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h);
}

std::vector<double> frequencies_of(const ModesResult& modes) {
  std::vector<double> list;
  for (const Mode& mode : modes.modes) list.push_back(std::abs(mode.eigenvalue));
  return list;
}

TEST_CASE("loops: a four-bar under gravity rests and vibrates as its one angle says") {
  const test::FourBar bars;
  const auto slope = [&](double theta) {
    return differ([&](double x) { return bars.energy(x); }, theta);
  };
  double theta = bars.rest;
  for (int i = 0; i < 20; ++i) theta -= slope(theta) / differ(slope, theta);
  const double frequency = std::sqrt(differ(slope, theta) / bars.inertia(theta));
  const Scenario scenario = make_scenario(bars);
  const ModesResult modes = solve_modes(scenario, {.count = 1});
  const BladeEquilibrium& found = modes.equilibrium.blades.at(0);
  const auto [crank, coupler, rocker] = bars.angles(theta);
  CHECK(found.joints.at(0).value == doctest::Approx(crank).epsilon(1e-9));
  CHECK(found.joints.at(1).value == doctest::Approx(coupler - crank).epsilon(1e-9));
  CHECK(found.joints.at(2).value == doctest::Approx(rocker).epsilon(1e-9));
  CHECK(modes.modes.at(0).frequency == doctest::Approx(frequency).epsilon(1e-8));
  CHECK(modes.modes.at(0).coordinates.size() == 3);
  CHECK(solve_modes(scenario, {.count = 2}).notes.size() == 1);  // there is one
  // The rocker's moments about its joint balance.
  const Vector3d tip(bars.rocker * std::cos(rocker), bars.rocker * std::sin(rocker), 0.0);
  const Vector3d weight(0.0, -bars.masses[2] * bars.gravity, 0.0);
  const LoopLoad& pin = found.loops.at(0);
  CHECK(pin.name == "pin");
  CHECK(tip.cross(-pin.force).z() + (0.5 * tip).cross(weight).z() ==
        doctest::Approx(0.0).scale(weight.norm()).epsilon(1e-10));
  CHECK(pin.force.norm() > 1.0);
}

LoopKind kind_of(JointKind kind) {
  for (const LoopKind like : {LoopKind::revolute, LoopKind::universal, LoopKind::spherical})
    if (name_of(like) == spatial::name_of(kind)) return like;
  return LoopKind::fixed;
}

/// A beam on the hub, and behind a joint a rigid body, or another beam. `is_cut`: all motion is
/// left to what is behind, by bodies that weigh nothing, and a loop closes the joint.
Scenario make_jointed(JointKind kind, bool is_cut, bool is_elastic) {
  constexpr double kNothing = 1e-13;
  spatial::Subsystem arm;
  arm.name = "arm";
  arm.bodies = {{"inner", make_beam({.length = 0.8})},
                make_rigid("outer", 0.7, {0.4, 0.05, 0.02}, {0.012, 0.03, 0.02})};
  if (is_elastic) arm.bodies[1].shape = make_beam({.length = 0.6, .lag = 40.0, .flap = 25.0});
  const Vector3d root(0.3, 0.0, 0.0), axis(0.1, 0.8, 0.6), other(0.2, -0.6, 0.9);
  arm.joints = {make_joint("hub", "inner", JointKind::fixed, root)};
  if (!is_cut) {
    arm.joints.push_back(make_joint("inner", "outer", kind, {0, 0, 0}, axis));
    if (spatial::count_axes(kind) > 1) arm.joints.back().joint.axes[1] = other;
  } else {
    for (const char* name : {"along_x", "along_y", "along_z"})
      arm.bodies.push_back(
          make_rigid(name, kNothing, Vector3d::Zero(), Vector3d::Constant(kNothing)));
    const Vector3d tip(1.1, 0.0, 0.0);
    arm.joints.push_back(
        make_joint("hub", "along_x", JointKind::prismatic, tip, Vector3d::UnitX()));
    arm.joints.push_back(
        make_joint("along_x", "along_y", JointKind::prismatic, {0, 0, 0}, Vector3d::UnitY()));
    arm.joints.push_back(
        make_joint("along_y", "along_z", JointKind::prismatic, {0, 0, 0}, Vector3d::UnitZ()));
    arm.joints.push_back(make_joint("along_z", "outer", JointKind::spherical));
    Loop loop;
    loop.name = "seam";
    loop.kind = kind_of(kind);
    loop.from = on_body("outer");
    if (is_elastic) loop.from.station = 0.0;
    loop.to = on_body("inner");
    if (count_axes(loop.kind) > 0) loop.axes = {axis, other};
    arm.loops = {loop};
  }
  Scenario scenario = test::make_mechanism(arm);
  scenario.space->gravity = {0.0, 0.0, -3.0};
  scenario.space->damping.stiffness_factor = 1e-3;
  return scenario;
}

TEST_CASE("loops: a tree that is cut and closed again rests and vibrates as before") {
  for (const bool is_elastic : {false, true})
    for (const JointKind kind :
         {JointKind::fixed, JointKind::revolute, JointKind::universal, JointKind::spherical}) {
      CAPTURE(is_elastic);
      CAPTURE(std::string(spatial::name_of(kind)));
      const ModeOptions options{.state = {.speed = 4.0}, .count = 8};
      const ModesResult whole = solve_modes(make_jointed(kind, false, is_elastic), options);
      const ModesResult cut = solve_modes(make_jointed(kind, true, is_elastic), options);
      for (std::size_t k = 0; k < 8; ++k) {
        const std::complex<double> a = whole.modes[k].eigenvalue, b = cut.modes[k].eigenvalue;
        CHECK(std::abs(a - b) < 1e-9 * std::abs(a) + 1e-6);
      }
      CHECK((whole.equilibrium.hub_force - cut.equilibrium.hub_force).norm() < 1e-9);
      CHECK((whole.equilibrium.hub_moment - cut.equilibrium.hub_moment).norm() < 1e-9);
    }
}

/// A mechanism of one body that turns about x with a link at an arm.
Scenario make_pitching(double stiffness, double damping) {
  spatial::Subsystem blade;
  blade.name = "blade";
  blade.bodies = {make_rigid("grip", 2.0, {0.5, 0.0, 0.0}, {0.013, 0.3, 0.3})};
  blade.joints = {make_joint("hub", "grip", JointKind::revolute, {0, 0, 0}, {1, 0, 0})};
  Loop link;
  link.name = "pitch_link";
  link.kind = LoopKind::distance;
  link.from = on_body("grip", {0.1, 0.08, 0.0});
  link.to = on_hub({0.1, 0.08, -0.3});
  link.stiffness = {stiffness};
  link.damping = {damping};
  blade.loops = {link};
  return test::make_mechanism(blade);
}

TEST_CASE("loops: a sprung pitch link gives the frequency and damping of the sprung pitch") {
  const double k = 4e4, d = 6.0, arm = 0.08, inertia = 0.013;
  const ModesResult modes = solve_modes(make_pitching(k, d), {});
  REQUIRE(modes.modes.size() == 1);
  const double frequency = arm * std::sqrt(k / inertia);
  CHECK(std::abs(modes.modes[0].eigenvalue) == doctest::Approx(frequency).epsilon(1e-10));
  CHECK(modes.modes[0].damping_ratio ==
        doctest::Approx(0.5 * d * arm * arm / (inertia * frequency)).epsilon(1e-10));
}

/// A blade whose pitch is driven, or held by a link.
Scenario make_linked_blade(bool has_link, double stiffness = 0.0) {
  Scenario scenario;
  scenario.name = "linked";
  spatial::Model& model = scenario.space.emplace();
  model.hub.mass = 1.0;
  model.hub.drive = ConstantSpeed{12.0};
  spatial::Blade blade;
  blade.beam = test::make_beam({.length = 2.0, .lag = 900.0, .flap = 400.0, .torsion = 60.0});
  blade.beam.bodies = 2;
  spatial::BladeJoint pitch;
  pitch.joint.name = "pitch";
  pitch.joint.kind = JointKind::revolute;
  pitch.joint.axes[0] = Vector3d::UnitX();
  if (!has_link) {
    pitch.joint.coordinates[0].motion = spatial::MotionTable{Curve(0.0)};
  } else {
    Loop link;
    link.name = "pitch_link";
    link.kind = LoopKind::distance;
    link.from.station = 0.0;
    link.from.point = {0.0, -0.1, 0.0};
    link.to.carrier = LoopPlace::Carrier::anchor;
    link.to.name = "swashplate";
    link.to.point = {0.0, -0.1, -0.25};
    if (stiffness > 0.0) link.stiffness = {stiffness};
    blade.loops = {link};
    Anchor anchor;
    anchor.name = "swashplate";
    anchor.turns_with_hub = true;
    model.anchors = {anchor};
  }
  blade.joints = {pitch};
  model.blades = {blade};
  spatial::DistributedLoad lift;
  lift.force_per_length = {0.0, 0.0, 20.0};
  lift.moment_per_length = {1.5, 0.0, 0.0};
  model.distributed_loads = {lift};
  return scenario;
}

TEST_CASE("loops: the force of a pitch link is the root's pitching moment by its arm") {
  const EquilibriumResult driven = solve_equilibrium(make_linked_blade(false));
  const EquilibriumResult linked = solve_equilibrium(make_linked_blade(true));
  const double moment = driven.blades.at(0).loads.at(0).moment.x();
  REQUIRE(std::abs(moment) > 1.0);
  const LoopLoad& link = linked.blades.at(0).loops.at(0);
  // It stands along z at y = -0.1.
  CHECK(link.tension.value() == doctest::Approx(-moment / 0.1).epsilon(1e-9));
  CHECK(-0.1 * link.force.z() == doctest::Approx(-moment).epsilon(1e-9));
  CHECK((driven.blades[0].tip_displacement - linked.blades[0].tip_displacement).norm() < 1e-10);
  // The swashplate takes the link's force.
  CHECK(linked.hub_force.z() == doctest::Approx(driven.hub_force.z() - link.force.z()));
  // Vibrations are those of the driven pitch.
  const auto whole = frequencies_of(solve_modes(make_linked_blade(false), {.count = 5}));
  const auto closed = frequencies_of(solve_modes(make_linked_blade(true), {.count = 5}));
  const auto sprung = frequencies_of(solve_modes(make_linked_blade(true, 1e9), {.count = 5}));
  for (std::size_t k = 0; k < whole.size(); ++k) {
    CHECK(closed[k] == doctest::Approx(whole[k]).epsilon(1e-8));
    CHECK(sprung[k] == doctest::Approx(closed[k]).epsilon(1e-5));
  }
}

TEST_CASE(
    "loops: blades with pitch links on a hub that they turn vibrate like those of driven pitch") {
  const auto make = [](bool has_link) {
    Scenario scenario = make_linked_blade(has_link);
    spatial::Model& model = *scenario.space;
    model.distributed_loads.clear();
    model.hub.drive = FreeDrive{12.0};
    model.hub.inertia = Vector3d(1.0, 1.0, 2.0).asDiagonal();
    for (int k = 1; k < 5; ++k) {
      model.blades.push_back(model.blades[0]);
      model.blades.back().azimuth = 0.4 * std::acos(-1.0) * k;
    }
    return scenario;
  };
  const ModesResult driven = solve_modes(make(false), {.count = 24});
  const ModesResult linked = solve_modes(make(true), {.count = 24});
  CHECK(linked.are_blades_coupled);
  for (std::size_t k = 0; k < 24; ++k) {
    CHECK(linked.modes[k].frequency == doctest::Approx(driven.modes[k].frequency).epsilon(1e-8));
    CHECK(linked.modes[k].name == driven.modes[k].name);
  }
  CHECK(linked.modes[0].coordinates.size() == driven.modes[0].coordinates.size() + 5);
}

TEST_CASE("loops: a free model that is cut and closed again vibrates as before") {
  const auto make = [](bool is_cut) {
    Scenario scenario = make_jointed(JointKind::universal, is_cut, true);
    scenario.space->hub.support = HubSupport::free;
    scenario.space->hub.drive = FreeDrive{};
    scenario.space->hub.center = {0.1, 0.2, -0.1};
    return scenario;
  };
  const ModesResult whole = solve_modes(make(false), {.count = 16});
  const ModesResult cut = solve_modes(make(true), {.count = 16});
  for (std::size_t k = 0; k < 16; ++k)
    CHECK(std::abs(whole.modes[k].eigenvalue - cut.modes[k].eigenvalue) <
          1e-9 * std::abs(whole.modes[k].eigenvalue) + 1e-12);
  // Six motions of the hub, two of the joint.
  CHECK(cut.modes[7].frequency == 0.0);
  CHECK(cut.modes[8].frequency > 1.0);
}

}  // namespace
}  // namespace spoke
