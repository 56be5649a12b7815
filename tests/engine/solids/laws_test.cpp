// What holds of any solids in trees: formulations, executors, momentum, energy, declared accesses.

#include <doctest/doctest.h>

#include <cmath>

#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/engine/step/step_declarations.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

/// The methods, with steps for soft solids.
std::vector<Method> methods() {
  return {Method(make_generalized_alpha(0.8, 5e-4)), Method(Rk4{8e-5})};
}

}  // namespace

TEST_CASE("three formulations move solids alike") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const Method& method : methods()) {
      const System<Space> system = make_system(make_solid_trees(support));
      const auto structured = check_formulations(system, method, 100, 1e-9);
      CHECK(deformations(*structured).cwiseAbs().maxCoeff() > 1e-4);
    }
}

TEST_CASE("solids have equal bits on executors, threads and windows") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const Method& method : methods()) {
      spatial::Model model = make_solid_trees(support);
      if (support == HubSupport::axle) model.hub.drive = ConstantSpeed{2.0};
      check_equal_bits(make_system(model), method, 40);
    }
}

TEST_CASE("a free model with solids keeps momentum and energy by the method's order") {
  spatial::Model model = make_solid_trees(HubSupport::free);
  model.hub.angular_velocity = Vector(2.0, -1.5, 7.0);
  const System<Space> system = make_system(model);
  check_conservation(system, 0.08, 1.6e-4);
}

namespace {

/// Trees of solids under gravity and loads that rise within `ramp` [s].
spatial::Model make_loaded_trees(double ramp) {
  spatial::Model model = make_solid_trees(HubSupport::axle);
  model.hub.drive = TorqueDrive{Curve(20.0), 1.0};
  model.gravity = Vector(0.5, -1.0, -9.81);
  model.gravity_ramp = ramp;
  std::get<spatial::SolidBody>(model.subsystems[0].bodies[0].shape).damping = {0.02};
  for (const spatial::LoadFrame frame :
       {spatial::LoadFrame::inertial, spatial::LoadFrame::hub, spatial::LoadFrame::body}) {
    spatial::PointLoad load;
    load.place.subsystem = "tree";
    load.place.body = "arm";
    load.interface = "tip";
    load.frame = frame;
    load.ramp = ramp;
    load.force = Vector(30.0, 8.0, -6.0);
    load.moment = Vector(0.2, -0.4, 0.3);
    model.loads.push_back(load);
    load.place.body = "outer";
    load.interface = "";
    load.nodes = spatial::NodeChoice("Z1");
    model.loads.push_back(load);
    load.place.subsystem = "pair";
    load.place.body = "flying";
    load.nodes.reset();
    load.interface = "tip";
    model.loads.push_back(load);
  }
  return model;
}

}  // namespace

TEST_CASE("what acts on solids changes the energy by its work") {
  const auto residual = [](const Method& method, double ramp) {
    Run<Space> run(make_system(make_loaded_trees(ramp)), {method});
    const double before = calc_energy(run);
    run.advance_for(0.04);
    CHECK(std::abs(run.work) > 0.01);
    CHECK(run.dissipated > 1e-5);
    return std::abs(calc_energy(run) - before - run.work + run.dissipated);
  };
  CHECK(residual(Rk4{8e-5}, 0.0) / residual(Rk4{4e-5}, 0.0) > 11.0);
  // Sudden loads excite modes too fast for these steps.
  CHECK(residual(make_generalized_alpha(0.9, 4e-4), 0.03) /
            residual(make_generalized_alpha(0.9, 2e-4), 0.03) >
        3.3);
}

TEST_CASE("a flight with solids does not depend on the velocity of its observer") {
  const auto fly = [](const Vector& velocity) {
    spatial::Model model = make_solid_trees(HubSupport::free);
    model.hub.velocity = velocity;
    Run<Space> run(make_system(model), {Rk4{1e-4}});
    run.advance(200);
    return deformations(run);
  };
  const Eigen::VectorXd at_rest = fly(Vector::Zero());
  CHECK((fly(Vector(30.0, 0.0, 10.0)) - at_rest).cwiseAbs().maxCoeff() <
        1e-10 * at_rest.cwiseAbs().maxCoeff());
}

TEST_CASE("the nodes of solids declare what they read and write") {
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const bool is_driven : {false, true})
      for (const Formulation formulation : formulations())
        for (const Method& method : methods()) {
          if (is_driven && support == HubSupport::free) continue;
          spatial::Model model = make_solid_trees(support);
          if (is_driven) model.hub.drive = ConstantSpeed{2.0};
          check_step_declarations(make_system(model), formulation, method);
        }
}
