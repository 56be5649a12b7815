// Rules for supports, suspensions, and for what stands on them.

#include <algorithm>
#include <string_view>
#include <variant>
#include <vector>

#include "models/reader/spatial/fault.h"
#include "models/support/nearest_name.h"

namespace spoke::spatial {
namespace {

/// Finds what only a fuselage has.
Fault find_ground_fault(const Fuselage& fuselage) {
  const FirstFault first;
  const auto refuse = [&](std::string_view key, bool is_given) {
    if (is_given)
      first.add({std::string(key), "belongs to a fuselage, expected only with from = \"free\""});
  };
  refuse("mass", fuselage.mass != 0.0);
  refuse("center", !fuselage.center.isZero(0.0));
  refuse("inertia", fuselage.inertia != Fuselage{}.inertia);
  refuse("position", !fuselage.position.isZero(0.0));
  refuse("attitude", !fuselage.attitude.isZero(0.0));
  refuse("velocity", !fuselage.velocity.isZero(0.0));
  refuse("angular_velocity", !fuselage.angular_velocity.isZero(0.0));
  return first.found();
}

Fault find_fault(const Fuselage& fuselage) {
  const FirstFault first;
  visit_fields(fuselage, first);
  first.add(find_inertia_fault("inertia", fuselage.inertia, MayBeZero::no));
  return first.found();
}

/// Finds what joints of other trees may have, and those of a support not.
Fault find_joint_fault(const Joint& joint) {
  if (joint.name == "axle")
    return {"name", "is \"axle\", which is the hub's; expected another name"};
  for (int c = 0; c < count_coordinates(joint.kind); ++c) {
    const auto& motion = joint.coordinates[static_cast<std::size_t>(c)].motion;
    if (motion && std::holds_alternative<AzimuthMotion>(*motion))
      return {count_coordinates(joint.kind) == 1 ? "motion" : "motion." + std::to_string(c + 1),
              "follows the azimuth, but a support does not turn with the hub; expected constant, "
              "time and value, or by = \"program\""};
  }
  return {};
}

Fault find_axle_fault(const Support& support, const Subsystem& tree) {
  const Axle& axle = support.axle;
  const FirstFault first;
  const Body* carrier = nullptr;
  std::vector<std::string_view> names;
  for (const Body& body : tree.bodies) {
    names.push_back(body.name);
    if (body.name == axle.body) carrier = &body;
  }
  if (support.from == SupportBase::free) names.push_back(base_name(support.from));
  if (axle.body.empty() && support.from == SupportBase::ground)
    first.add({"body", "is missing, expected the name of the body that carries the axle"});
  if (!axle.body.empty() && !carrier) first.add({"body", describe_unknown(axle.body, names)});
  if (!first.found()) first.add(find_place_fault(carrier, axle.station, axle.interface));
  visit_fields(axle, first);
  return first.found();
}

}  // namespace

Fault find_fault(const Suspension& suspension) {
  const FirstFault first;
  bool moves = false;
  for (std::size_t c = 0; c < suspension.stiffness.size(); ++c) {
    const CoordinateUnits& unit = c < 3 ? kWayUnits : kAngleUnits;
    const std::string number = '.' + std::to_string(c + 1);
    first("stiffness" + number, suspension.stiffness[c], Quantity::not_negative(unit.stiffness));
    first("damping" + number, suspension.damping[c], Quantity::not_negative(unit.damping));
    moves = moves || suspension.moves(c);
  }
  if (!moves)
    first.add(
        {"stiffness",
         "is 0, as damping is, in all directions, which are held then; expected one that moves"});
  visit_fields(suspension, first);
  first.add(find_inertia_fault("inertia", suspension.inertia, MayBeZero::no));
  return first.found();
}

Fault find_fault(const Support& support, const Subsystem& tree) {
  const FirstFault first;
  const bool is_free = support.from == SupportBase::free;
  first.add(is_free ? find_fault(support.fuselage) : find_ground_fault(support.fuselage));
  first.add(find_fault(tree, {base_name(support.from), kSupportName, true, is_free}));
  if (tree.azimuth != 0.0)
    first.add({"azimuth", "is " + describe(tree.azimuth) +
                              ", but a support does not stand around the hub's axis; expected 0"});
  for (std::size_t i = 0; i < tree.joints.size() && !first.found(); ++i)
    first.add(find_joint_fault(tree.joints[i].joint).within("joint." + std::to_string(i + 1)));
  if (!first.found()) first.add(find_axle_fault(support, tree).within("axle"));
  return first.found();
}

Fault find_carried_fault(const Model& model) {
  const Hub& hub = model.hub;
  if (hub.support == HubSupport::free)
    return {"hub.support",
            "is \"free\", but the hub is on a support, which carries its axle; expected \"axle\""};
  if (hub.mount && model.support->from == SupportBase::free)
    return {"hub.mount", "moves the ground, expected none of a support that is free"};
  const bool is_alone = model.blades.empty() && model.subsystems.size() == 1;
  if (is_alone && !(hub.mass > 0.0))
    return {"hub.mass", "is " + describe(hub.mass) +
                            ", expected a number greater than 0 (kg) of a hub that moves on a "
                            "support and carries nothing"};
  return {};
}

}  // namespace spoke::spatial
