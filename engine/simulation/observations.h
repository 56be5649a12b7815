#pragma once

// What the complete steps of a simulation have shown so far: the farthest that a body has bent,
// whether the energy has grown beyond the work done, the error of a step, and whether a free model
// keeps its momentum. A function of the steps alone, whatever runs
// them. Doubles only, for saved states carry it.

#include <functional>
#include <string>
#include <vector>

#include "engine/simulation/jumps.h"
#include "engine/table/step_progress.h"
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
  double size = 0.0;              ///< what the motion could carry at most [kg m/s]
  double angular_residual = 0.0;  ///< likewise, about the place of the hub [kg m^2/s]
  double angular_size = 0.0;      ///< [kg m^2/s]
};

struct Observations {
  /// The largest deflection of a step, if beyond the linear range (see LargeDeflection).
  struct Deflection {
    double step = -1.0;  ///< -1: there is none
    double ratio = 0.0;
    double blade = -1.0, body = -1.0;
  };
  Deflection first_deflection, largest_deflection;

  /// Of steps whose energies are known: the energy that start and work explain, which is the
  /// energy less its residual. What comes from nowhere thus does not hide itself.
  struct Energy {
    double step = 0.0;     ///< the last one
    double last = 0.0;     ///< explained energy there [J]
    double largest = 0.0;  ///< [J]
    double change = 0.0;   ///< largest change within a step [J]
  };
  Energy energy;
  /// When the energy has first grown beyond its limit.
  struct Growth {
    double step = -1.0;                   ///< -1: it has not
    double residual = 0.0, energy = 0.0;  ///< [J]; energy: the largest explained up to then
    double largest_residual = 0.0, largest_step = -1.0;
  };
  Growth growth;

  /// The largest estimated error of a step.
  struct Error {
    double first_step = -1.0;  ///< beyond the limit; -1: there is none
    double step = -1.0;        ///< -1: none is known
    double size = 0.0;
    double blade = -1.0, body = -1.0, place = 0.0;  ///< as of StepError
  };
  Error error;
  /// The largest residuals of momentum by the largest sizes so far.
  struct Momentum {
    double first_step = -1.0;               ///< beyond the limit; -1: there is none
    double step = -1.0;                     ///< of the largest share; -1: none is known
    double share = 0.0;                     ///< [-]
    double residual = 0.0;                  ///< there [kg m/s, kg m^2/s]
    double is_angular = 0.0;                ///< 1: that of the angular momentum
    double size = 0.0, angular_size = 0.0;  ///< the largest so far [kg m/s, kg m^2/s]
  };
  Momentum momentum;
};

/// Whether these may be observations of a model: the bodies that they name, by the indices of blade
/// and body, exist.
bool is_possible(const Observations& seen,
                 const std::function<bool(std::int64_t, std::int64_t)>& has_body);

/// Takes the record of a step, in order of steps. `error_limit`: beyond which an error of a step is
/// warned of; 0: none.
void observe_step(double step, const StepRecord& record, double error_limit, Observations& seen);

/// Takes the momentum at the end of a step; `limit`: of its share, 0: none. Whether it is beyond it
/// for the first time.
bool observe_momentum(double step, const MomentumBalance& balance, double limit,
                      Observations& seen);

/// Takes the energy at the start [J].
void observe_start(double energy, Observations& seen);

/// What growth of the energy is accepted.
struct GrowthLimit {
  double share = 0.0;       ///< of the largest explained energy; 0: any growth is accepted
  double resolution = 0.0;  ///< see calc_energy_resolution() [J]
  /// Whether the drive jumps within the step: what the hub takes then excuses nothing.
  bool has_jump = false;
};

/// Strain energy that a scenario's tolerance leaves open: of a change of every coordinate by so
/// much [J].
double calc_energy_resolution(const Scenario& scenario);

/// Takes the energies of a step. Whether this is the first at which they have grown: by more than
/// the limit allows, and more than ten times what the explained energy has changed by within any
/// one step, but for those in which the drive jumps. That is what the quadrature of the work may be
/// wrong by, most of all where a motion begins.
bool observe_energy(double step, const EnergyBalance& balance, const GrowthLimit& limit,
                    Observations& seen);

/// What the simulation of a scenario, in steps of `step_size` [s], is to be warned of, at most one
/// of each kind. `jumps`: of what is prescribed, in order of time.
std::vector<Warning> make_warnings(const Scenario& scenario, double step_size,
                                   const std::vector<Jump>& jumps, const Observations& seen);

/// The largest error of a step so far.
StepAccuracy make_accuracy(const Scenario& scenario, double step_size, const Observations& seen);

/// One sentence about growth of the energy, without advice. Precondition: it has grown.
std::string describe_growth(const Scenario& scenario, const Observations& seen);
/// What to do about it: if the drive, or another prescribed motion, has jumped just before, let it
/// jump less.
std::string advise_on_growth(const std::vector<Jump>& jumps, double step_size,
                             const Observations& seen);
std::string advise_on_growth(const Scenario& scenario, double step_size, const Observations& seen);

}  // namespace spoke
