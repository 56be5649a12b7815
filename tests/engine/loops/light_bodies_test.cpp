// Bodies that have next to no inertia about their centres of mass: their joints, not they, keep
// them from spinning, and no formulation may lose digits over it.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/step/step_graph_builder.h"
#include "graph/executor.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/relative_difference.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr double kInertias[] = {1e-12, 1e-9, 1e-8, 1e-6, 1e-3, 1.0};
constexpr double kAngle = 1.0471975512, kSpeed = 8.0, kGravity = 9.81;
constexpr double kArm = 3.0, kCentre = 0.5, kCollar = 2.0;  // masses [kg], length [m]

/// A governor: two arms of point masses on a hub that turns, whose rods carry a collar.
std::string make_governor(double inertia) {
  const std::string arm =
      ", kind='rigid', mass=3, center=[0.5,0,0], inertia=" + std::to_string(inertia * 1e12) +
      "e-12 }";
  const std::string joint = ", kind='revolute', axis=[0,1,0], offset=[0,0,1], initial=1.0471975512";
  return "world='space'\n"
         "[hub]\ninertia=1.0\n[hub.drive]\nkind='constant'\nspeed=8.0\n"
         "[gravity]\nacceleration=[0,0,-9.81]\n"
         "[[subsystem]]\nname='g'\n"
         "body=[ { name='collar', kind='rigid', mass=2, inertia=0.01 }, { name='arm1'" +
         arm + ", { name='arm2'" + arm +
         " ]\n"
         "joint=[ { name='s', parent='hub', child='collar', kind='prismatic', axis=[0,0,1],"
         " offset=[0,0,0.5669873] }, { name='a1', parent='hub', child='arm1'" +
         joint + " }, { name='a2', parent='hub', child='arm2'" + joint +
         ", orientation=[0,0,3.14159265358979] } ]\n"
         "loop=[ { name='r1', kind='distance', from={ body='arm1', point=[0.25,0,0] },"
         " to={ body='collar' }, length=0.25 }, { name='r2', kind='distance',"
         " from={ body='arm2', point=[0.25,0,0] }, to={ body='collar' }, length=0.25 } ]\n"
         "[integration]\nstep=2e-3\nduration=1\n";
}

/// Three such arms in a row, on a free hub.
std::string make_chain(double inertia) {
  std::string bodies, joints, parent = "hub";
  for (const char* name : {"a", "b", "c"}) {
    const std::string separator = bodies.empty() ? "" : ", ";
    bodies +=
        separator + "{ name='" + name +
        "', kind='rigid', mass=3, center=[0.5,0,0], inertia=" + std::to_string(inertia * 1e12) +
        "e-12 }";
    joints += separator + "{ parent='" + parent + "', child='" + name +
              "', kind='universal', axes=[[0,1,0],[0,0,1]], offset=[" +
              (parent == "hub" ? "0" : "1") + ",0,0], initial=[0.5,0.3], initial_speed=[1,-2] }";
    parent = name;
  }
  return "world='space'\n[hub]\nsupport='free'\nmass=5\ninertia=1.0\n"
         "[gravity]\nacceleration=[0,0,-9.81]\n[[subsystem]]\nname='g'\nbody=[" +
         bodies + "]\njoint=[" + joints + "]\n[integration]\nstep=1e-3\nduration=1\n";
}

/// The accelerations of all joints at the start.
Eigen::VectorXd find_accelerations(const std::string& text, Formulation formulation) {
  SystemContext<Space> context;
  context.system = make_system(parse_model(text));
  context.formulation = formulation;
  context.integrator.method = Rk4{1e-3};
  allocate(context);
  const graph::StepGraph graph = build_step_graph(context);
  context.data.progress[0].control = {0.0, PassControl::kEvaluateOnly, false};
  graph::make_executor(graph, graph::ExecutorKind::serial)->run();
  std::vector<double> values;
  for (const BodyData<Space>& body : context.data.subsystems[0].bodies)
    values.insert(values.end(), body.joint.a_found,
                  body.joint.a_found + body.joint.coordinates.size);
  return Eigen::Map<Eigen::VectorXd>(values.data(), std::ssize(values));
}

/// The arms' angular acceleration at the start by Lagrange's equation, with the collar at
/// 1 - sin(angle)/2: (2 m r^2 + 2 I + M cos^2/4) q'' = ((2 m r + M/2) g - 2 m r^2 w^2 sin) cos.
double find_exact(double inertia) {
  const double s = std::sin(kAngle), c = std::cos(kAngle), r = kCentre;
  const double mass = 2.0 * (kArm * r * r + inertia) + 0.25 * kCollar * c * c;
  return c *
         (kGravity * (2.0 * kArm * r + 0.5 * kCollar) - 2.0 * kArm * r * r * kSpeed * kSpeed * s) /
         mass;
}

}  // namespace

TEST_CASE("arms of point masses in a loop start as Lagrange's equation says") {
  for (const double inertia : kInertias) {
    CAPTURE(inertia);
    const std::string text = make_governor(inertia);
    const double exact = find_exact(inertia);
    for (const Formulation formulation : {Formulation::structured, Formulation::augmented}) {
      CAPTURE(name_of(formulation));
      const Eigen::VectorXd found = find_accelerations(text, formulation);
      REQUIRE(found.size() == 3);
      for (const Eigen::Index arm : {1, 2})
        CHECK(std::abs(found[arm] - exact) < 1e-8 * std::abs(exact));  // the collar is at 1e-8 m
    }
  }
}

TEST_CASE("the formulations agree however little bodies resist to spin, in loops and in trees") {
  for (const auto& make : {make_governor, make_chain})
    for (const double inertia : kInertias) {
      CAPTURE(inertia);
      const std::string text = make(inertia);
      const Eigen::VectorXd structured = find_accelerations(text, Formulation::structured);
      CHECK(relative_difference(structured, find_accelerations(text, Formulation::augmented)) <
            1e-10);
      // It inverts the bodies' masses, and loses what they have more about their joints.
      CHECK(relative_difference(structured, find_accelerations(text, Formulation::subsystem)) <
            1e-10 + 1e-13 * kArm * kCentre * kCentre / inertia);
    }
}

TEST_CASE("runs of light arms agree") {
  for (const auto& make : {make_governor, make_chain})
    for (const double inertia : {1e-12, 1e-8}) {
      CAPTURE(inertia);
      const System<Space> system = make_system(parse_model(make(inertia)));
      for (const Method& method : {Method{make_generalized_alpha(0.8, 1e-3)}, Method{Rk4{1e-3}}}) {
        RunSetup setup{method};
        Run<Space> structured(system, setup);
        setup.formulation = Formulation::augmented;
        Run<Space> augmented(system, setup);
        structured.advance(20);
        augmented.advance(20);
        CHECK(largest_difference(structured, augmented) < 1e-10);
      }
    }
}
