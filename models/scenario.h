#pragma once

// A scenario file: the rotor or the model in space, how it is integrated and what is written. The
// file format (TOML, SI units) is documented in docs/scenario.md.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/rotor.h"
#include "models/sensor.h"
#include "models/spatial_model.h"
#include "spoke/export.h"

namespace spoke {

/// How a step is made.
enum class IntegrationMethod {
  generalized_alpha,  ///< implicit, of second order
  rk4,                ///< explicit, of fourth order
};

/// To what the implicit iteration of a step goes on.
enum class IterationGoal {
  error,      ///< a small share of the step's own error, or the tolerance if that is less
  tolerance,  ///< the tolerance
};

/// How the motion is integrated.
struct Integration {
  IntegrationMethod method = IntegrationMethod::generalized_alpha;  ///< of a step
  double step = 0.005;           ///< [s]; shortened to divide the duration
  double duration = 1.0;         ///< [s]
  double spectral_radius = 0.8;  ///< of generalized_alpha at infinite frequency, 0 to 1
  double tolerance = 1e-10;  ///< of the implicit iteration: last change of a coordinate [m, rad]
  int iterations = 0;        ///< fixed number of iterations per step; 0: iterate to tolerance
  int max_iterations = 30;   ///< per step, before the step is given up
  /// None: the error where the tolerance is the default, else the tolerance; see goal_of().
  std::optional<IterationGoal> iterate_to = std::nullopt;
};
/// What is iterated to.
SPOKE_EXPORT IterationGoal goal_of(const Integration& integration);

/// What becomes of a simulation whose energy grows beyond the work done on it.
enum class EnergyGrowth {
  warn,  ///< it goes on, with a warning in Simulation::warnings()
  stop,  ///< it ends with DivergenceError
};

/// Beyond which results are to be doubted.
struct Limits {
  double deflection = 0.1;      ///< of a body in its frame, by its length; 0: none
  double energy_growth = 0.01;  ///< by the largest energy so far; 0: none
  EnergyGrowth on_energy_growth = EnergyGrowth::warn;  ///< beyond that limit
  double step_error = 2e-4;  ///< estimated, of a step: by a radian or the length; 0: none
  double momentum = 0.01;    ///< residual of a free model by its largest momentum; 0: none
};

/// Where a simulation starts.
enum class InitialState {
  undeformed,   ///< joints where they are said to be, the hub with the speed that its drive has
  equilibrium,  ///< of steady rotation
};

/// The state at t = 0. From an equilibrium (docs/modes.md), what rises has risen: ramps of loads,
/// gravity and drive count as over, unless a spin-up is to begin from rest.
struct Initial {
  InitialState state = InitialState::undeformed;
  /// Of the equilibrium [rad/s]: of a drive by torque, or none, any; else one that the drive has at
  /// its start or after its ramp up. None: after its ramp up.
  std::optional<double> speed = std::nullopt;
};

/// What is written.
struct Output {
  double interval = 0.05;  ///< between rows of sensors.csv [s]; 0: every step
};

/// One "key=value" of the command line, overriding a key of the file.
using Overrides = std::vector<std::string>;

/// Everything about a simulation that a scenario file says. Simulation checks what is filled in
/// code as the reader checks a file.
struct SPOKE_EXPORT Scenario {
  std::string title;        ///< for people
  std::string name;         ///< the file's name without folder and ending; names the results folder
  Rotor rotor;              ///< what is simulated, in the plane
  Integration integration;  ///< how, and for how long
  Limits limits;            ///< beyond which results are doubted
  Output output;            ///< what spoke run writes
  /// What is measured besides the sensors that every simulation has.
  std::vector<Sensor> sensors;
  /// What is simulated, in space. `rotor` then has no blades.
  std::optional<spatial::Model> space;
  Initial initial;  ///< where it starts

  /// Every key with the value in force (defaults included), as a JSON object shaped like the file;
  /// blades always one by one, under "blades".
  std::string to_json() const;
};

/// The names that scenario files use: "generalized_alpha", "rk4".
SPOKE_EXPORT std::string_view name_of(IntegrationMethod method);
/// "error", "tolerance".
SPOKE_EXPORT std::string_view name_of(IterationGoal goal);
/// "warn", "stop".
SPOKE_EXPORT std::string_view name_of(EnergyGrowth growth);
/// "undeformed", "equilibrium".
SPOKE_EXPORT std::string_view name_of(InitialState state);
/// "axle", "free".
SPOKE_EXPORT std::string_view name_of(HubSupport support);
/// "clamped", "chord".
SPOKE_EXPORT std::string_view name_of(ReferenceFrame frame);
/// "inertial", "hub", "section".
SPOKE_EXPORT std::string_view name_of(LoadFrame frame);
/// "inertial", "hub".
SPOKE_EXPORT std::string_view name_of(DragFrame frame);

/// Reads and validates a scenario. Throws InputError, its text "file:line:column: key: what is
/// wrong, what is expected".
SPOKE_EXPORT Scenario read_scenario(const std::string& file, const Overrides& overrides = {});

/// The same from a string; `name` stands for the file in messages.
SPOKE_EXPORT Scenario parse_scenario(const std::string& text, const std::string& name,
                                     const Overrides& overrides = {});

}  // namespace spoke
