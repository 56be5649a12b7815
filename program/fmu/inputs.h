#pragma once

// The inputs that an FMU offers: what an importer may set at each communication point.

#include <memory>
#include <string>
#include <vector>

#include "engine/courses.h"
#include "engine/simulation.h"

namespace spoke::fmu {

/// An input of an FMU. It holds from the communication point at which it is applied to the next
/// one. It keeps no state: what is in force is in Courses.
///
/// A new kind of input is a class of its own and a line in possible_inputs(). If it sets what
/// Courses does not hold yet, Courses and write_state() (library/model_state.h) learn it, too.
class Input {
 public:
  virtual ~Input() = default;
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  /// Puts a value in force from the simulation's time on, for a communication step of `step` [s].
  /// Throws as the functions of Simulation do.
  virtual void apply(double value, double step, Simulation& simulation, Courses& courses) const = 0;
  /// Notes in `courses` what is in force at t = 0, before any input is applied.
  virtual void begin(const Simulation& simulation, Courses& courses) const = 0;
  /// Whether two inputs set one thing, so that an FMU can have one of them only.
  bool excludes(const Input& other) const { return subject_ == other.subject_; }

  const std::string name;         ///< "drive.torque"
  const std::string unit;         ///< SI; "1": a factor
  const std::string description;  ///< one sentence
  const double start;             ///< value that the scenario starts with
  /// Whether the FMU has it unless inputs are chosen.
  const bool is_usual;

 protected:
  struct Signal {
    std::string name, unit, description;
    double start = 0.0;
    bool is_usual = true;
    std::string subject{};  ///< name of what it sets
  };
  explicit Input(Signal signal);

 private:
  const std::string subject_;
};

using Inputs = std::vector<std::unique_ptr<Input>>;

/// Returns all inputs that a simulation's model can have; it is at t = 0.
Inputs possible_inputs(const Simulation& simulation);

/// Returns the inputs of these names, in their order; without names the usual ones. Throws
/// InputError, with the nearest name, for one that there is not, one named twice, and two that set
/// one thing.
Inputs choose_inputs(const Simulation& simulation, const std::vector<std::string>& names);

}  // namespace spoke::fmu
