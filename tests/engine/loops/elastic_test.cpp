// Elastic mechanisms: a slider-crank in space, a propped blade in the plane.

#include <doctest/doctest.h>

#include <cmath>

#include "engine/bodies/kernels/kinematics.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/step/step_graph_builder.h"
#include "graph/declaration_check.h"
#include "models/rotor.h"
#include "tests/engine/bodies/space/system/runs.h"
#include "tests/engine/loops/mechanisms.h"
#include "tests/engine/step/damaged_graph.h"

using namespace spoke;
using namespace spoke::test;
using spatial::Vector;

namespace {

/// The slider-crank of Simeon 1996 with an elastic coupler: the crank turns at 150 rad/s.
spatial::Model make_slider_crank(int bodies, int elements) {
  spatial::Model model;
  model.hub.drive = FixedDrive{};
  spatial::Subsystem s{"slider_crank", {}, {}, {}};
  s.bodies.push_back(make_rod("crank", 0.36, 0.15));
  s.joints.push_back(make_hinge("hub", "crank", Vector::Zero(), 0.0));
  s.joints.back().joint.coordinates[0].motion =
      spatial::MotionTable{Curve({0.0, 0.1, 0.2}, {0.0, 15.0, 30.0})};
  spatial::Beam coupler;
  coupler.length = 0.3;
  coupler.bodies = bodies;
  coupler.elements = elements;
  coupler.reference_frame = ReferenceFrame::chord;
  coupler.geometric_stiffening = false;
  const double area = 0.008 * 0.008, second = area * area / 12.0, modulus = 2e11;
  const auto along = [](double value) { return std::vector<double>{value, value}; };
  coupler.sections.station = {0.0, 0.3};
  coupler.sections.mass_per_length = along(7870.0 * area);
  coupler.sections.axial_stiffness = along(modulus * area);
  coupler.sections.lag_stiffness = coupler.sections.flap_stiffness = along(modulus * second);
  coupler.sections.torsion_stiffness = along(0.4 * modulus * second);
  coupler.sections.flap_inertia = coupler.sections.lag_inertia = along(7870.0 * second);
  s.bodies.push_back({"coupler", coupler});
  s.joints.push_back(make_hinge("crank", "coupler", Vector(0.15, 0.0, 0.0), 0.0, -225.0));
  spatial::RigidBody slider;
  slider.mass = 0.075552;
  slider.inertia = 1e-5 * Eigen::Matrix3d::Identity();
  s.bodies.push_back({"slider", slider});
  spatial::SubsystemJoint guide =
      make_hinge("hub", "slider", Vector(0.45, 0.0, 0.0), 0.0, 0.0, Vector::UnitX());
  guide.joint.kind = spatial::JointKind::prismatic;
  s.joints.push_back(guide);
  Loop pin;
  pin.name = "pin";
  pin.kind = LoopKind::revolute;
  pin.from.name = "coupler";
  pin.from.station = 0.3;
  pin.to.name = "slider";
  pin.axes[0] = Vector::UnitZ();
  s.loops.push_back(pin);
  model.subsystems.push_back(s);
  return model;
}

/// A blade of two bodies whose tip slides along a line that turns with the hub.
Rotor make_propped_blade() {
  Rotor rotor;
  rotor.hub.radius = 0.5;
  rotor.hub.inertia = 1.0;
  rotor.hub.mass = 1.0;
  rotor.hub.drive = SpeedTable{Curve({0.0, 100.0}, {0.0, 10.0})};  // alpha = 0.1 rad/s^2
  Blade blade;
  blade.length = 2.0;
  blade.bodies = 2;
  blade.elements = 4;
  blade.density = 1000.0;
  blade.area = 1e-3;
  blade.second_moment = 1e-7;
  blade.youngs_modulus = 7e10;
  blade.geometric_stiffening = false;
  Loop prop;
  prop.name = "prop";
  prop.kind = LoopKind::prismatic;
  prop.from.station = 2.0;
  prop.to.carrier = LoopPlace::Carrier::hub;
  prop.to.point = Vector(2.5, 0.0, 0.0);
  prop.axes[0] = Vector::UnitX();
  blade.loops.push_back(prop);
  rotor.blades.push_back(blade);
  rotor.damping.stiffness_factor = 2e-3;
  return rotor;
}

}  // namespace

TEST_CASE("a slider-crank with an elastic coupler: angle, stroke and deflection as published") {
  // Test Set for IVP Solvers, t = 0.1 s, four Ritz modes: the coupler's angle, the slider's place,
  // and the amplitude of its first bending mode, sin(pi x/L), which is the deflection at the
  // middle.
  constexpr double kAngle = -0.3311734988, kPlace = 0.1697373328, kDeflection = 1.8932e-4;
  Run<Space> run(make_system(make_slider_crank(1, 4)), {make_generalized_alpha(0.6, 2e-5)});
  run.advance_for(0.1);
  SubsystemData<Space>& data = run.context.data.subsystems[0];
  calc_poses(run.context.system.subsystems[0], data, data.poses);
  CHECK(data.loops.report.opening < 1e-12);
  CHECK(data.bodies[2].joint.coordinates.q[0] + 0.45 == doctest::Approx(kPlace).epsilon(1e-4));
  const space::Position along = data.poses[1].R.axes.col(0);
  CHECK(std::atan2(along.y(), along.x()) == doctest::Approx(kAngle).epsilon(1e-4));
  const space::FlexibleBody& coupler = *run.context.system.subsystems[0].bodies[1].body->flexible();
  const double middle = data.bodies[1].coordinates.q[coupler.coordinate(2, 1)];
  CHECK(std::abs(middle) == doctest::Approx(kDeflection).epsilon(0.1));
}

TEST_CASE(
    "a blade in the plane that turns is held at its tip by the hub: it bears what it should") {
  // A beam clamped at the root and guided at the tip, which cannot turn, under the load of its
  // spin-up, m alpha (r + x): R = m alpha (r L/2 + 7/20 L^2).
  const Rotor rotor = make_propped_blade();
  for (const Formulation formulation : formulations()) {
    Run<Plane> run(make_system(rotor),
                   {.method = make_generalized_alpha(0.5, 1e-3), .formulation = formulation});
    run.advance_for(1.0);
    const LoopData<Plane>& loops = run.context.data.subsystems[0].loops;
    CHECK(loops.report.opening < 1e-12);
    const double expected = 0.1 * 1.0 * (0.5 * 2.0 / 2.0 + 7.0 / 20.0 * 4.0);
    CHECK(std::abs(loops.kept_multipliers[0]) == doctest::Approx(expected).epsilon(2e-3));
  }
}

TEST_CASE("the nodes of loops in the plane declare what they read and write") {
  for (const bool is_coupled : {false, true})
    for (const Formulation formulation : formulations())
      for (const Method& method : {Method(make_generalized_alpha(0.8, 1e-3)), Method(Rk4{1e-5})}) {
        Rotor rotor = make_propped_blade();
        if (is_coupled) rotor.hub.drive = FreeDrive{2.0};
        SystemContext<Plane> context;
        context.system = make_system(rotor);
        context.formulation = formulation;
        context.integrator = {method, {1e-10, 0, 50}};
        allocate(context);
        const graph::StepGraph graph = build_step_graph(context, 1);
        for (const int stage : {0, 1, -1}) {
          set_progress({0.1, stage, method.index() == 0 && stage >= 0}, context);
          for (const graph::DeclarationFault& fault : graph::check_declarations(graph))
            FAIL_CHECK(fault.message);
        }
      }
}
