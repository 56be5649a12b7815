// The three formulations find the same accelerations, wrenches and motions of trees in space.

#include <doctest/doctest.h>

#include "engine/step/step_graph_builder.h"
#include "graph/executor.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/bodies/space/system/random_system.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/relative_difference.h"

using namespace spoke;
using namespace spoke::test;

namespace {

/// All that one evaluation finds.
struct Evaluation {
  Eigen::VectorXd accelerations;  ///< of frames, deformations, joints and the hub
  Eigen::VectorXd wrenches;       ///< on inboard handles, and of support and drive on the hub
  double drive_power = 0.0;       ///< of all joints
};

class Values {
 public:
  void add(const double* values, int n) { values_.insert(values_.end(), values, values + n); }
  void add(const space::Twist& v) { add(v.data(), space::kTwist); }
  Eigen::VectorXd vector() const {
    return Eigen::Map<const Eigen::VectorXd>(values_.data(),
                                             static_cast<Eigen::Index>(values_.size()));
  }

 private:
  std::vector<double> values_;
};

Evaluation take(const StepData<Space>& data) {
  Evaluation found;
  Values accelerations, wrenches;
  accelerations.add(data.hub_solution.acceleration);
  wrenches.add(data.hub_solution.reaction);
  for (const SubsystemData<Space>& subsystem : data.subsystems)
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
      const BodyData<Space>& body = subsystem.bodies[j];
      accelerations.add(body.X);
      accelerations.add(body.a_found, body.coordinates.size);
      accelerations.add(body.joint.a_found, body.joint.coordinates.size);
      wrenches.add(subsystem.wrenches[j].inboard);
      found.drive_power += body.report.drive_power;
    }
  found.accelerations = accelerations.vector();
  found.wrenches = wrenches.vector();
  return found;
}

/// One evaluation of a state that `seed` draws.
Evaluation evaluate(const System<Space>& system, const Method& method, Formulation formulation,
                    unsigned seed) {
  SystemContext<Space> context;
  context.system = system;
  context.formulation = formulation;
  context.integrator.method = method;
  context.loads_tie_subsystems = true;  // so that all solve for the hub's reaction
  allocate(context);
  std::mt19937 random(seed);
  randomize_state(random, context.data);
  const graph::StepGraph graph = build_step_graph(context);
  const bool is_implicit = std::holds_alternative<GeneralizedAlpha>(method);
  context.data.progress[0] = {};
  context.data.progress[0].control = {0.4, PassControl::kEvaluateOnly, is_implicit};
  graph::make_executor(graph, graph::ExecutorKind::serial)->run();
  return take(context.data);
}

void check_equal(const Evaluation& found, const Evaluation& expected) {
  REQUIRE(found.accelerations.allFinite());
  CHECK(relative_difference(found.accelerations, expected.accelerations) < 1e-9);
  CHECK(relative_difference(found.wrenches, expected.wrenches) < 1e-9);
  CHECK(std::abs(found.drive_power - expected.drive_power) <
        1e-9 * expected.wrenches.lpNorm<Eigen::Infinity>());
}

constexpr Formulation kDense[] = {Formulation::subsystem, Formulation::augmented};

}  // namespace

TEST_CASE("the formulations agree in every acceleration and wrench of random trees in space") {
  std::mt19937 random(20170942);
  const Method methods[] = {Rk4{1e-5}, make_generalized_alpha(0.8, 0.01)};
  for (const HubSupport support : {HubSupport::axle, HubSupport::free})
    for (const bool is_driven : {true, false})
      for (unsigned round = 0; round < 4; ++round) {
        const System<Space> system = make_random_system({support, is_driven}, random);
        for (const Method& method : methods) {
          const Evaluation structured = evaluate(system, method, Formulation::structured, round);
          for (const Formulation formulation : kDense) {
            CAPTURE(name_of(formulation));
            CAPTURE(is_driven);
            CAPTURE(static_cast<int>(support));
            check_equal(evaluate(system, method, formulation, round), structured);
          }
        }
      }
}

TEST_CASE("runs by the formulations agree in space") {
  const std::pair<const char*, std::string> models[] = {
      {"blades, driven", make_text(kDrivenHub, kBooms + kHinges + kPitch, kRisingGravity)},
      {"blades, turned", make_text(kTurnedHub, kBooms + kHinges, kGravity)},
      {"tree, free", make_text(kFlyingHub, kTree + kMotors, kGravity)},
      {"forest, turned", make_text(kTurnedHub, kForest + kMotors, kGravity)},
      {"trees, driven", make_text(kDrivenHub, kMotors + kTree + kForest, kRisingGravity)}};
  for (const auto& model : models)
    for (const Method& method : {Method{Rk4{1e-4}}, Method{make_generalized_alpha(0.8, 2e-3)}}) {
      CAPTURE(model.first);
      const System<Space> system = make_system(parse_model(model.second));
      Run<Space> structured(system, {method, 1e-12});
      structured.advance(30);
      for (const Formulation formulation : kDense) {
        CAPTURE(name_of(formulation));
        RunSetup setup{method, 1e-12};
        setup.formulation = formulation;
        Run<Space> run(system, setup);
        run.advance(30);
        CHECK(relative_difference(deformations(run), deformations(structured)) < 1e-9);
        CHECK((run.trace.back() - structured.trace.back()).cwiseAbs().maxCoeff() < 1e-9);
        const SystemRecord<Space>&found = run.record(), &expected = structured.record();
        CHECK((found.position - expected.position).norm() < 1e-9);
        CHECK((found.velocity - expected.velocity).norm() < 1e-9);
        // By beta h^2, the tolerance of the iteration leaves that much of the accelerations.
        CHECK((found.reaction - expected.reaction).norm() < 1e-4);
        CHECK(run.work == doctest::Approx(structured.work).epsilon(1e-9));
        CHECK(run.dissipated == doctest::Approx(structured.dissipated).epsilon(1e-9));
        CHECK(calc_energy(run) == doctest::Approx(calc_energy(structured)).epsilon(1e-9));
      }
    }
}
