// The simulation of an instance stands at a communication point; inputs wait there for the step.

#include "program/fmu/library/instance.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <utility>

#include "models/error.h"
#include "models/text_file.h"

namespace spoke::fmu {
namespace {

/// Share of a step by which times of the importer may differ from multiples of steps.
constexpr double kSlack = 1e-4;

Contents load_contents(const std::filesystem::path& resources) {
  const std::filesystem::path file = resources / kContentsFile;
  return read_contents(read_text(file, "the resources of this FMU"), file.string());
}

/// Returns the time up to which the wind of a scenario's file is known [s].
double find_end_of_wind(const Scenario& scenario) {
  const bool has_file =
      scenario.space && scenario.space->air && !scenario.space->air->wind.file.empty();
  return has_file ? make_wind(scenario.space->air->wind)->end()
                  : std::numeric_limits<double>::infinity();
}

/// Lets a scenario go on as long as an importer likes, or its file of wind lasts, with the same
/// step to the last bit: the duration is doubled. (Durations that are not whole numbers of steps
/// are known by 1e-9 of it.)
void extend(const Contents& contents, Scenario& scenario) {
  constexpr double kMostSteps = 5e8;
  scenario.integration.step = contents.step;
  double& duration = scenario.integration.duration;
  const double longest = std::min(kMostSteps * contents.step, find_end_of_wind(scenario));
  while (2.0 * duration <= longest) duration *= 2.0;
}

SimulationOptions serial() {
  SimulationOptions options;
  options.executor = ExecutorKind::serial;
  options.threads = 1;
  options.window = 1;
  return options;
}

Simulation make_simulation(const std::filesystem::path& resources, const Contents& contents) {
  Scenario scenario = read_scenario((resources / contents.scenario).string(), contents.overrides);
  extend(contents, scenario);
  Simulation simulation(scenario, serial());
  if (simulation.step_size() != contents.step)
    throw Error(ErrorCode::internal, "the step of the simulation is not that of the scenario");
  return simulation;
}

/// Returns a time for messages, with digits enough to tell those of long simulations apart.
std::string seconds(double time) {
  std::ostringstream text;
  text.precision(12);
  text << time << " s";
  return text.str();
}

/// Whether a value is another one than the start value, by more than the round-off of importers
/// that interpolate between two values.
bool is_other(double value, double start) {
  return std::abs(value - start) > 1e-12 * std::abs(start);
}

/// Whether two courses are of the same rotors, joints and loads, in the same order.
bool has_same_places(const Courses& one, const Courses& other) {
  const auto is_same_joint = [](const JointCourse& a, const JointCourse& b) {
    return a.tree == b.tree && a.joint == b.joint && a.coordinate == b.coordinate;
  };
  const auto is_same_rotor = [](const RotorDrive& a, const RotorDrive& b) {
    return a.rotor == b.rotor;
  };
  const auto is_same_load = [](const LoadFactor& a, const LoadFactor& b) {
    return a.load == b.load;
  };
  return std::equal(one.rotors.begin(), one.rotors.end(), other.rotors.begin(), other.rotors.end(),
                    is_same_rotor) &&
         std::equal(one.joints.begin(), one.joints.end(), other.joints.begin(), other.joints.end(),
                    is_same_joint) &&
         std::equal(one.loads.begin(), one.loads.end(), other.loads.begin(), other.loads.end(),
                    is_same_load);
}

const char* name_of(Mode mode) {
  switch (mode) {
    case Mode::instantiated:
      return "instantiated";
    case Mode::initialization:
      return "in initialization mode";
    case Mode::step:
      return "in step mode";
    case Mode::terminated:
      return "terminated";
    case Mode::failed:
      break;
  }
  return "failed, and can only be reset, freed or set to another state";
}

}  // namespace

Instance::Instance(const InstanceRequest& request)
    : name_(request.name), messages_(request.messages) {
  if (request.resources.empty())
    throw InputError("the path of the resources is missing, expected the folder of the FMU's");
  contents_ = load_contents(request.resources);
  if (request.token != contents_.token)
    throw InputError("the token (instantiationToken, guid) is \"" + request.token +
                     "\", expected \"" + contents_.token + "\", as in modelDescription.xml");
  simulation_.emplace(make_simulation(request.resources, contents_));
  if (!contents_.inputs.empty()) inputs_ = choose_inputs(*simulation_, contents_.inputs);
  for (const auto& input : inputs_) {
    values_.push_back({input->start});
    input->begin(*simulation_, courses_);
  }
  courses_.drive = simulation_->drive();
  for (const std::string& output : contents_.outputs)
    outputs_.push_back(simulation_->sensor_index(output));
  begin_ = state();
}

void Instance::require(bool is_allowed, const char* what) const {
  if (!is_allowed) throw InputError(std::string(what) + ", but the instance is " + name_of(mode_));
}

void Instance::set_times(double start, std::optional<double> stop) {
  require(mode_ == Mode::instantiated, "times are set once, after instantiation");
  if (!std::isfinite(start) || (stop && !(*stop > start)))
    throw InputError("the times of start and stop are not finite or not in order");
  start_time_ = start;
  stop_time_ = stop;
}

void Instance::enter_initialization() {
  require(mode_ == Mode::instantiated, "initialization mode is entered once, after instantiation");
  mode_ = Mode::initialization;
}

void Instance::exit_initialization() {
  require(mode_ == Mode::initialization, "initialization mode is left where it was entered");
  mode_ = Mode::step;
}

void Instance::terminate() {
  require(mode_ == Mode::step, "an instance is terminated in step mode");
  mode_ = Mode::terminated;
}

void Instance::reset() { put(*begin_); }

double Instance::time() const { return start_time_ + simulation_->time(); }

void Instance::apply_inputs(double step) {
  for (std::size_t k = 0; k < inputs_.size(); ++k)
    if (values_[k].is_given) inputs_[k]->apply(values_[k].value, step, *simulation_, courses_);
}

void Instance::do_step(double point, double step) {
  require(mode_ == Mode::step, "steps are made in step mode");
  const double own = simulation_->step_size();
  if (!(std::abs(point - time()) <= kSlack * own))
    throw InputError("the communication point is " + seconds(point) + ", expected " +
                     seconds(time()) + ", up to where the simulation has come");
  const double count = std::round(step / own);
  if (!(count >= 1.0 && std::abs(step - count * own) <= kSlack * own))
    throw InputError("the communication step is " + seconds(step) +
                     ", expected a multiple of the model's step, " + seconds(own));
  if (stop_time_ && point + step > *stop_time_ + kSlack * own)
    throw InputError("the communication step goes to " + seconds(point + step) +
                     ", expected none beyond the stop time, " + seconds(*stop_time_));
  if (count > static_cast<double>(simulation_->planned_steps() - simulation_->steps()))
    throw InputError("the simulation has made as many steps as it can");
  mode_ = Mode::failed;  // unless all goes well
  apply_inputs(step);
  for (auto k = static_cast<std::int64_t>(count); k > 0; --k) simulation_->step();
  mode_ = Mode::step;
}

void Instance::get(std::span<const std::uint32_t> references, std::span<double> values) const {
  const std::size_t first_output = kFirstReference + inputs_.size();
  for (const std::uint32_t reference : references)
    if (reference >= first_output) {
      if (reference >= first_output + outputs_.size())
        throw InputError("there is no variable of value reference " + std::to_string(reference));
      require(mode_ != Mode::instantiated && mode_ != Mode::failed,
              "outputs have values from initialization mode on");
    }
  std::span<const double> sensors;
  for (std::size_t k = 0; k < references.size(); ++k) {
    const std::size_t reference = references[k];
    if (reference >= first_output && sensors.empty()) sensors = simulation_->sensor_values();
    values[k] = reference == kTimeReference ? time()
                : reference < first_output  ? values_[reference - kFirstReference].value
                                            : sensors[outputs_[reference - first_output]];
  }
}

void Instance::set(std::span<const std::uint32_t> references, std::span<const double> values) {
  require(mode_ == Mode::instantiated || mode_ == Mode::initialization || mode_ == Mode::step,
          "inputs are set before a step");
  for (std::size_t k = 0; k < references.size(); ++k) {
    const std::size_t reference = references[k];
    if (reference < kFirstReference || reference >= kFirstReference + inputs_.size())
      throw InputError("there is no input of value reference " + std::to_string(reference));
    if (!std::isfinite(values[k]))
      throw InputError("the input \"" + inputs_[reference - kFirstReference]->name +
                       "\" is not finite, expected a number");
  }
  for (std::size_t k = 0; k < references.size(); ++k) {
    const std::size_t place = references[k] - kFirstReference;
    InputValue& input = values_[place];
    input.is_given = input.is_given || is_other(values[k], inputs_[place]->start);
    input.value = values[k];
  }
}

ModelState Instance::state() const {
  require(mode_ != Mode::failed, "a state is saved where there is one");
  return {mode_, start_time_, stop_time_, values_, courses_, simulation_->save()};
}

void Instance::put(const ModelState& state) {
  restore(*simulation_, state.simulation, state.courses);
  courses_ = state.courses;
  values_ = state.inputs;
  start_time_ = state.start_time;
  stop_time_ = state.stop_time;
  mode_ = state.mode;
}

void Instance::set_logging(bool is_on, const std::vector<std::string>& categories) {
  bool warnings = categories.empty();
  for (const std::string& category : categories) {
    if (category != "logStatusWarning" && category != "logStatusError")
      throw InputError("there is no category \"" + category +
                       "\", expected logStatusWarning or logStatusError");
    warnings = warnings || category == "logStatusWarning";
  }
  if (warnings) messages_.warns = is_on;
}

ModelState& Instance::find(const void* held) const {
  const auto found = std::find_if(states_.begin(), states_.end(),
                                  [held](const auto& own) { return own.get() == held; });
  if (found == states_.end())
    throw InputError(
        "the state is none of this instance, expected one that it has saved or "
        "deserialized");
  return **found;
}

void* Instance::save(const void* held) {
  if (!held) return states_.emplace_back(std::make_unique<ModelState>(state())).get();
  ModelState& place = find(held);  // its memory is used again
  place = state();
  return &place;
}

void Instance::go_back(const void* held) { put(find(held)); }

void Instance::forget(const void* held) {
  const ModelState* state = &find(held);
  std::erase_if(states_, [state](const auto& each) { return each.get() == state; });
}

std::string Instance::serialize(const void* held) const {
  return write_state(find(held), contents_.token);
}

std::string Instance::serialize(const void* held, std::size_t place) const {
  std::string bytes = serialize(held);
  if (place < bytes.size())
    throw InputError("there is place for " + std::to_string(place) + " bytes, expected " +
                     std::to_string(bytes.size()));
  return bytes;
}

void* Instance::deserialize(std::string_view bytes) {
  ModelState state = read_state(bytes, contents_.token, begin_->courses);
  if (state.inputs.size() != inputs_.size() || !has_same_places(state.courses, courses_))
    throw InputError("the state is of an FMU with other inputs");
  return states_.emplace_back(std::make_unique<ModelState>(std::move(state))).get();
}

}  // namespace spoke::fmu
