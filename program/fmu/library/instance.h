#pragma once

// One instance of an FMU: a simulation between two communication points.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/simulation.h"
#include "program/fmu/contents.h"
#include "program/fmu/inputs.h"
#include "program/fmu/library/log.h"
#include "program/fmu/library/model_state.h"

namespace spoke::fmu {

/// What an importer says when it makes an instance.
struct InstanceRequest {
  std::string name;       ///< of the instance, for messages
  std::string token;      ///< of the model description that it has read: instantiationToken, guid
  std::string resources;  ///< folder of the FMU's resources
  MessageSink messages;
};

/// An instance. All functions throw InputError where the importer may not call them, or not so,
/// and the instance is as before; other errors of Spoke where the model has failed, and the
/// instance may then only be reset, or set to another state.
class Instance {
 public:
  /// Reads the scenario and starts its simulation.
  explicit Instance(const InstanceRequest& request);

  const std::string& name() const { return name_; }
  MessageSink& messages() { return messages_; }

  /// Takes the importer's times of start and stop [s], before initialization; else the start is 0,
  /// and there is no stop.
  void set_times(double start, std::optional<double> stop);
  void enter_initialization();
  void exit_initialization();
  void terminate();
  void reset();
  /// Makes steps from a communication point to the next one [s], which is not beyond the stop.
  void do_step(double point, double step);
  /// Returns the importer's time up to which the simulation has come [s].
  double time() const;

  void get(std::span<const std::uint32_t> references, std::span<double> values) const;
  void set(std::span<const std::uint32_t> references, std::span<const double> values);

  /// Lets messages of some categories come, or not; without names those of all. Errors always come.
  void set_logging(bool is_on, const std::vector<std::string>& categories);

  // States that the importer holds by handles; it frees them, or they go with the instance.

  /// Saves the state, in place of one that is held if `held` is not null, and returns its handle.
  void* save(const void* held);
  void go_back(const void* held);
  void forget(const void* held);
  std::string serialize(const void* held) const;
  /// Returns the bytes likewise; there must be `place` for them.
  std::string serialize(const void* held, std::size_t place) const;
  void* deserialize(std::string_view bytes);

 private:
  ModelState state() const;
  void put(const ModelState& state);
  ModelState& find(const void* held) const;
  void require(bool is_allowed, const char* what) const;
  void apply_inputs(double step);

  std::string name_;
  MessageSink messages_;
  Contents contents_;
  std::optional<Simulation> simulation_;
  Inputs inputs_;
  std::vector<std::size_t> outputs_;  ///< places of the sensors
  Courses courses_;
  std::vector<InputValue> values_;
  std::vector<std::unique_ptr<ModelState>> states_;
  std::optional<ModelState> begin_;  ///< as it was made
  Mode mode_ = Mode::instantiated;
  double start_time_ = 0.0;
  std::optional<double> stop_time_;
};

}  // namespace spoke::fmu
