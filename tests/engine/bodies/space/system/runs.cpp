#include "tests/engine/bodies/space/system/runs.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/bodies/kernels/loops/loop_motion.h"
#include "engine/bodies/kernels/samples.h"
#include "engine/bodies/kernels/space/supported_rotor.h"
#include "engine/bodies/table/state_values.h"

namespace spoke::test {
namespace {

/// Kinetic energy of the hub itself [J].
double hub_kinetic(const space::Hub& hub, const space::Twist& twist) {
  return 0.5 * twist.dot(hub.inertia.matrix() * twist);
}

/// First moment of the hub's mass, in H [kg m].
space::Position hub_moment(const space::Hub& hub) {
  const space::Matrix3 rt = hub.inertia.rt();
  return {rt(2, 1), rt(0, 2), rt(1, 0)};
}

double time_of(const Run<Space>& run) {
  return static_cast<double>(run.steps()) * step_size(run.context.integrator);
}

/// Kinetic energy if the twist of the hub, or of what a support stands on, were greater by `more`,
/// all coordinates' velocities the same.
double kinetic_with(const space::Twist& more, Run<Space>& run) {
  StepData<Space>& data = run.context.data;
  const space::Twist kept = data.hub.twist;
  data.hub.twist += more;
  update_rotors(run.context.system, time_of(run), data);
  double sum = hub_kinetic(run.context.system.hub, data.hub.twist);
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    update_kinematics(run.context.system.subsystems[i], data.subsystems[i]);
    sum += calc_sample(run.context.system, i, data.subsystems[i]).kinetic;
  }
  data.hub.twist = kept;
  return sum;
}

}  // namespace

spatial::Model parse_model(const std::string& text) {
  return *parse_scenario(text, "test.toml").space;
}

Scenario read_model(const std::string& name, const Overrides& overrides) {
  return read_scenario(SPOKE_MODELS_DIR "/" + name, overrides);
}

template <class World>
Run<World>::Run(const System<World>& system, const RunSetup& setup) {
  context.system = system;
  context.formulation = setup.formulation;
  context.integrator = {setup.method, {setup.tolerance, 0, 50}};
  context.loop_limits.duration = 1.0;
  allocate(context, setup.window > 1 ? 2 * setup.window : 1);
  RunnerOptions options;
  options.executor = setup.executor;
  options.threads = setup.threads;
  options.window = setup.window;
  options.planned_steps = 1000;
  runner = std::make_unique<StepRunner>(context, options);
  REQUIRE(runner->start() == StepOutcome::done);
}

template <class World>
void Run<World>::advance(std::int64_t count) {
  const auto outcome = runner->advance_to(steps() + count, true, [this](std::int64_t step) {
    const StepRecord& done = of_step(context.data.records, step).step;
    work += done.work;
    dissipated += done.dissipated;
    Eigen::VectorXd all(
        static_cast<Eigen::Index>(World::kPosition * context.data.subsystems.size()));
    Eigen::Index next = 0;
    for (const SubsystemData<World>& subsystem : context.data.subsystems) {
      all.segment<World::kPosition>(next) = of_step(subsystem.samples, step).tip;
      next += World::kPosition;
    }
    trace.push_back(all);
  });
  REQUIRE(outcome == StepOutcome::done);
}

template <class World>
void Run<World>::advance_for(double seconds) {
  advance(std::llround(seconds / step_size(context.integrator)));
}

template <class World>
const SubsystemSample<World>& Run<World>::sample(std::size_t i) const {
  return of_step(context.data.subsystems[i].samples, steps());
}

template <class World>
const SystemRecord<World>& Run<World>::record() const {
  return of_step(context.data.records, steps());
}

template <class World>
std::uint64_t Run<World>::hash() const {
  return hash_state(context.data);
}

template class Run<Plane>;
template class Run<Space>;

double calc_energy(Run<Space>& run) {
  const System<Space>& system = run.context.system;
  StepData<Space>& data = run.context.data;
  const HubState<Space>& hub = system.rotors.empty() ? *data.subsystems[0].hub : data.hub;
  double sum = hub_kinetic(system.hub, hub.twist);
  if (system.gravity_ramp == 0.0)
    sum -= system.gravity.dot(system.hub.mass * hub.p + hub.R * hub_moment(system.hub));
  for (std::size_t i = 0; i < data.subsystems.size(); ++i) {
    update_loops(system, i, time_of(run), data);
    const SubsystemSample<Space> sample = calc_sample(system, i, data.subsystems[i]);
    sum += sample.kinetic + sample.strain - sample.gravity;
  }
  return sum;
}

space::Twist calc_momentum(Run<Space>& run) {
  space::Twist in_hub;
  for (int c = 0; c < space::kTwist; ++c) {
    const space::Twist unit = space::Twist::Unit(c);
    in_hub[c] = 0.5 * (kinetic_with(unit, run) - kinetic_with(-unit, run));
  }
  kinetic_with(space::Twist::Zero(), run);
  const HubState<Space>& hub = run.context.data.hub;
  const space::Position linear = hub.R * space::Position(spoke::linear(in_hub));
  const space::Angular angular = hub.R * space::Angular(spoke::angular(in_hub));
  return space::make_twist(linear, angular + cross(hub.p, linear));
}

Eigen::VectorXd deformations(const Run<Space>& run) {
  std::vector<double> all;
  for (const SubsystemData<Space>& subsystem : run.context.data.subsystems)
    for (const BodyData<Space>& body : subsystem.bodies)
      for (const CoordinateBlock* block : {&body.joint.coordinates, &body.coordinates})
        all.insert(all.end(), block->q, block->q + block->size);
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

double largest_difference(const Run<Space>& a, const Run<Space>& b) {
  return (deformations(a) - deformations(b)).cwiseAbs().maxCoeff();
}

std::unique_ptr<Run<Space>> check_formulations(const System<Space>& system, const Method& method,
                                               std::int64_t steps, double tolerance) {
  const auto run = [&](Formulation formulation) {
    CAPTURE(name_of(formulation));
    auto made = std::make_unique<Run<Space>>(
        system, RunSetup{.method = method, .formulation = formulation});
    made->advance(steps);
    return made;
  };
  auto structured = run(Formulation::structured);
  CHECK(largest_difference(*structured, *run(Formulation::subsystem)) < tolerance);
  CHECK(largest_difference(*structured, *run(Formulation::augmented)) < tolerance);
  return structured;
}

void check_equal_bits(const System<Space>& system, const Method& method, std::int64_t steps) {
  const auto hash = [&](graph::ExecutorKind executor, int threads, int window) {
    Run<Space> run(system, {.method = method,
                            .executor = executor,
                            .threads = graph::Threads{threads},
                            .window = window});
    run.advance(steps);
    return run.hash();
  };
  const std::uint64_t serial = hash(graph::ExecutorKind::serial, 1, 1);
  CHECK(hash(graph::ExecutorKind::flow_graph, 2, 1) == serial);
  CHECK(hash(graph::ExecutorKind::flow_graph, 3, 8) == serial);
  CHECK(hash(graph::ExecutorKind::openmp_scheme1, 2, 1) == serial);
  CHECK(hash(graph::ExecutorKind::openmp_scheme2, 2, 1) == serial);
}

Drift calc_drift(const System<Space>& system, const Method& method, double seconds) {
  Run<Space> run(system, {method});
  const double energy = calc_energy(run);
  const space::Twist momentum = calc_momentum(run);
  run.advance_for(seconds);
  return {std::abs(calc_energy(run) - energy), calc_momentum(run) - momentum};
}

void check_conservation(const System<Space>& system, double seconds, double step) {
  const auto drift = [&](const Method& method) { return calc_drift(system, method, seconds); };
  const Drift whole = drift(Rk4{step}), half = drift(Rk4{0.5 * step});
  CHECK(half.momentum.norm() < 1e-7);
  CHECK(whole.momentum.norm() / half.momentum.norm() > 12.0);
  CHECK(whole.energy / half.energy > 12.0);
  const Drift coarse = drift(make_generalized_alpha(0.9, 5e-4)),
              fine = drift(make_generalized_alpha(0.9, 2.5e-4));
  CHECK(coarse.energy / fine.energy > 3.3);
}

}  // namespace spoke::test
