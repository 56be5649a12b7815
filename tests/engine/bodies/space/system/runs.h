#pragma once

// Systems that are advanced by their step graph, and what tests measure of them on the way.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/step/run/step_runner.h"
#include "models/scenario.h"
#include "models/system/spatial_system.h"

namespace spoke::test {

/// A model in space as its scenario file says, the text of `text` in TOML.
spatial::Model parse_model(const std::string& text);
/// One of the files in models/.
Scenario read_model(const std::string& name, const Overrides& overrides = {});

/// How steps are made.
struct RunSetup {
  Method method;
  double tolerance = 1e-12;  ///< of generalized_alpha [m, rad]
  graph::ExecutorKind executor = graph::ExecutorKind::serial;
  graph::Threads threads{1};
  int window = 1;
  Formulation formulation = Formulation::structured;
};

/// A system with what runs it. Stays in place.
template <class World>
class Run {
 public:
  Run(const System<World>& system, const RunSetup& setup);
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Makes so many steps.
  void advance(std::int64_t steps);
  /// Makes the steps of so many seconds.
  void advance_for(double seconds);
  std::int64_t steps() const { return runner->steps(); }

  /// Returns the sample of a subsystem in the last step.
  const SubsystemSample<World>& sample(std::size_t i) const;
  const SystemRecord<World>& record() const;
  std::uint64_t hash() const;

  SystemContext<World> context;
  std::unique_ptr<StepRunner> runner;
  double work = 0.0;                   ///< by drives, motors and loads since the start [J]
  double dissipated = 0.0;             ///< since the start [J]
  std::vector<Eigen::VectorXd> trace;  ///< displacements of all tips by step, hub frame
};

extern template class Run<Plane>;
extern template class Run<Space>;

/// Kinetic and potential energy of all, that of the hub or the fuselage included [J].
double calc_energy(Run<Space>& run);
/// Linear momentum, and angular momentum about the origin of space, in the inertial frame: the
/// derivatives of the kinetic energy by the twist of the hub, or of what a support stands on.
space::Twist calc_momentum(Run<Space>& run);
/// Deformation and joint coordinates of all bodies.
Eigen::VectorXd deformations(const Run<Space>& run);
/// Returns the largest difference of a deformation or joint coordinate.
double largest_difference(const Run<Space>& a, const Run<Space>& b);

/// Checks that the three formulations agree after so many steps, within a tolerance [rad, m].
/// Returns the run of `structured`.
std::unique_ptr<Run<Space>> check_formulations(const System<Space>& system, const Method& method,
                                               std::int64_t steps, double tolerance);

/// Checks that a system has one state after so many steps, whatever executes them, on any number of
/// threads and in any windows.
void check_equal_bits(const System<Space>& system, const Method& method, std::int64_t steps);

/// Changes within a run of what it conserves.
struct Drift {
  double energy = 0.0;
  space::Twist momentum = space::Twist::Zero();
};

/// Runs a system for so many seconds.
Drift calc_drift(const System<Space>& system, const Method& method, double seconds);
/// Checks that a free system without dissipation keeps momentum and energy by the method's order:
/// at half the step the drift of rk4 falls by nearly 16, that of generalized_alpha by nearly 4.
/// rk4 is run with `step` and its half [s].
void check_conservation(const System<Space>& system, double seconds, double step);

}  // namespace spoke::test
