#pragma once

// Observations of the complete steps of a simulation: the largest bending of a body, growth of the
// energy beyond the work done, the error of a step, and the momentum of a free model. They are a
// function of the steps alone, whatever runs them. They are doubles only, since saved states carry
// them.

#include <functional>
#include <string>
#include <vector>

#include "engine/bodies/table/step_progress.h"
#include "engine/simulation/jumps.h"
#include "engine/warnings.h"
#include "models/scenario.h"

namespace spoke {

/// Energies at the end of a step, as the sensors show them.
struct EnergyBalance {
  double energy = 0.0;    ///< kinetic and strain energy [J]
  double residual = 0.0;  ///< energy that neither the start nor work explains [J]
};

/// Momentum at the end of a step of a free model on which nothing acts.
struct MomentumBalance {
  double residual = 0.0;          ///< size of its change since the start [kg m/s]
  double size = 0.0;              ///< the largest momentum that the motion could have [kg m/s]
  double angular_residual = 0.0;  ///< same change about the place of the hub [kg m^2/s]
  double angular_size = 0.0;      ///< the largest that it could have [kg m^2/s]
};

struct Observations {
  /// The largest deflection of a step, if beyond the linear range (see LargeDeflection).
  struct Deflection {
    double step = -1.0;  ///< -1: there is none
    double ratio = 0.0;
    double subsystem = -1.0, body = -1.0;
  };
  Deflection first_deflection, largest_deflection;

  /// Energies of the steps at which they are known. The explained energy is that of start and work:
  /// the energy less its residual. Energy that comes from nowhere thus does not hide itself.
  struct Energy {
    double step = 0.0;     ///< the last such step
    double last = 0.0;     ///< explained energy there [J]
    double largest = 0.0;  ///< the largest explained energy [J]
    double change = 0.0;   ///< largest change within a step [J]
  };
  Energy energy;
  /// The first step at which the energy has grown beyond its limit.
  struct Growth {
    double step = -1.0;                   ///< -1: it has not
    double residual = 0.0, energy = 0.0;  ///< [J]; energy: the largest explained up to then
    double largest_residual = 0.0, largest_step = -1.0;
  };
  Growth growth;

  /// The largest estimated error of a step.
  struct Error {
    double first_step = -1.0;  ///< first step beyond the limit; -1: there is none
    double step = -1.0;        ///< -1: none is known
    double size = 0.0;
    double subsystem = -1.0, body = -1.0, place = 0.0;  ///< as in StepError
  };
  Error error;
  /// The largest share of the residual of momentum in its size.
  struct Momentum {
    double first_step = -1.0;               ///< first step beyond the limit; -1: there is none
    double step = -1.0;                     ///< step of the largest share; -1: none is known
    double share = 0.0;                     ///< [-]
    double residual = 0.0;                  ///< residual at that step [kg m/s, kg m^2/s]
    double is_angular = 0.0;                ///< 1: the residual is of the angular momentum
    double size = 0.0, angular_size = 0.0;  ///< the largest so far [kg m/s, kg m^2/s]
  };
  Momentum momentum;
  /// The loop that has come nearest to a singular position.
  struct Loop {
    double first_step = -1.0;  ///< first step within the limit; -1: there is none
    double step = -1.0;        ///< step of the nearest; -1: none is known
    double left = 1.0;         ///< as in LoopNearness
    double subsystem = -1.0, row = -1.0;
  };
  Loop loop;
};

/// Whether these may be observations of a model: the bodies that they name by the indices of
/// subsystem and body exist, and the rows of loops by those of subsystem and row.
bool is_possible(const Observations& seen,
                 const std::function<bool(std::int64_t, std::int64_t)>& has_body,
                 const std::function<bool(std::int64_t, std::int64_t)>& has_loop_row);

/// Takes the record of a step, in order of steps. Errors of a step beyond `error_limit` are warned
/// of; 0: none.
void observe_step(double step, const StepRecord& record, double error_limit, Observations& seen);

/// Takes the momentum at the end of a step. Returns whether its share is beyond `limit` for the
/// first time; limit 0: never.
bool observe_momentum(double step, const MomentumBalance& balance, double limit,
                      Observations& seen);

/// Takes the energy at the start [J].
void observe_start(double energy, Observations& seen);

/// Growth of the energy that is accepted.
struct GrowthLimit {
  double share = 0.0;       ///< of the largest explained energy; 0: any growth is accepted
  double resolution = 0.0;  ///< see calc_energy_resolution() [J]
  /// Whether the drive jumps within the step. The work on the hub in such a step excuses no growth.
  bool has_jump = false;
};

/// Returns the strain energy that the tolerance of a scenario leaves open: that of a change of
/// every coordinate by the tolerance [J].
double calc_energy_resolution(const Scenario& scenario);

/// Takes the energies of a step. Returns whether they have grown for the first time: by more than
/// the limit allows, and by more than ten times the largest change of the explained energy within
/// one step, apart from steps in which the drive jumps. The quadrature of the work may be wrong by
/// that much, most of all where a motion begins.
bool observe_energy(double step, const EnergyBalance& balance, const GrowthLimit& limit,
                    Observations& seen);

/// Returns the warnings of the simulation of a scenario in steps of `step_size` [s], at most one of
/// each kind. `jumps`: those of prescribed motions, in order of time.
std::vector<Warning> make_warnings(const Scenario& scenario, double step_size,
                                   const std::vector<Jump>& jumps, const Observations& seen);

/// Returns the largest error of a step so far.
StepAccuracy make_accuracy(const Scenario& scenario, double step_size, const Observations& seen);

/// Returns one sentence about growth of the energy, without advice. Precondition: it has grown.
std::string describe_growth(const Scenario& scenario, const Observations& seen);
/// Returns what to do about it: if the drive or another prescribed motion has jumped just before,
/// to let it jump less.
std::string advise_on_growth(const std::vector<Jump>& jumps, double step_size,
                             const Observations& seen);
std::string advise_on_growth(const Scenario& scenario, double step_size, const Observations& seen);

}  // namespace spoke
