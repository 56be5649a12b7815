// Bearings with full matrices in runs: closed forms of whirl, laws of any loops, and rigid ones.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <memory>
#include <string>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/simulation.h"
#include "tests/engine/bearing_models.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/step/step_declarations.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// A bearing that is alike in all directions, by the masses 40 and 30 kg of x and y, at 100 rad/s
/// with the damping 10 1/s; `share`: of cross-coupling, by that at which whirl persists.
std::string make_whirling(double share) {
  const double by_mass = share * 10.0 * 100.0 * std::sqrt(40.0 * 30.0);
  return matrix_key("stiffness", 4e5, by_mass, -by_mass, 3e5) +
         matrix_key("damping", 400, 0, 0, 300);
}

const CoordinateBlock& slide_of(const Run<Space>& run, std::size_t body) {
  return run.context.data.subsystems[0].bodies[body].joint.coordinates;
}

/// Returns x + i y, each by the square root of its mass.
std::complex<double> whirl_of(const Run<Space>& run) {
  return {std::sqrt(40.0) * slide_of(run, 0).q[0], std::sqrt(30.0) * slide_of(run, 1).q[0]};
}

/// Two trees, each an arm with an elastic boom and a crank, tied by bearings: from the boom to the
/// crank, and from the arm to `base`; on `hub`. `tie` and `stay`: their matrices.
std::string make_borne_booms(const std::string& hub, const std::string& base,
                             const std::string& tie, const std::string& stay) {
  std::string text = "world='space'\n" + hub;
  for (int side = 0; side < 2; ++side)
    text += "[[subsystem]]\nname='side" + std::to_string(side + 1) +
            "'\n"
            "body=[ { name='arm', kind='rigid', mass=2, center=[0.5,0,0.1], "
            "inertia=[0.1,0.2,0.25] },"
            " { name='boom', kind='beam', length=1, bodies=1, elements=2, "
            "sections={ mass_per_length=1, axial_stiffness=2e4, flap_stiffness=150, "
            "lag_stiffness=120, torsion_stiffness=60, flap_inertia=1e-3, lag_inertia=1e-3 } },"
            " { name='crank', kind='rigid', mass=1.5, center=[0.4,0.1,0], "
            "inertia=[0.1,0.2,0.15] } ]\n"
            "joint=[ { parent='hub', child='arm', kind='universal', axes=[[0,1,0],[0.1,0,1]], "
            "orientation=[0,0," +
            std::to_string(3 * side) +
            "], initial=[0.1,0.1], initial_speed=[1,-0.5], stiffness=[20,30] },"
            " { parent='arm', child='boom', kind='revolute', axis=[0,1,0.2], offset=[1,0,0.1], "
            "initial_speed=2, stiffness=5 },"
            " { parent='hub', child='crank', kind='spherical', offset=[0,0.6,0], "
            "orientation=[0,0," +
            std::to_string(3 * side) +
            "] } ]\n"
            "loop=[ { name='tie', kind='bearing', from={ body='boom', station=1 }, "
            "to={ body='crank', point=[2,-0.4,0.1] }, axis=[0.2,1,0.1]" +
            tie +
            " },"
            " { name='stay', kind='bearing', from={ body='arm', point=[0.3,0.1,0] }, "
            "to={ body='" +
            base + "', point=[" + (side == 0 ? "0.3,0.1" : "-0.31,-0.06") +
            ",0] }, axis=[0,0.1,1]" + stay + " } ]\n";
  return text + "[integration]\nstep=1e-3\nduration=1\n";
}

const std::string kTurningAxle =
    "[hub]\ninertia=1\n[hub.drive]\nkind='constant'\nspeed=2\n[gravity]\nacceleration=[0,0,-9.81]"
    "\n";
const std::string kFlyingHub =
    "[hub]\nsupport='free'\nmass=3\ninertia=[0.4,0.5,0.6]\nangular_velocity=[0.5,-0.4,1]\n";

const std::string kCrossed = ", stiffness=[[400,150],[-250,300]], damping=[[3,1.5],[-0.5,2]]";
const std::string kTable =
    ", speed=[-3, 0.5, 4], stiffness=[[[300,90],[-90,300]],[[200,50],[0,400]],"
    "[[500,0],[0,100]]], damping=[[[3,1],[-1,3]],[[0,2],[-2,0]],[[1,0],[0,2]]]";

System<Space> make_booms(const std::string& hub, const std::string& base, const std::string& tie,
                         const std::string& stay) {
  return make_system(parse_model(make_borne_booms(hub, base, tie, stay)));
}

}  // namespace

TEST_CASE("whirl on cross-coupled bearings grows as the root of its closed form says") {
  constexpr double kStep = 2.5e-4;
  for (const double share : {0.95, 1.0, 1.05}) {
    CAPTURE(share);
    const std::complex<double> q(-1e4, share * 1e3);
    const std::complex<double> root = -5.0 + std::sqrt(25.0 + q);
    const std::complex<double> start(1e-3, 0.0), rate = root * start;
    const System<Space> system = make_system(parse_model(make_sliding_mass(
        make_whirling(share), {start.real() / std::sqrt(40.0), start.imag() / std::sqrt(30.0)},
        {rate.real() / std::sqrt(40.0), rate.imag() / std::sqrt(30.0)})));
    const auto growth = [&](const Method& method) {
      Run<Space> run(system, {method});
      run.advance(8000);
      return std::log(std::abs(whirl_of(run) / start)) / (8000 * kStep);
    };
    CHECK(std::abs(growth(Rk4{kStep}) - root.real()) < 1e-5);
    CHECK(std::abs(growth(make_generalized_alpha(0.8, kStep)) - root.real()) < 5e-4);
  }
}

TEST_CASE("a matrix that is diagonal does what two springs and dampers do") {
  const std::string springs = ", stiffness=[4e5,2e5], damping=[30,80]";
  const std::string matrices =
      matrix_key("stiffness", 4e5, 0, 0, 2e5) + matrix_key("damping", 30, 0, 0, 80);
  for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})}) {
    const auto run = [&](const std::string& keys) {
      auto made = std::make_unique<Run<Space>>(
          make_system(parse_model(make_sliding_mass(keys, {1e-2, 2e-2}, {1.0, 0.0}))),
          RunSetup{method});
      made->advance(200);
      return made;
    };
    const auto sprung = run(springs), full = run(matrices);
    CHECK(largest_difference(*sprung, *full) < 1e-14);
    CHECK(std::abs(sprung->dissipated - full->dissipated) < 1e-12);
    CHECK(std::abs(calc_energy(*sprung) - calc_energy(*full)) < 1e-11);
  }
}

TEST_CASE("a shaft that spins between two speeds of a table has the stiffness in between") {
  const std::string table = ", speed=[10,30], stiffness=[[[1e5,0],[0,1e5]],[[3e5,2e4],[2e4,3e5]]]";
  for (const double spin : {15.0, 40.0, -20.0}) {
    const double share = spin < 10.0 ? 0.0 : spin > 30.0 ? 1.0 : 0.25;
    Run<Space> run(make_system(parse_model(make_sliding_mass(table, {1e-3, 0.0}, {0, 0}, spin))),
                   {Rk4{1e-3}});
    run.advance(100);
    Eigen::Matrix2d K, by_mass;
    K << 1e5 + share * 2e5, share * 2e4, share * 2e4, 1e5 + share * 2e5;
    by_mass << 1.0 / 40.0, 0.0, 0.0, 1.0 / 30.0;
    const Eigen::Vector2d expected = advance_undamped(by_mass * K, {1e-3, 0.0}, 0.1);
    CAPTURE(spin);
    CHECK(std::abs(slide_of(run, 0).q[0] - expected.x()) < 1e-8);
    CHECK(std::abs(slide_of(run, 1).q[0] - expected.y()) < 1e-8);
    CHECK(std::abs(slide_of(run, 2).v[0] - spin) < 1e-12);
  }
}

TEST_CASE("the force of a bearing is shown in the axes of the place that it is on") {
  // The axes of `to` are turned by a right angle about the bearing's axis: its x is y of the hub.
  std::string text = make_sliding_mass(matrix_key("stiffness", 4e5, 1e5, -5e4, 3e5), {2e-3, -1e-3},
                                       {0, 0}, 0.0, 1.5707963267948966);
  for (const std::string frame : {"loop", "hub"})
    text += "[[sensor]]\nname='" + frame + "'\nquantity='loop_reaction'\nsubsystem='s'\n" +
            "loop='bearing'\nframe='" + frame + "'\n";
  Simulation simulation(parse_scenario(text, "f"));
  const Eigen::Vector2d u(-1e-3, -2e-3);  // in the axes of `to`
  const Eigen::Vector2d force(-4e5 * u.x() - 1e5 * u.y(), 5e4 * u.x() - 3e5 * u.y());
  CHECK(std::abs(simulation.sensor("s.loop.force.x") - force.x()) < 1e-9);
  CHECK(std::abs(simulation.sensor("s.loop.force.y") - force.y()) < 1e-9);
  CHECK(std::abs(simulation.sensor("s.hub.force.x") + force.y()) < 1e-9);
  CHECK(std::abs(simulation.sensor("s.hub.force.y") - force.x()) < 1e-9);
}

TEST_CASE("three formulations move bearings with matrices alike") {
  for (const auto& [hub, base] : {std::pair(kTurningAxle, "mount"), std::pair(kFlyingHub, "hub")})
    for (const Method& method : {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})}) {
      const System<Space> system = make_booms(hub, base, kCrossed, kTable);
      check_formulations(system, method, 100, 1e-10);
    }
}

TEST_CASE("bearings have equal bits on executors, threads and windows") {
  for (const auto& [hub, base] : {std::pair(kTurningAxle, "mount"), std::pair(kFlyingHub, "hub")})
    for (const Method& method : {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})})
      check_equal_bits(make_booms(hub, base, kCrossed, kTable), method, 40);
}

TEST_CASE("nodes of bearings declare what they read and write") {
  for (const Formulation formulation : formulations())
    for (const Method& method : {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})})
      check_step_declarations(make_booms(kTurningAxle, "mount", kCrossed, kTable), formulation,
                              method);
}

TEST_CASE(
    "rigid bearings, and those with springs alone, keep momentum and energy by the method's "
    "order") {
  const std::string tie = ", stiffness=[[40,15],[15,30]]";
  check_conservation(make_booms(kFlyingHub, "hub", tie, ", stiffness=300"), 0.1, 2e-4);
  check_conservation(make_booms(kFlyingHub, "hub", "", ", stiffness=[[300,-90],[-90,200]]"), 0.1,
                     1e-4);
  check_conservation(make_booms(kFlyingHub, "hub", tie, ", stiffness=[[300,-90],[-90,0]]"), 0.1,
                     2e-4);
}

TEST_CASE("cross-coupled bearings and tables change the energy by what is counted of them") {
  for (const auto& [hub, base] : {std::pair(kTurningAxle, "mount"), std::pair(kFlyingHub, "hub")}) {
    const System<Space> system = make_booms(hub, base, kCrossed, kTable);
    const auto residual = [&](const Method& method) {
      Run<Space> run(system, {method});
      const double before = calc_energy(run);
      run.advance_for(0.1);
      CHECK(std::abs(run.dissipated) > 1e-4);
      return std::abs(calc_energy(run) - before - run.work + run.dissipated);
    };
    CHECK(residual(Rk4{2e-4}) / residual(Rk4{1e-4}) > 11.0);
    CHECK(residual(make_generalized_alpha(0.9, 2e-4)) /
              residual(make_generalized_alpha(0.9, 1e-4)) >
          3.3);
  }
}

TEST_CASE("a rigid bearing keeps its place on a line, and leaves all else") {
  for (const Formulation formulation : formulations())
    for (const Method& method : {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{2e-4})}) {
      Run<Space> run(make_booms(kTurningAxle, "mount", "", kCrossed),
                     {.method = method, .formulation = formulation});
      CHECK(run.context.loop_start.freedoms[0].rows == 2);
      CHECK(run.context.loop_start.freedoms[0].independent == 2);
      run.advance(200);
      const double step = std::holds_alternative<Rk4>(method) ? 2e-4 : 5e-4;
      const LoopModel& tie = run.context.system.subsystems[0].loops[0];
      const auto motion = [&](const LoopPlaceModel& place) {
        return calc_place_motion(run.context.system, 0, place, 200 * step, run.context.data);
      };
      const PlaceMotion from = motion(tie.from), to = motion(tie.to);
      const space::Position r = to.R.inverse() * space::Position(from.p - to.p);
      const space::Position axis = space::Position(0.2, 1.0, 0.1).normalized();
      CHECK(space::Position(r - axis.dot(r) * axis).norm() < 1e-12);
      CHECK(std::abs(axis.dot(r)) > 1e-4);
    }
}

TEST_CASE("matrices that are zero, or damp alone, hold nothing at the start and give no force") {
  for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-3})}) {
    Run<Space> loose(make_system(parse_model(make_sliding_mass(matrix_key("stiffness", 0, 0, 0, 0),
                                                               {0.1, 0.2}, {3.0, 4.0}))),
                     {method});
    CHECK(loose.context.loop_start.moves.empty());
    loose.advance(100);
    CHECK(std::abs(slide_of(loose, 0).q[0] - 0.4) < 1e-12);
    CHECK(std::abs(slide_of(loose, 1).q[0] - 0.6) < 1e-12);
    Run<Space> damped(make_system(parse_model(make_sliding_mass(matrix_key("damping", 80, 0, 0, 0),
                                                                {0.0, 0.0}, {3.0, 4.0}))),
                      {method});
    damped.advance(100);
    CHECK(std::abs(slide_of(damped, 0).v[0] / 3.0 - std::exp(-0.2)) < 1e-6);
    CHECK(std::abs(slide_of(damped, 1).v[0] - 4.0) < 1e-12);
    CHECK(std::abs(damped.dissipated - 20.0 * 9.0 * (1.0 - std::exp(-0.4))) < 1e-3);
  }
}
