// Rules for joints, and for the joints of a blade.

#include <Eigen/Geometry>
#include <cmath>
#include <set>
#include <string_view>

#include "models/reader/names.h"
#include "models/reader/spatial/fault.h"

namespace spoke::spatial {
namespace {

Fault find_axes_fault(const Joint& joint) {
  const int count = count_axes(joint.kind);
  if (count == 1) return find_direction_fault("axis", joint.axes[0]);
  const FirstFault first;
  for (int i = 0; i < count; ++i)
    first.add(find_direction_fault("axes." + std::to_string(i + 1),
                                   joint.axes[static_cast<std::size_t>(i)]));
  if (first.found() || count < 2) return first.found();
  const double sine = joint.axes[0].normalized().cross(joint.axes[1].normalized()).norm();
  if (sine > 1e-6) return {};
  return {"axes", "are parallel, expected two directions that differ"};
}

Fault find_stop_fault(const Stop& stop, const CoordinateUnits& unit) {
  const FirstFault first;
  visit_fields(stop, unit, first);
  if (!(stop.upper > stop.lower))
    first.add({"upper", "is " + describe(stop.upper) + ", expected more than lower, " +
                            describe(stop.lower)});
  return first.found();
}

Fault find_friction_fault(const Friction& friction, const CoordinateUnits& unit) {
  const FirstFault first;
  first("force", friction.force, Quantity::positive(unit.effort));
  first("speed", friction.speed, Quantity::positive(unit.speed));
  if (friction.static_force && !(*friction.static_force >= friction.force))
    first.add({"static", "is " + describe(*friction.static_force) + ", expected force or more, " +
                             describe(friction.force)});
  if (friction.static_force && !friction.stribeck)
    first.add({"stribeck",
               "is missing, expected the speed over which the force falls from static "
               "to force"});
  if (friction.stribeck && !friction.static_force)
    first.add({"stribeck", "would be ignored, expected only with static"});
  if (friction.static_force)
    first("static", *friction.static_force, Quantity::positive(unit.effort));
  if (friction.stribeck) first("stribeck", *friction.stribeck, Quantity::positive(unit.speed));
  return first.found();
}

Fault find_relaxation_fault(const Relaxation& relaxation, const CoordinateUnits& unit) {
  const FirstFault first;
  visit_fields(relaxation, unit, first);
  return first.found();
}

Fault find_motion_fault(const Motion& motion, const CoordinateUnits& unit) {
  const FirstFault first;
  if (const auto* table = std::get_if<MotionTable>(&motion))
    first.add(find_curve_fault("value", table->value, Quantity::any(unit.position)));
  if (const auto* azimuth = std::get_if<AzimuthMotion>(&motion))
    visit_fields(*azimuth, unit, first);
  if (const auto* program = std::get_if<ProgramMotion>(&motion))
    first("initial", program->initial, Quantity::any(unit.position));
  return first.found();
}

bool is_zero(const Curve& curve) {
  for (const double value : curve.values())
    if (value != 0.0) return false;
  return true;
}

/// Finds a prescribed coordinate that also has keys of a free one.
Fault find_double(const JointCoordinate& coordinate, JointKind kind, int index) {
  const FirstFault first;
  const auto refuse = [&](std::string_view key) {
    first.add({std::string(key),
               "given along with motion, expected only one of them: what is prescribed needs no "
               "spring, damper, stop, effort or start"});
  };
  visit_fields(coordinate, units_of(kind, index),
               [&](std::string_view key, double value, const Quantity&) {
                 if (value != 0.0) refuse(key);
               });
  if (coordinate.relaxation) refuse("relaxation");
  if (coordinate.stop) refuse("stop");
  if (coordinate.friction) refuse("friction");
  if (!is_zero(coordinate.effort)) refuse(slides(kind, index) ? "force" : "torque");
  return first.found();
}

/// Finds keys that a spherical joint cannot have.
Fault find_spherical_fault(const Joint& joint) {
  const FirstFault first;
  const auto count = static_cast<std::size_t>(count_coordinates(joint.kind));
  for (std::size_t i = 0; i < count; ++i) {
    const JointCoordinate& c = joint.coordinates[i];
    const auto refuse = [&](const char* key) {
      first.add({key, "does not belong to kind \"spherical\""});
    };
    if (c.motion) refuse("motion");
    if (c.stop) refuse("stop");
    if (c.friction) refuse("friction");
    if (c.relaxation) refuse("relaxation");
    if (c.rest != 0.0) refuse("rest");
    if (c.stiffness != joint.coordinates[0].stiffness)
      first.add({"stiffness", "differs between the coordinates, expected one for all three"});
    if (c.damping != joint.coordinates[0].damping)
      first.add({"damping", "differs between the coordinates, expected one for all three"});
  }
  return first.found();
}

/// Finds a fault of one direction of a bushing, which is held if it has neither spring nor damper.
Fault find_bushing_fault(const JointCoordinate& coordinate, int index) {
  const FirstFault first;
  const std::string number = '.' + std::to_string(index + 1);
  const bool is_loose = coordinate.stiffness == 0.0 && coordinate.damping == 0.0;
  const bool is_held = is_loose && !coordinate.moves_freely;
  if (coordinate.moves_freely && !is_loose)
    first.add({"free", "has \"" + std::string(kBushingDirections[static_cast<std::size_t>(index)]) +
                           "\", which has a spring or a damper; expected directions without"});
  visit_fields(
      coordinate, units_of(JointKind::bushing, index),
      [&](std::string_view key, double value, const Quantity& quantity) {
        first(std::string(key) + number, value, quantity);
        if (is_held && value != 0.0)
          first.add({std::string(key) + number,
                     "is " + describe(value) +
                         " in a direction that is held, since it has neither stiffness "
                         "nor damping; expected 0"});
        if (coordinate.moves_freely && key == "rest" && value != 0.0)
          first.add({std::string(key) + number,
                     "is " + describe(value) + " in a direction without a spring; expected 0"});
      });
  if (!is_zero(coordinate.effort))
    first.add({slides(JointKind::bushing, index) ? "force" : "torque",
               "does not belong to kind \"bushing\""});
  if (coordinate.stop) first.add({"stop", "does not belong to kind \"bushing\""});
  if (coordinate.friction) first.add({"friction", "does not belong to kind \"bushing\""});
  if (coordinate.relaxation) {
    const Fault fault =
        find_relaxation_fault(*coordinate.relaxation, units_of(JointKind::bushing, index));
    first.add(fault.within("relaxation" + number));
    if (is_held)
      first.add({"relaxation" + number,
                 "is in a direction that is held, since it has neither stiffness nor damping; "
                 "expected {}"});
  }
  const auto* motion = coordinate.motion ? std::get_if<MotionTable>(&*coordinate.motion) : nullptr;
  if (is_held && !(motion && is_zero(motion->value)))
    first.add({"motion" + number,
               "is none of zero, expected one that holds a direction without stiffness and "
               "damping"});
  if (!is_held && coordinate.motion)
    first.add({"motion" + number, "does not belong to kind \"bushing\""});
  return first.found();
}

Fault find_bushing_fault(const Joint& joint) {
  const FirstFault first;
  bool moves = false;
  for (std::size_t i = 0; i < 6; ++i) {
    first.add(find_bushing_fault(joint.coordinates[i], static_cast<int>(i)));
    moves = moves || !joint.coordinates[i].motion;
  }
  if (!moves)
    first.add(
        {"stiffness",
         "is 0, as damping is, in all directions, so that the bushing holds them all; expected "
         "one that moves, or kind \"fixed\""});
  return first.found();
}

Fault find_coordinate_fault(const JointCoordinate& coordinate, JointKind kind, int index) {
  const FirstFault first;
  const CoordinateUnits& unit = units_of(kind, index);
  // Keys hold a number where there is one coordinate, else one number for each.
  const bool is_alone = count_coordinates(kind) == 1;
  const std::string number = is_alone ? "" : '.' + std::to_string(index + 1);
  visit_fields(coordinate, unit, [&](std::string_view key, double value, const Quantity& quantity) {
    first(std::string(key) + number, value, quantity);
  });
  first.add(find_curve_fault(slides(kind, index) ? "force" : "torque", coordinate.effort,
                             Quantity::any(unit.effort)));
  if (coordinate.motion) first.add(find_double(coordinate, kind, index));
  if (coordinate.stop) first.add(find_stop_fault(*coordinate.stop, unit).within("stop" + number));
  if (coordinate.friction)
    first.add(find_friction_fault(*coordinate.friction, unit).within("friction" + number));
  if (coordinate.relaxation)
    first.add(find_relaxation_fault(*coordinate.relaxation, unit).within("relaxation" + number));
  if (coordinate.motion)
    first.add(find_motion_fault(*coordinate.motion, unit).within("motion" + number));
  return first.found();
}

/// Finds torques of one joint whose curves do not share one array of times.
Fault find_effort_fault(const Joint& joint) {
  for (int i = 1; i < count_coordinates(joint.kind); ++i)
    if (!slides(joint.kind, i) && joint.coordinates[static_cast<std::size_t>(i)].effort.times() !=
                                      joint.coordinates[0].effort.times())
      return {"torque", "has other times for one coordinate than for another, expected equal ones"};
  return {};
}

}  // namespace

Fault find_fault(const Joint& joint) {
  const FirstFault first;
  if (!joint.name.empty()) first.add(find_name_fault(joint.name));
  visit_fields(joint, first);
  first.add(find_axes_fault(joint));
  const auto count = static_cast<std::size_t>(count_coordinates(joint.kind));
  if (joint.coordinates.size() < count) {  // only of joints that a program fills in
    first.add({"coordinates", "has " + std::to_string(joint.coordinates.size()) +
                                  " entries, expected " + std::to_string(count)});
    return first.found();
  }
  if (joint.kind == JointKind::spherical) first.add(find_spherical_fault(joint));
  if (joint.kind == JointKind::bushing) {
    first.add(find_bushing_fault(joint));
    return first.found();
  }
  first.add(find_effort_fault(joint));
  for (int i = 0; i < count_coordinates(joint.kind); ++i)
    first.add(find_coordinate_fault(joint.coordinates[static_cast<std::size_t>(i)], joint.kind, i));
  return first.found();
}

Fault find_fault(const Blade& blade) {
  const FirstFault first;
  first.add(find_fault(blade.beam));
  visit_fields(blade, first);
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < blade.joints.size() && !first.found(); ++i) {
    const BladeJoint& outer = blade.joints[i];
    const std::string path = "joint." + std::to_string(i + 1);
    first(path + ".station", outer.station, {"m, from the root to less than length"});
    if (!(outer.station >= 0.0 && outer.station < blade.beam.length * (1.0 - 1e-9)))
      first.add({path + ".station", "is " + describe(outer.station) +
                                        ", expected 0 or more, and less than the length, " +
                                        describe(blade.beam.length) + " (m)"});
    if (i > 0 && std::abs(outer.station - blade.joints[i - 1].station) <= 1e-9 * blade.beam.length)
      first.add({path + ".station",
                 "is " + describe(outer.station) +
                     ", where the joint before it is; expected a part of the blade between two "
                     "joints, or one joint of kind \"universal\" or \"spherical\""});
    if (i > 0 && outer.station < blade.joints[i - 1].station)
      first.add({path + ".station", "is " + describe(outer.station) +
                                        ", expected more than that of the joint before it, " +
                                        describe(blade.joints[i - 1].station)});
    first.add(find_fault(outer.joint).within(path));
    if (!outer.joint.name.empty() && !names.insert(outer.joint.name).second)
      first.add({path + ".name",
                 "is \"" + outer.joint.name + "\" as another joint's, expected a name of its own"});
  }
  return first.found();
}

}  // namespace spoke::spatial
