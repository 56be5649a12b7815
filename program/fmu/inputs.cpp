// Torque and speed of the drive, factors of loads, the wind at the hub, and joints that the
// scenario leaves to the program.

#include "program/fmu/inputs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "models/drive.h"
#include "models/error.h"
#include "models/support/nearest_name.h"
#include "program/fmu/speed_course.h"

namespace spoke::fmu {
namespace {

/// Whether a speed is the one asked for but for round-off.
bool is_there(double speed, double target) {
  return std::abs(speed - target) <= 1e-12 * (1.0 + std::abs(target));
}

/// Sets the drive of a rotor.
class DriveInput : public Input {
 public:
  void begin(const Simulation& simulation, Courses& courses) const final {
    if (rotor_.empty())
      courses.drive = simulation.drive();
    else
      courses.rotors.push_back({rotor_, simulation.drive(rotor_)});
  }

 protected:
  /// `rotor`: its name; empty: the first.
  DriveInput(const std::string& rotor, Signal signal)
      : Input(for_rotor(rotor, std::move(signal))), rotor_(rotor) {}

  Drive& in_force(Courses& courses) const {
    if (rotor_.empty()) return courses.drive;
    const auto own = std::find_if(courses.rotors.begin(), courses.rotors.end(),
                                  [this](const RotorDrive& of) { return of.rotor == rotor_; });
    assert(own != courses.rotors.end());
    return own->drive;
  }
  void set(const Drive& next, Simulation& simulation, Courses& courses) const {
    simulation.set_drive(next, rotor_);
    in_force(courses) = next;
  }

 private:
  static Signal for_rotor(const std::string& rotor, Signal signal) {
    if (rotor.empty()) return signal;
    signal.name = rotor + '.' + signal.name;
    signal.description += ", rotor \"" + rotor + '"';
    signal.subject = rotor + '.' + signal.subject;
    return signal;
  }

  const std::string rotor_;
};

class TorqueInput final : public DriveInput {
 public:
  TorqueInput(const std::string& rotor, const Drive& drive)
      : DriveInput(rotor, {"drive.torque", "N m", "Torque of the drive on the hub",
                           calc_torque(drive, 0.0, calc_initial_speed(drive)), true, "drive"}) {}

  void apply(double value, double, Simulation& simulation, Courses& courses) const override {
    const auto* torque = std::get_if<TorqueDrive>(&in_force(courses));
    if (torque && torque->torque.values() == std::vector{value}) return;
    set(TorqueDrive{Curve(value), calc_initial_speed(in_force(courses))}, simulation, courses);
  }
};

class SpeedInput final : public DriveInput {
 public:
  SpeedInput(const std::string& rotor, const Drive& drive)
      : DriveInput(rotor, {"drive.speed", "rad/s",
                           "Speed that the hub reaches at the end of a communication step",
                           calc_motion(drive, 0.0).speed, true, "drive"}) {}

  void apply(double value, double step, Simulation& simulation, Courses& courses) const override {
    const double t = simulation.time();
    const DriveMotion now = calc_motion(in_force(courses), t);
    if (now.speed == value && now.acceleration == 0.0) return;
    const double speed = is_there(now.speed, value) ? value : now.speed;
    set(SpeedTable{speed_course(t, now.angle, speed, value, step)}, simulation, courses);
  }
};

class LoadInput final : public Input {
 public:
  explicit LoadInput(const std::string& load)
      : Input({"load." + load, "1", "Factor of the loads \"" + load + "\" of the scenario", 1.0,
               true, "load." + load}),
        load_(load) {}

  void begin(const Simulation&, Courses& courses) const override {
    courses.loads.push_back({load_, 1.0});
  }
  void apply(double value, double, Simulation& simulation, Courses& courses) const override {
    double& factor =
        std::find_if(courses.loads.begin(), courses.loads.end(), [this](const LoadFactor& load) {
          return load.load == load_;
        })->factor;
    if (value == factor) return;  // another evaluation would change the last bits
    set_load_factor(simulation, load_, value);
    factor = value;
  }

 private:
  std::string load_;
};

/// A component of the wind's velocity at the hub, reached at the end of a communication step.
class WindInput final : public Input {
 public:
  /// mean: of the scenario's wind there [m/s].
  WindInput(int component, const Eigen::Vector3d& mean)
      : Input(
            {std::string("wind.") + "xyz"[component], "m/s",
             "Velocity of the wind at the hub's place, reached at the end of a communication step",
             mean[component], true, std::string("wind.") + "xyz"[component]}),
        component_(component),
        mean_(mean) {}

  void begin(const Simulation&, Courses&) const override {}
  void apply(double value, double step, Simulation& simulation, Courses& courses) const override {
    WindCourse next = course_from_now(step, simulation, courses);
    next.target[component_] = value;
    set_wind(simulation, next);
    courses.wind = next;
  }

 private:
  /// Returns the course that the other components have set for the same step, or one that goes on
  /// with the targets in force. At first these are the means: gusts and turbulence end.
  WindCourse course_from_now(double step, const Simulation& simulation,
                             const Courses& courses) const {
    const double t = simulation.time(), own = simulation.step_size();
    if (courses.wind && courses.wind->begin == t && courses.wind->end > t) return *courses.wind;
    const auto steps = static_cast<double>(simulation.steps()) + std::round(step / own);
    const Eigen::Vector3d velocity = courses.wind ? courses.wind->at(t) : wind_at_hub(simulation);
    return {t, steps * own, velocity, courses.wind ? courses.wind->target : mean_};
  }

  int component_;
  Eigen::Vector3d mean_;
};

/// A coordinate of a joint, as it is found in a scenario.
struct Coordinate {
  int tree = 0;
  std::string joint;
  int coordinate = 0;
  std::string name;  ///< "blade1.pitch", of several coordinates "blade1.joint.2"
  std::string unit;  ///< "rad" or "m"
  /// Whether the scenario leaves its motion to the program.
  bool is_programs = false;
  bool is_free = false;
};

/// The motion of a joint's coordinate, by its velocity or its acceleration.
class JointInput final : public Input {
 public:
  enum class Given { velocity, acceleration };

  JointInput(const Coordinate& at, Given given)
      : Input(describe(at, given)), at_(at), given_(given) {}

  void begin(const Simulation& simulation, Courses& courses) const override {
    const int joint = simulation.joint_index(at_.tree, at_.joint);
    courses.joints.push_back({at_.tree, joint, at_.coordinate, 0.0,
                              simulation.joint_motion(at_.tree, joint, at_.coordinate)});
  }
  void apply(double value, double step, Simulation& simulation, Courses& courses) const override {
    JointCourse& course = find(simulation, courses);
    CoordinateMotion next = simulation.joint_motion(course.tree, course.joint, course.coordinate);
    if (given_ == Given::velocity) {
      if (is_there(next.velocity, value)) next.velocity = value;
      value = (value - next.velocity) / step;
    }
    // One that goes on as it is needs no other evaluation of the accelerations.
    if (value == next.acceleration && (value != 0.0 || next.velocity == course.motion.velocity))
      return;
    next.acceleration = value;
    simulation.set_joint_motion(course.tree, course.joint, course.coordinate, next);
    course.begin = simulation.time();
    course.motion = next;
  }

 private:
  static Signal describe(const Coordinate& at, Given given) {
    const bool is_velocity = given == Given::velocity;
    return {at.name + (is_velocity ? ".velocity" : ".acceleration"),
            at.unit + (is_velocity ? "/s" : "/s^2"),
            is_velocity ? "Velocity that the joint reaches at the end of a communication step"
                        : "Acceleration of the joint over a communication step",
            0.0,
            is_velocity,
            at.name};
  }
  JointCourse& find(const Simulation& simulation, Courses& courses) const {
    const int joint = simulation.joint_index(at_.tree, at_.joint);
    return *std::find_if(courses.joints.begin(), courses.joints.end(),
                         [this, joint](const JointCourse& course) {
                           return course.tree == at_.tree && course.joint == joint &&
                                  course.coordinate == at_.coordinate;
                         });
  }

  Coordinate at_;
  Given given_;
};

/// The torque, or force, of a motor on a free coordinate of a joint.
class MotorInput final : public Input {
 public:
  explicit MotorInput(const Coordinate& at) : Input(describe(at)), at_(at) {}

  void begin(const Simulation& simulation, Courses& courses) const override {
    courses.torques.push_back(
        {at_.tree, simulation.joint_index(at_.tree, at_.joint), at_.coordinate, 0.0});
  }
  void apply(double value, double, Simulation& simulation, Courses& courses) const override {
    const int joint = simulation.joint_index(at_.tree, at_.joint);
    set_joint_torque(simulation, at_.tree, joint, at_.coordinate, value);
    for (JointTorque& torque : courses.torques)
      if (torque.tree == at_.tree && torque.joint == joint && torque.coordinate == at_.coordinate)
        torque.torque = value;
  }

 private:
  static Signal describe(const Coordinate& at) {
    const bool slides = at.unit == "m";
    const std::string what = slides ? "Force" : "Torque";
    return {at.name + (slides ? ".force" : ".torque"),
            slides ? "N" : "N m",
            what + " of a motor on the joint, besides what the scenario says",
            0.0,
            false,
            at.name};
  }

  Coordinate at_;
};

/// Adds the coordinates of a joint. Joints without a name have none that an importer could see.
void add_coordinates(const spatial::Joint& joint, int tree, const std::string& tree_name,
                     std::vector<Coordinate>& found) {
  if (joint.name.empty()) return;
  const int count = spatial::count_coordinates(joint.kind);
  for (int c = 0; c < count; ++c) {
    const auto& motion = joint.coordinates[static_cast<std::size_t>(c)].motion;
    found.push_back({tree, joint.name, c,
                     tree_name + '.' + joint.name + (count > 1 ? '.' + std::to_string(c + 1) : ""),
                     spatial::slides(joint.kind, c) ? "m" : "rad",
                     motion && std::holds_alternative<spatial::ProgramMotion>(*motion), !motion});
  }
}

std::vector<Coordinate> find_coordinates(const spatial::Model& model) {
  std::vector<Coordinate> found;
  int tree = 0;
  for (std::size_t i = 0; i < model.blades.size(); ++i, ++tree)
    for (const spatial::BladeJoint& joint : model.blades[i].joints)
      add_coordinates(joint.joint, tree, "blade" + std::to_string(i + 1), found);
  for (const spatial::Subsystem& subsystem : model.subsystems) {
    for (const spatial::SubsystemJoint& joint : subsystem.joints)
      add_coordinates(joint.joint, tree, subsystem.name, found);
    ++tree;
  }
  return found;
}

/// Throws InputError that says why there is no such input.
[[noreturn]] void refuse(const std::string& name, const std::vector<std::string_view>& known,
                         const Scenario& scenario) {
  if (scenario.space)
    for (const Coordinate& at : find_coordinates(*scenario.space)) {
      if (at.is_programs || !name.starts_with(at.name + '.')) continue;
      if (at.is_free && !name.ends_with(".velocity") && !name.ends_with(".acceleration")) continue;
      const auto& control = scenario.space->pitch_control;
      const bool is_controlled =
          control && std::find(control->joints.begin(), control->joints.end(), at.joint) !=
                         control->joints.end();
      throw InputError("the input \"" + name + "\": " +
                       (is_controlled ? "[control.pitch] moves that joint, expected no control of "
                                        "it and"
                                      : "the scenario does not leave that joint to the program, "
                                        "expected") +
                       " motion = { by = \"program\" }");
    }
  if (known.empty()) throw InputError("the input \"" + name + "\": this model has no inputs");
  throw InputError("the input " + describe_unknown(name, known));
}

bool is_free(const Scenario& scenario) {
  const HubSupport support =
      scenario.space ? scenario.space->hub.support : scenario.rotor.hub.support;
  return support == HubSupport::free;
}

}  // namespace

Input::Input(Signal signal)
    : name(std::move(signal.name)),
      unit(std::move(signal.unit)),
      description(std::move(signal.description)),
      start(signal.start),
      is_usual(signal.is_usual),
      subject_(std::move(signal.subject)) {}

Inputs possible_inputs(const Simulation& simulation) {
  Inputs inputs;
  const Scenario& scenario = simulation.scenario();
  const auto add_drive = [&](const std::string& rotor) {
    const Drive& drive = simulation.drive(rotor);
    if (prescribes_motion(drive))
      inputs.push_back(std::make_unique<SpeedInput>(rotor, drive));
    else if (!scenario.space || !is_free(scenario))  // in space a free hub has no drive
      inputs.push_back(std::make_unique<TorqueInput>(rotor, drive));
  };
  add_drive("");
  if (scenario.space)
    for (const spatial::Rotor& rotor : scenario.space->rotors)
      if (!std::holds_alternative<FixedDrive>(rotor.hub.drive)) add_drive(rotor.hub.name);
  for (const std::string& load : load_names(scenario))
    inputs.push_back(std::make_unique<LoadInput>(load));
  if (const std::optional<Eigen::Vector3d> mean = find_mean_wind(scenario))
    for (const int component : {0, 1, 2})
      inputs.push_back(std::make_unique<WindInput>(component, *mean));
  if (scenario.space)
    for (const Coordinate& at : find_coordinates(*scenario.space)) {
      if (at.is_free) inputs.push_back(std::make_unique<MotorInput>(at));
      if (!at.is_programs) continue;
      for (const auto given : {JointInput::Given::velocity, JointInput::Given::acceleration})
        inputs.push_back(std::make_unique<JointInput>(at, given));
    }
  return inputs;
}

Inputs choose_inputs(const Simulation& simulation, const std::vector<std::string>& names) {
  Inputs possible = possible_inputs(simulation), chosen;
  if (names.empty()) {
    for (auto& input : possible)
      if (input->is_usual) chosen.push_back(std::move(input));
    return chosen;
  }
  std::vector<std::string_view> known;
  for (const auto& input : possible) known.push_back(input->name);
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) refuse(name, known, simulation.scenario());
    auto& input = possible[static_cast<std::size_t>(found - known.begin())];
    if (!input) throw InputError("the input \"" + name + "\" is named twice, expected it once");
    for (const auto& other : chosen)
      if (other->excludes(*input))
        throw InputError("the inputs \"" + other->name + "\" and \"" + name +
                         "\" set the same motion, expected one of them");
    chosen.push_back(std::move(input));
  }
  return chosen;
}

}  // namespace spoke::fmu
