#pragma once

// A scenario file: the rotor or the model in space, how it is integrated and what is written. The
// file format (TOML, SI units) is documented in docs/scenario.md.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/rotor.h"
#include "models/sensor.h"
#include "models/spatial_model.h"
#include "spoke/export.h"

namespace spoke {

/// The method that makes a step.
enum class IntegrationMethod {
  generalized_alpha,  ///< implicit, second order
  rk4,                ///< explicit, fourth order
};

/// The accuracy to which the implicit iteration of a step goes on.
enum class IterationGoal {
  error,      ///< a small share of the step's own error, or the tolerance if that is less
  tolerance,  ///< the tolerance
};

/// How the motion is integrated.
struct Integration {
  IntegrationMethod method = IntegrationMethod::generalized_alpha;  ///< method of a step
  double step = 0.005;    ///< [s]; shortened to divide the duration
  double duration = 1.0;  ///< [s]
  /// Spectral radius of generalized_alpha at infinite frequency, 0 to 1.
  double spectral_radius = 0.8;
  /// Largest last change of a coordinate in the implicit iteration [m, rad].
  double tolerance = 1e-10;
  int iterations = 0;       ///< fixed number of iterations per step; 0: iterate to tolerance
  int max_iterations = 30;  ///< most iterations of a step before it is given up
  /// The goal of the iteration; none: the error where the tolerance is the default, else the
  /// tolerance; see goal_of().
  std::optional<IterationGoal> iterate_to = std::nullopt;
  /// Rows of closed loops that are rigid count as redundant, and are dropped, where their pivot is
  /// below this share of the largest.
  double loop_redundancy = 1e-9;
};
/// Returns the goal of the iteration in force.
SPOKE_EXPORT IterationGoal goal_of(const Integration& integration);

/// The consequence of an energy that grows beyond the work done on the model.
enum class EnergyGrowth {
  warn,  ///< the simulation goes on, with a warning in Simulation::warnings()
  stop,  ///< the simulation ends with DivergenceError
};

/// Limits beyond which results are doubtful.
struct Limits {
  /// Deflection of a body in its frame, as a fraction of its length; 0: none.
  double deflection = 0.1;
  double energy_growth = 0.01;  ///< growth as a fraction of the largest energy so far; 0: none
  EnergyGrowth on_energy_growth = EnergyGrowth::warn;  ///< consequence of growth beyond that limit
  /// Estimated error of a step, in radians or as a fraction of a length; 0: none.
  double step_error = 2e-4;
  /// Residual of a free model's momentum, as a fraction of its largest momentum; 0: none.
  double momentum = 0.01;
};

/// The state that a simulation starts from.
enum class InitialState {
  undeformed,   ///< joints at their initial coordinates, the hub at the speed of its drive
  equilibrium,  ///< equilibrium of steady rotation
};

/// The state at t = 0. At an equilibrium (docs/modes.md), ramps of loads, gravity and drive count
/// as over, unless a spin-up is to begin from rest.
struct Initial {
  InitialState state = InitialState::undeformed;
  /// Speed of the equilibrium [rad/s]. A hub driven by a torque, or by nothing, can have any; other
  /// drives only the speed at their start or after their ramp up. None: the speed after the ramp
  /// up.
  std::optional<double> speed = std::nullopt;
};

/// The results that are written.
struct Output {
  double interval = 0.05;  ///< time between rows of sensors.csv [s]; 0: every step
};

/// How statistics of a run are made.
struct Statistics {
  /// Exponents of Woehler's curves by name: of a blade or another subsystem ("blade1", "support"),
  /// or "blades", which holds for those that have no name here. What has none is as
  /// find_wohler_exponent() says.
  std::map<std::string, double> exponents{};
};

/// One "key=value" of the command line, overriding a key of the file.
using Overrides = std::vector<std::string>;

/// Everything about a simulation that a scenario file says. Simulation checks what is filled in
/// code as the reader checks a file.
struct SPOKE_EXPORT Scenario {
  std::string title;        ///< title for people
  std::string name;         ///< the file's name without folder and ending; names the results folder
  Rotor rotor;              ///< the rotor in the plane
  Integration integration;  ///< how the motion is integrated, and for how long
  Limits limits;            ///< limits beyond which results are doubtful
  Output output;            ///< the results that spoke run writes
  Statistics statistics;    ///< how their statistics are made
  /// Sensors besides those that every simulation has.
  std::vector<Sensor> sensors;
  /// The model in space, if the simulation is one in space; `rotor` then has no blades.
  std::optional<spatial::Model> space;
  Initial initial;  ///< the state at t = 0

  /// Returns every key with the value in force (defaults included), as a JSON object shaped like
  /// the file; blades are always one by one, under "blades".
  std::string to_json() const;
};

/// Returns the exponent of Woehler's curve by which root moments of a blade or another subsystem
/// make a damage-equivalent range: that of the scenario, else 10 of blades and of what is on the
/// hub, as is usual for composites, and 4 of a support, as for welded steel. `name`: as of sensors,
/// "blade1".
SPOKE_EXPORT double find_wohler_exponent(const Scenario& scenario, const std::string& name);

/// Returns whether a blade or a subsystem has a closed loop or a coupling.
SPOKE_EXPORT bool has_loops(const Scenario& scenario);

/// Returns the name that scenario files use: "generalized_alpha", "rk4".
SPOKE_EXPORT std::string_view name_of(IntegrationMethod method);
/// Returns "error" or "tolerance".
SPOKE_EXPORT std::string_view name_of(IterationGoal goal);
/// Returns "warn" or "stop".
SPOKE_EXPORT std::string_view name_of(EnergyGrowth growth);
/// Returns "undeformed" or "equilibrium".
SPOKE_EXPORT std::string_view name_of(InitialState state);
/// Returns "axle" or "free".
SPOKE_EXPORT std::string_view name_of(HubSupport support);
/// Returns "clamped" or "chord".
SPOKE_EXPORT std::string_view name_of(ReferenceFrame frame);
/// Returns "automatic", "linear" or "nonlinear".
SPOKE_EXPORT std::string_view name_of(BeamStrain strain);
/// Returns "inertial", "hub" or "section".
SPOKE_EXPORT std::string_view name_of(LoadFrame frame);
/// Returns "inertial" or "hub".
SPOKE_EXPORT std::string_view name_of(DragFrame frame);

/// Reads and validates a scenario. Throws InputError, its text "file:line:column: key: what is
/// wrong, what is expected".
SPOKE_EXPORT Scenario read_scenario(const std::string& file, const Overrides& overrides = {});

/// Reads and validates a scenario from a string; `name` stands for the file in messages. Throws
/// InputError as read_scenario() does.
SPOKE_EXPORT Scenario parse_scenario(const std::string& text, const std::string& name,
                                     const Overrides& overrides = {});

}  // namespace spoke
