// Finds loads of the system by the names that the scenario gives them, and replaces courses.

#include "engine/courses.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "engine/simulation/simulation_core.h"
#include "models/air/hub_wind.h"
#include "models/error.h"
#include "models/reader/scenario_check.h"
#include "models/support/nearest_name.h"
#include "models/tree/hub_place.h"

namespace spoke {
namespace {

/// Visits the loads of a rotor or of a model in space.
template <class Model, class Visit>
void visit_loads(const Model& model, const Visit& visit) {
  for (const auto& load : model.loads) visit(load.name);
  for (const auto& load : model.distributed_loads) visit(load.name);
  if constexpr (requires { model.drags; })
    for (const auto& drag : model.drags) visit(drag.name);
  for (const auto& load : model.hub_loads) visit(load.name);
}

/// The loads of one name in a system, and the factors that they had.
template <class World>
class NamedLoads {
 public:
  /// `hub_loads`: those of the scenario that is simulated.
  template <class HubLoads>
  NamedLoads(System<World>& system, const HubLoads& hub_loads, std::string_view name) {
    const auto take = [&](auto& load) {
      if (load.course->name == name) courses_.push_back({load.course, load.course->scale});
    };
    for (Subsystem<World>& subsystem : system.subsystems)
      for (TreeBody<World>& body : subsystem.bodies) {
        for (BodyLoad<World>& load : body.loads) take(load);
        for (BodyDrag<World>& drag : body.drags) take(drag);
      }
    // On a support they are among the loads of the bodies.
    for (std::size_t k = 0; k < system.hub_loads.size(); ++k)
      if (hub_loads[k].name == name)
        factors_.push_back({&system.hub_loads[k].factor, hub_loads[k].factor, {}});
  }

  void multiply(double factor) {
    for (const NamedCourse& load : courses_) load.course->scale = factor;
    for (HubFactor& load : factors_) {
      std::vector<double> values = load.given.values();
      for (double& value : values) value *= factor;
      load.before = std::exchange(*load.place, Curve(load.given.times(), std::move(values)));
    }
  }
  void put_back() {
    for (const NamedCourse& load : courses_) load.course->scale = load.before;
    for (const HubFactor& load : factors_) *load.place = load.before;
  }

 private:
  struct NamedCourse {
    std::shared_ptr<LoadCourse> course;  ///< of all copies of the load, those of readings too
    double before;
  };
  struct HubFactor {
    Curve* place;
    Curve given, before;
  };
  std::vector<NamedCourse> courses_;
  std::vector<HubFactor> factors_;
};

void require_factor(const Scenario& scenario, std::string_view load, double factor) {
  const std::vector<std::string> names = load_names(scenario);
  const std::vector<std::string_view> views(names.begin(), names.end());
  if (names.empty())
    throw InputError("the load \"" + std::string(load) + "\": no load of the scenario has a name");
  if (std::find(views.begin(), views.end(), load) == views.end())
    throw InputError("the load " + describe_unknown(std::string(load), views));
  if (!std::isfinite(factor))
    throw InputError("the factor of the load \"" + std::string(load) +
                     "\" is not finite, expected a number");
}

/// Calls `use` with the loads of a name.
template <class Use>
void with_loads(SimulationCore& core, std::string_view name, const Use& use) {
  if (SystemContext<Plane>* plane = core.model->plane()) {
    NamedLoads<Plane> loads(plane->system, core.scenario.rotor.hub_loads, name);
    return use(loads);
  }
  NamedLoads<Space> loads(core.model->space()->system, core.scenario.space->hub_loads, name);
  use(loads);
}

/// Multiplies the loads of a name without evaluating what follows.
void put_factor(SimulationCore& core, const std::string& name, double factor) {
  with_loads(core, name, [factor](auto& loads) { loads.multiply(factor); });
  core.load_factors[name] = factor;
}

template <class OfJoint>
JointPlace place_of(const OfJoint& joint) {
  return {joint.tree, joint.joint, joint.coordinate};
}

/// Returns the place of a torque that the program adds to others. Throws InputError.
double& find_added_torque(SimulationCore& core, const JointTorque& torque) {
  SpatialJoints& joints = core.joints("the torque on a joint");
  double& place = joints.added_torque(place_of(torque));
  if (!std::isfinite(torque.torque))
    throw InputError("the torque on " + joints.describe(place_of(torque)) +
                     " is not finite, expected a number");
  return place;
}

/// Notes a torque in place of the one before.
void note_torque(SimulationCore& core, const JointTorque& torque) {
  for (JointTorque& known : core.torques)
    if (known.tree == torque.tree && known.joint == torque.joint &&
        known.coordinate == torque.coordinate) {
      known = torque;
      return;
    }
  core.torques.push_back(torque);
}

/// Puts torques in force in place of all others, without evaluating what follows.
void put_torques(SimulationCore& core, const std::vector<JointTorque>& torques) {
  for (const JointTorque& known : core.torques) find_added_torque(core, known) = 0.0;
  core.torques = torques;
  for (const JointTorque& torque : torques) find_added_torque(core, torque) = torque.torque;
}

space::DrivenMotion motion_of(const JointCourse& joint) {
  if (joint.curve) return spatial::MotionTable{*joint.curve};
  return space::SaidMotion{joint.begin, joint.motion.value, joint.motion.velocity,
                           joint.motion.acceleration};
}

JointCourse course_of(const JointPlace& place, const space::DrivenMotion& motion) {
  JointCourse course;
  course.tree = place.subsystem;
  course.joint = place.joint;
  course.coordinate = place.coordinate;
  if (const auto* table = std::get_if<spatial::MotionTable>(&motion)) {
    course.curve = table->value;
    return course;
  }
  const auto& said = std::get<space::SaidMotion>(motion);
  course.begin = said.since;
  course.motion = {said.value, said.rate, said.acceleration};
  return course;
}

decltype(AnchorModel::motion) motion_of(const AnchorCourse& anchor) {
  if (anchor.curves) return *anchor.curves;
  return motion_since(anchor.begin, anchor.motion);
}

AnchorCourse course_of(const AnchorModel& anchor) {
  AnchorCourse course;
  course.anchor = anchor.name;
  if (const auto* curves = std::get_if<spatial::MountMotion>(&anchor.motion)) {
    course.curves = *curves;
    return course;
  }
  const auto& said = std::get<SaidAnchorMotion>(anchor.motion);
  course.begin = said.since;
  course.motion = vectors_of<AnchorMotion>(said);
  return course;
}

/// Returns the wind of a simulation. Throws InputError if no air acts on its model.
std::shared_ptr<const WindField>& wind_of(SimulationCore& core) {
  SystemContext<Space>* space = core.model->space();
  if (!space || !space->system.wind)
    throw InputError(
        "the wind: no air acts on the model, expected one in space with [air] and "
        "aerodynamics of blades");
  return space->system.wind;
}

/// Returns a wind that follows a course, in place of the one in force. Throws InputError.
std::shared_ptr<const WindField> make_hub_wind(SimulationCore& core, const WindCourse& course) {
  const std::shared_ptr<const WindField>& in_force = wind_of(core);
  if (!std::isfinite(course.begin) || !std::isfinite(course.end) || !course.velocity.allFinite() ||
      !course.target.allFinite())
    throw InputError("the wind at the hub is not finite, expected numbers");
  if (const auto* own = dynamic_cast<const air::HubWind*>(in_force.get())) return own->with(course);
  const spatial::Model& model = *core.scenario.space;
  return std::make_shared<air::HubWind>(model.air->wind, in_force, find_hub_place(model), course);
}

/// Whether the velocity at the hub says that at all places, as it does of winds at the hub.
bool is_known_at_hub(SimulationCore& core) {
  if (dynamic_cast<const air::HubWind*>(wind_of(core).get())) return true;
  const Wind& wind = core.scenario.space->air->wind;
  if (wind.vertical_shear != 0.0 || wind.horizontal_shear != 0.0) return false;
  return wind.gusts.empty() && !wind.turbulence && wind.file.empty() && !wind.by_program &&
         !wind.field;
}

/// Returns the wind of the scenario.
std::shared_ptr<const WindField> scenario_wind(const std::shared_ptr<const WindField>& in_force) {
  const auto* set = dynamic_cast<const air::HubWind*>(in_force.get());
  return set ? set->replaced() : in_force;
}

/// Throws InputError unless a drive could be put in force.
void require_drive(SimulationCore& core, const Drive& drive, int rotor) {
  check_drive(drive);
  if (prescribes_motion(drive) != prescribes_motion(core.model->drive(rotor)))
    throw InputError((rotor == 0
                          ? "hub.drive"
                          : "the drive of \"" + hub_of(*core.scenario.space, rotor).name + '"') +
                     ": the drive to go back to and the one in force do not both "
                     "prescribe the rotation of the hub, expected two of one kind");
}

/// Throws InputError unless all courses could be put in force.
void require_courses(SimulationCore& core, const Courses& courses) {
  require_drive(core, courses.drive, 0);
  for (const RotorDrive& of : courses.rotors)
    require_drive(core, of.drive, core.find_rotor(of.rotor));
  for (const JointCourse& joint : courses.joints) {
    core.joints("the motion of a joint").said_motion(place_of(joint));
    const CoordinateMotion& motion = joint.motion;
    for (const double value : {joint.begin, motion.value, motion.velocity, motion.acceleration})
      if (!std::isfinite(value))
        throw InputError("the motion of a joint to go back to is not finite, expected numbers");
  }
  for (const AnchorCourse& anchor : courses.anchors) {
    core.model->anchors().said(anchor.anchor);
    const SaidAnchorMotion motion = motion_since(anchor.begin, anchor.motion);
    if (!std::isfinite(motion.since) || !motion.value.allFinite() || !motion.rate.allFinite() ||
        !motion.acceleration.allFinite())
      throw InputError("the motion of " + describe_anchor(anchor.anchor) +
                       " to go back to is not finite, expected numbers");
  }
  for (const LoadFactor& load : courses.loads)
    require_factor(core.scenario, load.load, load.factor);
  if (courses.wind) make_hub_wind(core, *courses.wind);
  for (const JointTorque& torque : courses.torques) find_added_torque(core, torque);
}

}  // namespace

std::vector<std::string> load_names(const Scenario& scenario) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  };
  if (scenario.space)
    visit_loads(*scenario.space, add);
  else
    visit_loads(scenario.rotor, add);
  return names;
}

void set_load_factor(Simulation& simulation, std::string_view load, double factor) {
  SimulationCore& core = core_of(simulation);
  core.require_state("go on from with another factor of a load");
  require_factor(core.scenario, load, factor);
  with_loads(core, load, [&](auto& loads) {
    loads.multiply(factor);
    try {
      core.renew();
    } catch (...) {
      loads.put_back();
      throw;
    }
  });
  core.load_factors[std::string(load)] = factor;
}

void set_joint_torque(Simulation& simulation, int tree, int joint, int coordinate, double torque) {
  SimulationCore& core = core_of(simulation);
  const JointTorque next{tree, joint, coordinate, torque};
  double& in_force = find_added_torque(core, next);
  core.require_state("go on from with another torque on a joint");
  if (in_force != torque) core.replace(in_force, torque);
  note_torque(core, next);
}

void set_wind(Simulation& simulation, const WindCourse& course) {
  SimulationCore& core = core_of(simulation);
  core.require_state("go on from with another wind");
  std::shared_ptr<const WindField> next = make_hub_wind(core, course);
  std::shared_ptr<const WindField>& in_force = wind_of(core);
  if (is_known_at_hub(core) && wind_at_hub(simulation) == course.at(simulation.time()))
    in_force = std::move(next);
  else
    core.replace(in_force, std::move(next));
}

Eigen::Vector3d wind_at_hub(const Simulation& simulation) {
  SimulationCore& core = core_of(const_cast<Simulation&>(simulation));  // changes nothing
  const std::shared_ptr<const WindField>& in_force = wind_of(core);
  return in_force->velocity(find_hub_place(*core.scenario.space), simulation.time());
}

std::optional<Eigen::Vector3d> find_mean_wind(const Scenario& scenario) {
  if (!scenario.space || !scenario.space->air) return std::nullopt;
  const spatial::Model& model = *scenario.space;
  const bool acts = std::any_of(model.blades.begin(), model.blades.end(),
                                [](const auto& blade) { return blade.aerodynamics.has_value(); });
  const Eigen::Vector3d hub = find_hub_place(model);
  if (!acts || air::find_hub_wind_fault(model.air->wind, hub)) return std::nullopt;
  return make_wind(model.air->wind)->mean(hub);
}

Courses courses(const Simulation& simulation) {
  SimulationCore& core = core_of(const_cast<Simulation&>(simulation));  // changes nothing
  Courses found;
  found.drive = core.own_drive(0);
  if (core.scenario.space)
    for (int r = 1; r < count_rotors(*core.scenario.space); ++r)
      found.rotors.push_back({hub_of(*core.scenario.space, r).name, core.model->drive(r)});
  if (SpatialJoints* joints = core.model->joints())
    for (const JointPlace& place : joints->said())
      found.joints.push_back(course_of(place, joints->said_motion(place)));
  for (const AnchorModel* anchor : core.model->anchors().said())
    found.anchors.push_back(course_of(*anchor));
  for (const std::string& name : load_names(core.scenario)) {
    const auto factor = core.load_factors.find(name);
    found.loads.push_back({name, factor == core.load_factors.end() ? 1.0 : factor->second});
  }
  if (core.model->space() && core.model->space()->system.wind)
    if (const auto* wind = dynamic_cast<const air::HubWind*>(wind_of(core).get()))
      found.wind = wind->course();
  found.torques = core.torques;
  return found;
}

void restore(Simulation& simulation, const SavedState& state, const Courses& courses) {
  SimulationCore& core = core_of(simulation);
  require_courses(core, courses);
  core.restore(state);  // changes nothing if it throws; nothing below does
  core.put_drive(courses.drive, 0);
  for (const RotorDrive& of : courses.rotors) core.put_drive(of.drive, core.find_rotor(of.rotor));
  for (const JointCourse& joint : courses.joints)
    core.put_joint_motion(place_of(joint), motion_of(joint));
  for (const AnchorCourse& anchor : courses.anchors)
    core.put_anchor_motion(anchor.anchor, motion_of(anchor));
  for (const LoadFactor& load : courses.loads) put_factor(core, load.load, load.factor);
  put_torques(core, courses.torques);
  if (core.model->space() && core.model->space()->system.wind) {
    std::shared_ptr<const WindField>& in_force = wind_of(core);
    in_force = courses.wind ? make_hub_wind(core, *courses.wind) : scenario_wind(in_force);
  }
}

}  // namespace spoke
