// Rules for supports, suspensions, and for what stands on them.

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "models/reader/spatial/fault.h"
#include "models/support/nearest_name.h"
#include "models/tree/axle_carrier.h"

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

/// Finds what a rotor on a support must have, whose blades and subsystems it carries if any.
Fault find_hub_fault(const Model& model, int rotor) {
  const Hub& hub = hub_of(model, rotor);
  if (hub.support == HubSupport::free)
    return {"support",
            "is \"free\", but the hub is on a support, which carries its axle; expected \"axle\""};
  if (hub.mount && model.support->from == SupportBase::free)
    return {"mount", "moves the ground, expected none of a support that is free"};
  if (hub.mount && rotor > 0)
    return {"mount", "moves the ground, expected in the hub of the first rotor"};
  const auto is_on_it = [&](const auto& carried) { return carried.rotor == rotor; };
  const bool is_alone =
      std::none_of(model.blades.begin(), model.blades.end(), is_on_it) &&
      std::none_of(model.subsystems.begin(), model.subsystems.end() - 1, is_on_it);
  if (is_alone && !(hub.mass > 0.0))
    return {"mass", "is " + describe(hub.mass) +
                        ", expected a number greater than 0 (kg) of a hub that moves on a "
                        "support and carries nothing"};
  return {};
}

/// A name that a rotor gives to a part of its support.
struct TakenName {
  std::string list, name, what;  ///< "body", "tail.hub", "hub"
};

std::vector<TakenName> names_of_rotor(const Model& model, int rotor) {
  const std::string prefix = prefix_of_rotor(model, rotor);
  std::vector<TakenName> names{{"body", prefix + "hub", "hub"}, {"joint", prefix + "axle", "axle"}};
  if (!axle_of(model, rotor).train) return names;
  const std::string generator(kGeneratorName);
  names.push_back({"body", prefix + generator, generator});
  names.push_back({"joint", prefix + generator, generator});
  names.push_back({"coupling", prefix + "shaft", "shaft"});
  return names;
}

/// Returns the index of the subsystem that carries the axle of a rotor; of none, their number.
std::size_t find_carrier(const Model& model, int rotor) {
  const std::string& name = axle_of(model, rotor).subsystem;
  if (name.empty()) return model.subsystems.size() - 1;
  const auto at =
      std::find_if(model.subsystems.begin(), model.subsystems.end() - 1,
                   [&name](const Subsystem& subsystem) { return subsystem.name == name; });
  return at == model.subsystems.end() - 1 ? model.subsystems.size()
                                          : static_cast<std::size_t>(at - model.subsystems.begin());
}

/// Returns the body of a tree that carries the axle of a rotor; null: its base, or a blade.
const Body* find_axle_body(const Model& model, int rotor) {
  const Axle& axle = axle_of(model, rotor);
  const std::size_t carrier =
      find_blade_of(axle) > 0 ? model.subsystems.size() : find_carrier(model, rotor);
  if (carrier == model.subsystems.size()) return nullptr;
  for (const Body& body : model.subsystems[carrier].bodies)
    if (body.name == axle.body) return &body;
  return nullptr;
}

/// Finds what lacks a hub behind a drive train on a body that bends, see models/tree/drive_train.h.
Fault find_light_hub(const Model& model, int rotor) {
  if (!axle_of(model, rotor).train) return {};
  const Body* const carrier = find_axle_body(model, rotor);
  const bool is_on_blade = find_blade_of(axle_of(model, rotor)) > 0;
  if (!is_on_blade && (!carrier || std::holds_alternative<RigidBody>(carrier->shape))) return {};
  const Hub& hub = hub_of(model, rotor);
  const std::string why = " of a hub whose drive train stands on a body that bends";
  if (!(hub.mass > 0.0))
    return {"mass", "is " + describe(hub.mass) + ", expected a number greater than 0 (kg)" + why};
  return {};
}

/// Finds what is wrong with the blade that a rotor names for its axle.
Fault find_blade_fault(const Model& model, int rotor) {
  const int number = find_blade_of(axle_of(model, rotor));
  if (model.blades.empty())
    return {"blade", "is " + std::to_string(number) + ", but there are no blades; expected none"};
  if (std::cmp_greater(number, model.blades.size()))
    return {"blade", "is " + std::to_string(number) + ", expected a whole number from 1 to " +
                         std::to_string(model.blades.size())};
  const int carrier = model.blades[static_cast<std::size_t>(number) - 1].rotor;
  if (carrier < rotor) return {};
  return {"blade", "is " + std::to_string(number) + ", which the hub of \"" +
                       hub_of(model, carrier).name +
                       "\" carries; expected a blade of a rotor before this one"};
}

/// Finds what is wrong with the blade or subsystem that a rotor names for its axle.
Fault find_carrier_fault(const Model& model, int rotor) {
  const std::string& name = axle_of(model, rotor).subsystem;
  if (name.empty()) return {};
  if (find_blade_of(axle_of(model, rotor)) > 0) return find_blade_fault(model, rotor);
  const std::size_t carrier = find_carrier(model, rotor);
  if (carrier == model.subsystems.size()) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i + 1 < model.subsystems.size(); ++i)
      names.push_back(model.subsystems[i].name);
    if (names.empty())
      return {"subsystem", "is \"" + name +
                               "\", but there is no [[subsystem]]; expected none, "
                               "which is the support"};
    return {"subsystem", describe_unknown(name, names)};
  }
  if (model.subsystems[carrier].rotor < rotor) return {};
  return {"subsystem", "is \"" + name + "\", which the hub of \"" +
                           hub_of(model, model.subsystems[carrier].rotor).name +
                           "\" carries; expected a subsystem of a rotor before this one"};
}

/// Finds a joint or coupling of a blade, by its number, that has the name of a part of a rotor on
/// it.
Fault find_taken_name(const Model& model, int rotor, int number) {
  const Blade& blade = model.blades[static_cast<std::size_t>(number) - 1];
  const std::string key = "blades." + std::to_string(number) + '.';
  for (const TakenName& taken : names_of_rotor(model, rotor)) {
    const std::string text = "is \"" + taken.name + "\", which is the " + taken.what +
                             " of a rotor; expected another name";
    for (std::size_t i = 0; taken.list == "joint" && i < blade.joints.size(); ++i)
      if (blade.joints[i].joint.name == taken.name)
        return {key + "joint." + std::to_string(i + 1) + ".name", text};
    for (std::size_t i = 0; taken.list == "coupling" && i < blade.couplings.size(); ++i)
      if (blade.couplings[i].name == taken.name)
        return {key + "coupling." + std::to_string(i + 1) + ".name", text};
  }
  return {};
}

/// Finds a body, joint or coupling of what carries a rotor that has the name of a part of it.
Fault find_taken_name(const Model& model, int rotor) {
  if (const int blade = find_blade_of(axle_of(model, rotor)); blade > 0)
    return find_taken_name(model, rotor, blade);
  const std::size_t carrier = find_carrier(model, rotor);
  if (carrier == model.subsystems.size()) return {};  // found elsewhere
  const Subsystem& tree = model.subsystems[carrier];
  const std::string key = key_of_subsystem(model, carrier);
  for (const TakenName& taken : names_of_rotor(model, rotor)) {
    const auto find = [&taken, &key](const auto& list, const auto& name_of) -> Fault {
      for (std::size_t i = 0; i < list.size(); ++i)
        if (name_of(list[i]) == taken.name)
          return {key + "." + taken.list + "." + std::to_string(i + 1) + ".name",
                  "is \"" + taken.name + "\", which is the " + taken.what +
                      " of a rotor; expected another name"};
      return {};
    };
    const auto own_name = [](const auto& item) { return item.name; };
    Fault fault = taken.list == "body" ? find(tree.bodies, own_name)
                  : taken.list == "joint"
                      ? find(tree.joints, [](const SubsystemJoint& at) { return at.joint.name; })
                      : find(tree.couplings, own_name);
    if (fault) return fault;
  }
  return {};
}

/// Finds a fault of a drive train.
Fault find_fault(const DriveTrain& train) {
  const FirstFault first;
  if (train.stiffness == 0.0)
    first.add({"stiffness", "is missing, expected that of the shaft of the drive train (N m/rad)"});
  if (train.generator_inertia == 0.0)
    first.add(
        {"generator_inertia", "is missing, expected that of the drive train's generator (kg m^2)"});
  visit_fields(train, first);
  if (train.gear_ratio == 0.0) first.add({"gear_ratio", "is 0, expected a number other than 0"});
  return first.found();
}

/// Finds a fault of an axle on a blade.
Fault find_axle_fault(const Axle& axle, const Blade& blade) {
  const FirstFault first;
  if (!axle.body.empty())
    first.add({"body", "is \"" + axle.body + "\", expected none on a blade, which has one beam"});
  const Body beam{"blade", blade.beam};
  first.add(find_place_fault(&beam, axle.station, axle.interface));
  visit_fields(axle, first);
  if (axle.train) first.add(find_fault(*axle.train));
  return first.found();
}

}  // namespace

Fault find_axle_fault(const Axle& axle, const Support& support, const Subsystem& tree) {
  const FirstFault first;
  const Body* carrier = nullptr;
  std::vector<std::string_view> names;
  for (const Body& body : tree.bodies) {
    names.push_back(body.name);
    if (body.name == axle.body) carrier = &body;
  }
  const bool may_be_base = support.from == SupportBase::free && axle.subsystem.empty();
  if (may_be_base) names.push_back(base_name(support.from));
  if (axle.body.empty() && !may_be_base)
    first.add({"body", "is missing, expected the name of the body that carries the axle"});
  if (!axle.body.empty() && !carrier) first.add({"body", describe_unknown(axle.body, names)});
  if (!first.found()) first.add(find_place_fault(carrier, axle.station, axle.interface));
  visit_fields(axle, first);
  if (axle.train) first.add(find_fault(*axle.train));
  return first.found();
}

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
  if (const int blade = find_blade_of(support.axle); blade > 0)
    first.add({"axle.blade", "is " + std::to_string(blade) +
                                 ", but the first rotor stands on the support; expected none"});
  else if (!support.axle.subsystem.empty())
    first.add(
        {"axle.subsystem", "is \"" + support.axle.subsystem +
                               "\", but the first rotor stands on the support; expected none"});
  for (std::size_t i = 0; i < tree.joints.size() && !first.found(); ++i)
    first.add(find_joint_fault(tree.joints[i].joint).within("joint." + std::to_string(i + 1)));
  if (!first.found()) first.add(find_axle_fault(support.axle, support, tree).within("axle"));
  return first.found();
}

Fault find_carried_fault(const Model& model) {
  if (Fault fault = find_hub_fault(model, 0).within("hub")) return fault;
  if (Fault fault = find_light_hub(model, 0).within("hub")) return fault;
  return find_taken_name(model, 0);
}

Fault find_rotors_fault(const Model& model) {
  if (model.rotors.empty()) return {};
  if (!model.support) return {"rotor", "is given without [support], which carries the axles"};
  std::set<std::string> names;
  for (int r = 0; r < count_rotors(model); ++r) {
    const std::string key = "rotor." + std::to_string(r + 1);
    const std::string& name = hub_of(model, r).name;
    const FirstFault first;
    first.add(find_name_fault(name));
    if (!first.found() && !names.insert(name).second)
      first.add({"name", "is \"" + name + "\" as another rotor's, expected a name of its own"});
    if (r > 0) {
      first.add(find_fault(hub_of(model, r)).within("hub"));
      if (!first.found()) first.add(find_hub_fault(model, r).within("hub"));
      if (!first.found()) first.add(find_carrier_fault(model, r).within("axle"));
      if (!first.found()) {
        const Axle& axle = axle_of(model, r);
        const int blade = find_blade_of(axle);
        first.add(
            (blade > 0
                 ? find_axle_fault(axle, model.blades[static_cast<std::size_t>(blade) - 1])
                 : find_axle_fault(axle, *model.support, model.subsystems[find_carrier(model, r)]))
                .within("axle"));
      }
    }
    if (first.found()) return first.found().within(key);
    if (Fault taken = r > 0 ? find_taken_name(model, r) : Fault{}) return taken;
  }
  return {};
}

}  // namespace spoke::spatial
