#include "tests/engine/rotors.h"

#include <numbers>

#include "engine/bodies/kernels/hub_motion.h"
#include "engine/bodies/kernels/hub_solve.h"
#include "engine/bodies/kernels/kinematics.h"
#include "engine/step/step_graph_builder.h"
#include "graph/executor.h"

namespace spoke::test {

Blade wu_haug_blade(int bodies, int elements) {
  Blade blade;
  blade.length = 8.0;
  blade.bodies = bodies;
  blade.elements = elements;
  blade.density = 2766.67;
  blade.area = 7.299e-5;
  blade.second_moment = 8.214e-9;
  blade.youngs_modulus = 6.895e10;
  return blade;
}

Rotor make_rotor(const Blade& blade, int count) {
  Rotor rotor;
  for (int i = 0; i < count; ++i) {
    rotor.blades.push_back(blade);
    rotor.blades.back().azimuth = 2.0 * std::numbers::pi * i / count;
  }
  rotor.hub.drive = SpinUp{4.0, 15.0};
  return rotor;
}

Scenario spin_up_scenario(const Blade& blade, double step) {
  Scenario scenario;
  scenario.rotor = make_rotor(blade, 3);
  scenario.integration.duration = 20.0;
  scenario.integration.step = step;
  return scenario;
}

Scenario unequal_scenario(HubSupport support, IntegrationMethod method) {
  Scenario scenario = spin_up_scenario(wu_haug_blade(2, 3), 0.01);
  Rotor& rotor = scenario.rotor;
  rotor.blades[0].strain = BeamStrain::nonlinear;
  rotor.blades[1].bodies = 3;
  rotor.blades[1].length = 5.0;
  rotor.blades[2].geometric_stiffening = false;
  rotor.gravity = Position{0.0, -9.81};
  rotor.hub.inertia = 2.0;
  if (support == HubSupport::free) {
    rotor.hub.support = support;
    rotor.hub.mass = 10.0;
    rotor.hub.drive = TorqueDrive{Curve(30.0)};
  }
  scenario.integration.method = method;
  if (method == IntegrationMethod::rk4) scenario.integration.step = 5e-5;
  scenario.integration.duration = 200 * scenario.integration.step;
  return scenario;
}

Rotor make_random_rotor(const RandomRotor& kind, std::mt19937& random) {
  std::uniform_real_distribution<double> factor(0.5, 2.0);
  std::uniform_int_distribution<int> number(1, 4);
  Rotor rotor;
  const int blades = number(random);
  for (int i = 0; i < blades; ++i) {
    Blade blade = wu_haug_blade(number(random), kind.elements);
    blade.length *= factor(random);
    blade.density *= factor(random);
    blade.area *= factor(random);
    blade.second_moment *= factor(random);
    blade.youngs_modulus *= factor(random);
    const int stiffening = number(random);
    blade.geometric_stiffening = stiffening % 2 == 0;
    if (stiffening == 4) blade.strain = BeamStrain::nonlinear;
    blade.reference_frame =
        number(random) % 2 == 0 ? ReferenceFrame::clamped : ReferenceFrame::chord;
    blade.azimuth = 2.0 * std::numbers::pi * i / blades + factor(random);
    rotor.blades.push_back(blade);
  }
  rotor.hub.support = kind.support;
  rotor.hub.radius = 0.3 * factor(random);
  rotor.hub.mass = 4.0 * factor(random);
  rotor.hub.inertia = 2.0 * factor(random);
  if (kind.is_driven)
    rotor.hub.drive = SpinUp{4.0, 15.0};
  else
    rotor.hub.drive = TorqueDrive{Curve(3.0 * factor(random)), 2.0};
  rotor.gravity = Position{1.0, -9.81};
  rotor.damping = {0.05, 1e-5};
  return rotor;
}

void add_all_loads(Rotor& rotor) {
  const Curve factor({-1.0, 2.0}, {0.3, 1.0});
  for (const LoadFrame frame : {LoadFrame::inertial, LoadFrame::hub, LoadFrame::section}) {
    PointLoad point;
    point.position = 0.83;
    point.frame = frame;
    point.force = {0.1, 0.2};
    point.moment = 0.03;
    point.factor = factor;
    rotor.loads.push_back(point);
    DistributedLoad distributed;
    distributed.from = 0.17;
    distributed.frame = frame;
    distributed.force_per_length = {0.05, -0.1};
    distributed.moment_per_length = 0.02;
    distributed.ramp = 1.5;
    rotor.distributed_loads.push_back(distributed);
    if (frame == LoadFrame::section) continue;
    HubLoad hub;
    hub.position = {0.1, 0.2};
    hub.frame = frame;
    hub.force = {0.3, -0.4};
    hub.torque = 0.2;
    hub.factor = factor;
    rotor.hub_loads.push_back(hub);
  }
  for (const DragFrame frame : {DragFrame::inertial, DragFrame::hub}) {
    Drag drag;
    drag.relative_to = frame;
    drag.linear = 0.02;
    drag.quadratic = 0.01;
    drag.to = 0.91;
    drag.linear_per_length = 0.03;
    drag.quadratic_per_length = 0.02;
    drag.ramp = 2.0;
    rotor.drags.push_back(drag);
  }
  rotor.gravity_ramp = 1.2;
}

void randomize_state(std::mt19937& random, SystemContext<Plane>& context) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  StepData<Plane>& data = context.data;
  for (int c = 0; c < kTwist; ++c) {
    if (is_prescribed(context.system.hub, c)) continue;
    data.hub_coordinates.q[c] = 3.0 * unit(random);
    data.hub_coordinates.v[c] = 3.0 * unit(random);
  }
  for (SubsystemData<Plane>& subsystem : data.subsystems)
    for (BodyData<Plane>& member : subsystem.bodies) {
      const plane::FlexibleBody& body = *member.model->body;
      const double bend = 0.05 * unit(random), bend_rate = 0.5 * unit(random);
      const double stretch = 1e-5 * unit(random), stretch_rate = 1e-3 * unit(random);
      for (int node = 0; node <= body.elements; ++node) {
        const double x = static_cast<double>(node) / body.elements;
        const auto set = [&](int component, double q, double v) {
          const int index = body.coordinate(node, component);
          if (index < 0) return;
          member.coordinates.q[member.layout.offset(index)] = q * (1 + 0.1 * unit(random));
          member.coordinates.v[member.layout.offset(index)] = v * (1 + 0.1 * unit(random));
        };
        set(0, stretch * x, stretch_rate * x);
        set(1, bend * x * x, bend_rate * x * x);
        set(2, 2 * bend * x / body.length, 2 * bend_rate * x / body.length);
      }
    }
}

Eigen::VectorXd unpadded(const double* flex, const plane::FlexLayout& layout) {
  Eigen::VectorXd values(layout.axial + layout.bending);
  for (int k = 0; k < values.size(); ++k) values[k] = flex[layout.offset(k)];
  return values;
}

void start_progress(const PassControl& control, StepData<Plane>& data) {
  for (StepProgress& progress : data.progress) {
    progress = StepProgress{};
    progress.control = control;
  }
}

namespace {

/// Returns the reaction of the hub at the state evaluated last, at which no step has ended.
Twist hub_reaction(double t, const SystemContext<Plane>& context) {
  if (context.data.is_coupled) return context.data.hub_solution.reaction;
  const Hub& hub = context.system.hub;
  Twist sum = Twist(hub.mass, hub.mass, hub.inertia)
                  .cwiseProduct(calc_prescribed_motion(context.system, t).acceleration);
  for (const SubsystemData<Plane>& subsystem : context.data.subsystems)
    sum += calc_reaction(subsystem);
  return sum - calc_hub_load(context.system, t, *context.data.subsystems[0].hub);
}

}  // namespace

Evaluation evaluate(double t, SystemContext<Plane>& context, bool implicit) {
  const graph::StepGraph graph = build_step_graph(context);
  StepData<Plane>& data = context.data;
  start_progress({t, PassControl::kEvaluateOnly, implicit}, data);
  if (std::holds_alternative<GeneralizedAlpha>(context.integrator.method))
    for (SubsystemData<Plane>& subsystem : data.subsystems)
      for (BodyData<Plane>& body : subsystem.bodies) hold(body.coordinates);
  graph::make_executor(graph, graph::ExecutorKind::serial)->run();
  impose_hub_motion(context.system, t, data.hub_coordinates);
  std::vector<double> accelerations(data.hub_coordinates.a, data.hub_coordinates.a + kTwist);
  std::vector<double> wrenches;
  for (const SubsystemData<Plane>& subsystem : data.subsystems)
    for (std::size_t j = 0; j < subsystem.bodies.size(); ++j) {
      const BodyData<Plane>& body = subsystem.bodies[j];
      const Eigen::VectorXd a = unpadded(body.coordinates.a, body.layout);
      accelerations.insert(accelerations.end(), body.X.begin(), body.X.end());
      accelerations.insert(accelerations.end(), a.begin(), a.end());
      wrenches.insert(wrenches.end(), subsystem.wrenches[j].inboard.begin(),
                      subsystem.wrenches[j].inboard.end());
    }
  return {Eigen::Map<Eigen::VectorXd>(accelerations.data(), accelerations.size()),
          Eigen::Map<Eigen::VectorXd>(wrenches.data(), wrenches.size()), hub_reaction(t, context)};
}

void make_context(const Rotor& rotor, Formulation formulation, const Method& method,
                  SystemContext<Plane>& context) {
  context.system = make_system(rotor);
  context.formulation = formulation;
  context.integrator.method = method;
  allocate(context);
}

void copy_state(const SystemContext<Plane>& from, SystemContext<Plane>& to) {
  const auto copy = [](const CoordinateBlock& a, CoordinateBlock& b) {
    std::copy_n(a.q, a.size, b.q);
    std::copy_n(a.v, a.size, b.v);
  };
  copy(from.data.hub_coordinates, to.data.hub_coordinates);
  for (std::size_t i = 0; i < from.data.subsystems.size(); ++i)
    for (std::size_t j = 0; j < from.data.subsystems[i].bodies.size(); ++j)
      copy(from.data.subsystems[i].bodies[j].coordinates,
           to.data.subsystems[i].bodies[j].coordinates);
}

}  // namespace spoke::test
