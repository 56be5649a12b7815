// Tests what allocates. It is a program of its own, since it counts every allocation of the
// process.

#include <doctest/doctest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <vector>

#include "engine/bodies/kinds/beam/beam_energies.h"
#include "engine/bodies/space/joint_terms.h"
#include "engine/bodies/space/section.h"
#include "engine/bodies/tree/joint_recovery.h"
#include "engine/simulation.h"
#include "engine/step/run/time_stepper.h"
#include "engine/step/step_graph_builder.h"
#include "tests/engine/bodies/space/bodies.h"
#include "tests/engine/bodies/space/hub_table.h"
#include "tests/engine/bodies/space/random_joint.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/engine/counted_allocations.h"
#include "tests/engine/loop_models.h"
#include "tests/engine/rotors.h"
#include "tests/engine/solids/solid_models.h"
#include "tests/models/space/random_space.h"
#include "tests/shipped.h"

using namespace spoke;
using namespace spoke::test;

namespace {

constexpr int kTracedSteps = 100;

/// Returns the allocations from the first to the last of kTracedSteps steps that `make_steps`
/// reports, as `counter` counts them.
template <class MakeSteps>
long allocations_between(const std::atomic<long>& counter, MakeSteps make_steps) {
  std::vector<long> counts;
  counts.reserve(kTracedSteps);
  make_steps([&](double, std::span<const double>) { counts.push_back(counter.load()); });
  REQUIRE(counts.size() == kTracedSteps);
  return counts.back() - counts.front();
}

/// Checks that a recording allocates nothing. Runtimes may allocate for themselves; oneTBB does now
/// and then. So steps with and without a recording take turns, and the least number of each counts:
/// a recording that allocates does so every time.
void check_that_recording_allocates_nothing(Simulation& simulation,
                                            const std::atomic<long>& counter = allocations) {
  simulation.run_until(simulation.time() + 500 * simulation.step_size());  // pools are filled
  long least = std::numeric_limits<long>::max(), least_recorded = least;
  for (int turn = 0; turn < 5; ++turn) {
    const double end = simulation.time() + kTracedSteps * simulation.step_size();
    least = std::min(least, allocations_between(counter, [&](const StepObserver& observe) {
                       simulation.run_until(end, observe);
                     }));
    least_recorded =
        std::min(least_recorded, allocations_between(counter, [&](const StepObserver& observe) {
                   const StepTrace trace = simulation.trace(kTracedSteps, observe);
                   CHECK(trace.steps.size() == kTracedSteps);
                 }));
  }
  CHECK(least_recorded <= least);
}

}  // namespace

TEST_CASE("allocations are counted") {
  const long before = allocations.load(), before_by_new = allocations_by_new.load();
  std::vector<double> some(100);
  CHECK(some.data() != nullptr);
  CHECK(allocations.load() == before + 1);
  CHECK(allocations_by_new.load() == before_by_new + 1);
}

TEST_CASE("a step allocates nothing, at small and large numbers of elements") {
  for (const IntegrationMethod method :
       {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4})
    for (const int elements : {1, 4, 64, 300}) {
      Scenario scenario = spin_up_scenario(wu_haug_blade(2, elements), 1e-3);
      scenario.integration.method = method;
      if (method == IntegrationMethod::rk4) scenario.integration.step = 1e-8;
      scenario.rotor.damping = {0.0, 1e-6, {.lag = 1e-9}, {.ratios = {0.01, 0.02}, .above = 0.0}};
      add_all_loads(scenario.rotor);
      CAPTURE(elements);
      CHECK(allocations_of_steps(scenario, {Formulation::structured, ExecutorKind::serial, 1},
                                 20) == 0);
      for (Blade& blade : scenario.rotor.blades) blade.strain = BeamStrain::nonlinear;
      CHECK(allocations_of_steps(scenario, {Formulation::structured, ExecutorKind::serial, 1},
                                 20) == 0);
    }
}

TEST_CASE("a step of the dense formulations allocates nothing at the paper's size") {
  for (const Formulation formulation : {Formulation::subsystem, Formulation::augmented})
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
      Scenario scenario = spin_up_scenario(wu_haug_blade(), 1e-3);
      scenario.integration.method = method;
      if (method == IntegrationMethod::rk4) scenario.integration.step = 8e-5;
      CAPTURE(name_of(formulation));
      CHECK(allocations_of_steps(scenario, {formulation, ExecutorKind::serial, 1}, 10) == 0);
      for (Blade& blade : scenario.rotor.blades) blade.strain = BeamStrain::nonlinear;
      CHECK(allocations_of_steps(scenario, {formulation, ExecutorKind::serial, 1}, 10) == 0);
    }
}

TEST_CASE("a step of a model with loops and sensors on them allocates nothing") {
  for (const Formulation formulation : formulations())
    for (const IntegrationMethod method :
         {IntegrationMethod::generalized_alpha, IntegrationMethod::rk4}) {
      Scenario scenario = make_pitching("drive = { kind = \"constant\", speed = 5.0 }", 2);
      scenario.integration.method = method;
      for (const SensorQuantity quantity :
           {SensorQuantity::loop_reaction, SensorQuantity::loop_opening})
        scenario.sensors.push_back(loop_sensor(quantity, "", "bladeB", "link"));
      const SimulationOptions options{formulation, ExecutorKind::serial, 1};
      CAPTURE(name_of(formulation));
      CHECK(allocations_of_steps(scenario, options, 20) == 0);
      Simulation simulation(scenario, options);
      CHECK(allocations_between(allocations, [&](const StepObserver& observe) {
              simulation.run_until(kTracedSteps * simulation.step_size(), observe);
            }) == 0);
    }
}

TEST_CASE("a step of a tree in space allocates nothing, whatever the formulation") {
  for (const Formulation formulation : formulations())
    for (const char* method : {"generalized_alpha", "rk4"}) {
      const Scenario scenario =
          parse_scenario(make_text(kFlyingHub, kTree + kMotors + kForest,
                                   kGravity + "[damping]\nflap = 1e-4\nratios = [0.01, 0.02]\n") +
                             "step = 1e-4\nmethod = \"" + method + "\"\n",
                         "tree.toml");
      CAPTURE(name_of(formulation));
      CHECK(allocations_of_steps(scenario, {formulation, ExecutorKind::serial, 1}, 10) == 0);
    }
}

TEST_CASE("a step with strains of second order allocates nothing, whatever the formulation") {
  for (const Formulation formulation : formulations())
    for (const char* method : {"generalized_alpha", "rk4"}) {
      const Scenario scenario =
          parse_scenario(with_nonlinear_strains(make_text(kFlyingHub, kTree + kMotors + kForest,
                                                          kGravity + "[damping]\nflap = 1e-4\n")) +
                             "step = 1e-4\nmethod = \"" + method + "\"\n",
                         "tree.toml");
      CAPTURE(name_of(formulation));
      CHECK(allocations_of_steps(scenario, {formulation, ExecutorKind::serial, 1}, 10) == 0);
    }
}

TEST_CASE("a step of a rotor on a support allocates nothing, whatever the formulation") {
  const std::string strut =
      "[[support.loop]]\nname = \"strut\"\nkind = \"distance\"\n"
      "from = { body = \"nacelle\", point = [0.2, 0.3, 0.1] }\n"
      "to = { body = \"ground\", point = [1.0, 1.5, -0.5] }\n"
      "[[sensor]]\nname = \"axle\"\nquantity = \"joint_reaction\"\nsubsystem = \"support\"\n"
      "body = \"hub\"\n";
  for (const Formulation formulation : formulations())
    for (const char* method : {"generalized_alpha", "rk4"})
      for (const std::string& machine :
           {kTurnedHub + kBooms + kHinges + kTower + strut, kDrivenHub + kBooms + kAir,
            kTurnedHub + kBooms + kControlledPitch + kTower, kFuselageHub + kBooms + kHinges}) {
        const Scenario scenario = parse_scenario(
            make_text(machine, "", kGravity) + "step = 1e-4\nmethod = \"" + method + "\"\n",
            "machine.toml");
        CAPTURE(name_of(formulation));
        CHECK(allocations_of_steps(scenario, {formulation, ExecutorKind::serial, 1}, 10) == 0);
      }
}

TEST_CASE("a step that makes the tension of rotation anew allocates nothing") {
  // The run goes through several of 32 speeds an octave, without a warning, which would be
  // allocated.
  const Scenario scenario = read_shipped(
      "articulated_rotor",
      {"hub.drive={kind=\"torque\", torque=40000, initial_speed=34}", "initial.state=equilibrium",
       "gravity.ramp=0", "distributed_load.1.factor=[1,1]"});
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  for (int n = 0; n < 3; ++n) simulation.step();
  const long before = allocations.load();
  for (int n = 0; n < 300; ++n) simulation.step();
  CHECK(allocations.load() == before);
  CHECK(simulation.sensor("hub.speed") > 36.0);
}

TEST_CASE("a step of solids allocates nothing, in slices neither") {
  for (const auto coordinates :
       {spatial::SolidCoordinates::reduced, spatial::SolidCoordinates::nodal})
    for (const int slices : {1, 2}) {
      CAPTURE(slices);
      SystemContext<Space> context;
      context.system =
          cut_solids(make_system(make_solid_trees(HubSupport::free, coordinates)), slices);
      context.integrator = {make_generalized_alpha(0.8, 5e-4), {1e-12, 0, 50}};
      allocate(context);
      const graph::StepGraph graph = build_step_graph(context, 1);
      const auto executor = graph::make_executor(graph, graph::ExecutorKind::serial);
      TimeStepper stepper(context, graph);
      REQUIRE(stepper.start() == StepOutcome::done);
      REQUIRE(stepper.advance(2, *executor, true) == StepOutcome::done);
      const long before = allocations.load();
      const StepOutcome outcome = stepper.advance(8, *executor, true);
      CHECK(allocations.load() == before);
      CHECK(outcome == StepOutcome::done);
    }
}

TEST_CASE("measuring the sensors allocates nothing") {
  Scenario scenario = spin_up_scenario(wu_haug_blade(), 1e-3);
  for (const SensorQuantity quantity : {SensorQuantity::acceleration, SensorQuantity::section_force,
                                        SensorQuantity::momentum, SensorQuantity::hub_reaction}) {
    Sensor sensor;
    sensor.quantity = quantity;
    sensor.position = 3.0;
    scenario.sensors.push_back(sensor);
  }
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1});
  simulation.sensor_values();
  const long before = allocations.load();
  for (int n = 0; n < 5; ++n) {
    simulation.step();
    simulation.sensor_values();
  }
  CHECK(allocations.load() == before);
}

TEST_CASE("a load of the user's allocates nothing but what it allocates itself") {
  const auto drag = make_load("drag", {{0, 0, 0.5}, {0, 3, 1.0}},
                              [](double, std::span<const MarkerMotion> in, std::span<Wrench> out) {
                                for (std::size_t k = 0; k < in.size(); ++k)
                                  out[k].force = -0.1 * in[k].velocity;
                              });
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-3),
                        {Formulation::structured, ExecutorKind::serial, 1}, {drag});
  for (int n = 0; n < 3; ++n) simulation.step();
  const long before = allocations.load();
  for (int n = 0; n < 10; ++n) simulation.step();
  CHECK(allocations.load() == before);
}

TEST_CASE("recording a trace allocates nothing while steps are made, on any executor") {
  for (const ExecutorKind kind : graph::executor_kinds())
    for (const int threads : {1, 2})
      for (const int window : {1, 10}) {
        CAPTURE(name_of(kind));
        CAPTURE(threads);
        CAPTURE(window);
        Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-3),
                              {Formulation::structured, kind, threads, window});
        check_that_recording_allocates_nothing(
            simulation, kind == ExecutorKind::openmp_tasks ? allocations_by_new : allocations);
      }
}

TEST_CASE("a step of tasks of OpenMP allocates nothing but what OpenMP does for its tasks") {
  if (!graph::has_executor(ExecutorKind::openmp_tasks)) return;
  for (const int threads : {1, 2}) {
    CAPTURE(threads);
    Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-3),
                          {Formulation::structured, ExecutorKind::openmp_tasks, threads, 1});
    for (int n = 0; n < 3; ++n) simulation.step();
    const long before = allocations_by_new.load();
    for (int n = 0; n < 100; ++n) simulation.step();
    CHECK(allocations_by_new.load() == before);
  }
}

TEST_CASE("recording a trace of nested teams allocates nothing while steps are made") {
  for (const ExecutorKind kind : {ExecutorKind::openmp_scheme1, ExecutorKind::openmp_scheme2}) {
    if (!graph::has_executor(kind)) continue;
    CAPTURE(name_of(kind));
    Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-3),
                          {Formulation::structured, kind, {2, 2}, 1});
    check_that_recording_allocates_nothing(simulation);
  }
}

TEST_CASE("recording a trace of what auto has chosen allocates nothing while steps are made") {
  Simulation simulation(spin_up_scenario(wu_haug_blade(), 1e-4),
                        {Formulation::structured, ExecutorKind::automatic, 2, 20});
  const auto is_tuning = [&] {
    return simulation.executor_description().find("still tuning") != std::string::npos;
  };
  while (is_tuning() && simulation.time() < 15.0) simulation.run_until(simulation.time() + 0.1);
  REQUIRE_FALSE(is_tuning());
  CAPTURE(simulation.executor_description());
  check_that_recording_allocates_nothing(simulation);
}

TEST_CASE("a recording allocates no more than its buffer") {
  // With many blades of few nodes the places of passes take much memory beside the records.
  Scenario scenario = spin_up_scenario(wu_haug_blade(1, 1), 1e-3);
  scenario.rotor.blades.resize(24, scenario.rotor.blades[0]);
  scenario.integration.duration = 50.0;
  for (const int window : {1, 10}) {
    Simulation simulation(scenario, {Formulation::structured, ExecutorKind::serial, 1, window});
    simulation.run_until(0.05);
    TraceOptions options;
    options.buffer_bytes = 1000000;
    std::size_t used = 0;
    const std::size_t before = allocated_bytes.load();
    const StepObserver observe = [&](double, std::span<const double>) {
      if (used == 0) used = allocated_bytes.load() - before;
      simulation.stop();
    };
    simulation.trace(40000, observe, options);
    CHECK(used > options.buffer_bytes / 2);
    // The search for which node of a pass is which takes some more for a while.
    CHECK(used <= options.buffer_bytes + options.buffer_bytes / 20);
  }
}

TEST_CASE("a step on the flow graph allocates nothing once its pools are filled") {
  const Scenario scenario = spin_up_scenario(wu_haug_blade(), 1e-3);
  Simulation simulation(scenario, {Formulation::structured, ExecutorKind::flow_graph, 2});
  for (int n = 0; n < 500; ++n) simulation.step();
  const long before = allocations.load();
  for (int n = 0; n < 500; ++n) simulation.step();
  // oneTBB grows a pool now and then, when a task ends on another thread; a step does not.
  CHECK(allocations.load() - before < 50);
}

namespace {

/// Evaluates one joint of a body with three handles, and the hub.
void evaluate_joint(const space::Joint& model, space::testing::HubTable& table,
                    std::mt19937& random) {
  using namespace spoke::space;
  using namespace spoke::space::testing;
  const std::array<double, space::Joint::kMost> q{0.1, 0.2, 0.3}, v{0.4, 0.5, 0.6};
  const std::array<PrescribedMotion, space::Joint::kMost> driven{};
  const Quaternion reference;
  const JointState state{q.data(), v.data(), &reference, driven.data()};
  JointMotion motion;
  JointForces forces;
  space::Twist twist;
  calc_joint_motion(model, state, space::Rotation{}, random_twist(random), motion, twist);
  calc_joint_forces(model, state, {}, nullptr, nullptr, forces);
  const JointTerms joint(model, motion, forces);

  std::array<space::SymmetricTwistMatrix, 3> diagonal;
  diagonal.fill(random_inertia(random));
  std::array<space::TwistMatrix, 3> pairs;
  pairs.fill(random_matrix(random));
  std::array<space::Twist, 3> free, f;
  free.fill(random_twist(random));
  f.fill(random_twist(random));
  const tree::MultiPort<Space> port{3, diagonal.data(), pairs.data(), free.data()};
  const tree::Branch<Space> branch{random_inertia(random), random_twist(random)};
  tree::JointElimination<Space> elimination;
  tree::RootElimination<Space> root;
  std::array<double, space::Joint::kMost> a{};
  eliminate_child(2, joint, branch, port, elimination);
  const tree::HubShare<Space> share = eliminate_root(joint, branch, root);
  table.data.subsystems[0].effective = {share.mass.matrix(), share.force, {}};
  const HubSolution<Space>& hub = table.solve();
  recover_root(joint, root, calc_carried_acceleration(motion, hub.acceleration), a.data());
  recover_child(2, joint, port, elimination, f.data(), a.data());
}

}  // namespace

namespace {

/// Returns the memory that is allocated now [bytes].
double live_bytes() {
  const auto heap = mallinfo2();
  return static_cast<double>(heap.uordblks) + static_cast<double>(heap.hblkhd);
}

/// Returns the estimated memory of a model, divided by what it takes.
double relative_estimate(const Scenario& scenario,
                         Formulation formulation = Formulation::structured) {
  const double before = live_bytes();
  const Simulation simulation(scenario, {formulation, ExecutorKind::serial, 1});
  return static_cast<double>(simulation.size().memory_bytes) / (live_bytes() - before);
}

/// Makes a chain of rigid bodies on a turning hub, each with three rods to the hub.
Scenario make_tied_chain(int bodies) {
  std::string text = "world = \"space\"\n[hub]\ndrive = { kind = \"constant\", speed = 1.0 }\n";
  text += "[integration]\nduration = 1.0\nstep = 0.01\n[[subsystem]]\nname = \"chain\"\n";
  for (int j = 0; j < bodies; ++j)
    text += "[[subsystem.body]]\nname = \"b" + std::to_string(j) +
            "\"\nkind = \"rigid\"\nmass = 1.0\ninertia = [0.1, 0.1, 0.1]\n";
  for (int j = 0; j < bodies; ++j)
    text += "[[subsystem.joint]]\nparent = \"" + (j == 0 ? "hub" : "b" + std::to_string(j - 1)) +
            "\"\nchild = \"b" + std::to_string(j) +
            "\"\nkind = \"revolute\"\naxis = [0.0, 0.0, 1.0]\noffset = [0.3, 0.1, 0.0]\n";
  Scenario scenario = parse_scenario(text, "chain.toml");
  for (int j = 0; j < bodies; ++j)
    for (const char* rod : {"x", "y", "z"}) {
      Loop loop;
      loop.name = rod + std::to_string(j);
      loop.kind = LoopKind::distance;
      loop.from = place_on("b" + std::to_string(j), {0.1 * (*rod - 'w'), 0.2, 0.0});
      loop.to = place_on(LoopPlace::Carrier::hub, {-1.0, 0.5 * (*rod - 'x'), 0.0});
      scenario.space->subsystems[0].loops.push_back(loop);
    }
  return scenario;
}

}  // namespace

TEST_CASE("the memory of a model is known to a quarter before it is allocated") {
  const std::vector<std::string> many{"blade.count=24", "blade.bodies=8", "blade.elements=8"};
  const std::vector<std::string> fine{"blade.count=3", "blade.bodies=4", "blade.elements=64"};
  for (const auto& size : {many, fine})
    for (const char* file : {"wu_haug_rotor.toml", "spatial_wu_haug.toml", "nrel_5mw_rotor.toml"}) {
      CAPTURE(file);
      CHECK(relative_estimate(read_scenario(std::string(SPOKE_MODELS_DIR) + "/" + file, size)) ==
            doctest::Approx(1.0).epsilon(0.25));
    }
  for (std::vector<std::string> size : {many, fine}) {
    size.push_back("blade.strain=nonlinear");
    CHECK(relative_estimate(read_shipped("wu_haug_rotor", size)) ==
          doctest::Approx(1.0).epsilon(0.25));
  }
  for (const Formulation formulation : formulations()) {
    CAPTURE(name_of(formulation));
    CHECK(relative_estimate(make_tied_chain(40), formulation) ==
          doctest::Approx(1.0).epsilon(0.25));
  }
}

TEST_CASE("joints of trees in space are eliminated and recovered without allocation") {
  std::mt19937 random(1);
  for (const char* kind : space::testing::kJointKinds) {
    CAPTURE(std::string(kind));
    const space::Joint joint = space::testing::make_random_joint(kind, random);
    const tree::HubShare<Space> share{{}, space::Twist::Zero()};
    space::testing::HubTable table({&share, 1});
    table.system.hub.support = HubSupport::free;
    table.system.hub.inertia = space::testing::random_inertia(random);
    const long before = allocations.load();
    evaluate_joint(joint, table, random);
    CHECK(allocations.load() == before);
  }
}

namespace {

/// Evaluates one flexible body.
void evaluate_body(spoke::space::test::TestBody& test, const space::Section& section,
                   std::vector<space::Twist>& wrenches, Eigen::VectorXd& a) {
  using namespace spoke::space;
  test.calc_terms();
  const HandleMotion motion = calc_section_motion(test.body, section, test.q.data(), test.v.data());
  add_section_wrench(section, motion, wrenches[0], test.terms, test.work);
  for (const bool implicit : {false, true}) {
    condense_body(test.model, test.terms, test.motion.w, implicit, test.work);
    recover_body(test.model, wrenches.data(), implicit, test.work, a.data());
  }
  calc_body_energies(test.model, test.state(), wrenches[0], test.motion, test.work);
}

}  // namespace

TEST_CASE("a flexible body in space is evaluated without allocation, however fine its mesh") {
  namespace bodies = spoke::space::test;
  std::mt19937 random(2);
  for (const int elements : {1, 32}) {
    const space::Beam beam = bodies::make_random_beam({true, true, true}, random);
    bodies::TestBody test(
        space::make_beam_body(beam, bodies::make_unequal_stations(beam, elements, random),
                              ReferenceFrame::chord, {0, elements}));
    bodies::randomize_state(random, test);
    const space::Section section = space::make_section(beam, test.body, 0.3);
    std::vector<space::Twist> wrenches(2, space::Twist::Ones());
    Eigen::VectorXd a(test.q.size());
    const long before = allocations.load();
    evaluate_body(test, section, wrenches, a);
    CHECK(allocations.load() == before);
  }
}
