// Checks names, places and kinds of closures.

#include "models/reader/loop_faults.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "models/reader/bearing_reader.h"
#include "models/reader/spatial/solid_faults.h"
#include "models/support/nearest_name.h"

namespace spoke {
namespace {

using spatial::FirstFault;

/// The largest spectral radius of generalized_alpha with which forces of rigid closures are smooth.
constexpr double kLargestRadius = 0.95;

constexpr Quantity stiffness_of(bool is_length) {
  return Quantity::not_negative(is_length ? "N/m" : "N m/rad");
}
constexpr Quantity damping_of(bool is_length) {
  return Quantity::not_negative(is_length ? "N s/m" : "N m s/rad");
}

std::vector<std::string_view> names_of(const std::vector<Anchor>& anchors) {
  std::vector<std::string_view> names;
  for (const Anchor& anchor : anchors) names.push_back(anchor.name);
  return names;
}

/// Finds a body that is called as what holds the axle is.
Fault find_double_mount(const LoopPlace& place, const LoopSurroundings& around) {
  if (around.is_support()) return {};
  const bool is_named = place.carrier == LoopPlace::Carrier::mount ||
                        (place.carrier == LoopPlace::Carrier::body && place.name == "mount");
  const bool is_body = std::any_of(around.bodies.begin(), around.bodies.end(),
                                   [](const LoopBody& body) { return body.name == "mount"; });
  if (!is_named || !is_body) return {};
  return {"",
          "is \"mount\", the name of a body and of what holds the axle; expected another name of "
          "the body"};
}

/// Returns the names of what carries bodies: "hub" and "mount", or what a support stands on.
std::string bases_of(const LoopSurroundings& around) {
  if (!around.is_support()) return "\"hub\" or \"mount\"";
  return '"' + std::string(around.base_name()) + '"';
}

/// Finds the mount where loops cannot be fixed to it.
Fault find_mount_place(const LoopSurroundings& around) {
  switch (around.base) {
    case LoopBase::axle:
      return {};
    case LoopBase::free:
      return {"", "is \"mount\", which a free hub has not; expected \"hub\" or a body"};
    case LoopBase::supported:
      return {"", "is \"mount\", which a hub on a support has not; expected \"hub\" or a body"};
    default:
      return {"", "is \"mount\", expected " + bases_of(around) + " or a body"};
  }
}

Fault find_body_fault(const LoopPlace& place, const LoopSurroundings& around) {
  if (around.find(place) != nullptr) return {};
  if (around.is_blade())
    return {"body", "is \"" + place.name +
                        "\", but bodies of a blade have no names; expected station, a distance "
                        "from the root, or \"hub\" or \"mount\""};
  if (place.name.empty())
    return {"body", "is missing, expected the name of a body, " + bases_of(around) + ", or anchor"};
  std::vector<std::string_view> names{around.base_name()};
  if (!around.is_support()) names.push_back("mount");
  for (const LoopBody& body : around.bodies) names.push_back(body.name);
  return {"body", describe_unknown(place.name, names)};
}

/// Finds an anchor that does not move with what carries the bodies: the hub on a support, and the
/// support, are on two sides of the axle.
Fault find_frame_fault(const Anchor& anchor, const LoopSurroundings& around) {
  if (anchor.frame == Anchor::Frame::body) return {};
  const bool is_of_mount = anchor.frame == Anchor::Frame::mount;
  const std::string found = "is \"" + anchor.name + "\", an anchor of the frame \"" +
                            std::string(name_of(anchor.frame)) + '"';
  if (around.base == LoopBase::supported && is_of_mount)
    return {"anchor", found +
                          ", but the hub is on a support; expected one of the frame \"hub\" or "
                          "\"axle\""};
  if (!around.is_support() && anchor.rotor != around.rotor)
    return {"anchor", "is \"" + anchor.name +
                          "\", an anchor of another rotor; expected one of its own, \"hub\" or a "
                          "body"};
  if (!around.is_support()) return {};
  if (!is_of_mount)
    return {"anchor", found +
                          ", but the loop is of the support; expected one of the frame "
                          "\"mount\""};
  if (anchor.turns_with_hub)
    return {"anchor", "is \"" + anchor.name +
                          "\", which turns with the hub, but the loop is of the support; expected "
                          "one that does not"};
  return {};
}

Fault find_anchor_fault(const LoopPlace& place, const LoopSurroundings& around) {
  const std::vector<Anchor>& anchors = *around.anchors;
  if (anchors.empty()) return {"anchor", "is \"" + place.name + "\", but there is no [[anchor]]"};
  const auto found = std::find_if(anchors.begin(), anchors.end(),
                                  [&](const Anchor& anchor) { return anchor.name == place.name; });
  if (found != anchors.end()) return find_frame_fault(*found, around);
  return {"anchor", describe_unknown(place.name, names_of(anchors))};
}

/// Finds a station of a blade in the plane at which none of its bodies ends.
Fault find_end_fault(double station, const LoopBody& beam) {
  const double part = *beam.length / beam.parts, number = station / part;
  if (std::lround(number) >= 1 && std::abs(number - std::round(number)) <= 1e-9 * beam.parts)
    return {};
  std::string expected = describe(*beam.length) + " (m), the tip";
  if (beam.parts > 1)
    expected = describe(part) + " or a multiple of it up to " + describe(*beam.length) +
               " (m), where a body ends";
  return {"station", "is " + describe(station) + ", expected " + expected};
}

Fault find_fault_of_station(const LoopPlace& place, const LoopSurroundings& around) {
  const LoopBody* body = place.carrier == LoopPlace::Carrier::body ? around.find(place) : nullptr;
  if (body != nullptr && body->solid != nullptr) {
    if (place.station) return {"station", "belongs to beams, expected interface on a solid"};
    return spatial::find_interface_fault(place.interface, *body->solid);
  }
  if (!place.interface.empty()) return {"interface", "would be ignored, expected only on a solid"};
  if (!place.station) return {};
  if (body == nullptr || !body->length)
    return {"station", "would be ignored, expected only on a beam: give point"};
  const FirstFault first;
  first("station", *place.station, {"m, from root to tip", 0.0, *body->length});
  if (!first.found() && around.in_plane) first.add(find_end_fault(*place.station, *body));
  return first.found();
}

/// Finds vectors that leave the plane; files cannot say any.
Fault find_plane_fault(const LoopPlace& place) {
  if (place.point.z() != 0.0) return {"point", "leaves the plane, expected z = 0"};
  if (place.orientation && !place.orientation->head<2>().isZero(0.0))
    return {"orientation", "leaves the plane, expected a rotation about z"};
  return {};
}

/// Finds an orientation that would be ignored.
Fault find_orientation_fault(const Loop& loop) {
  const auto refuse = [&](const std::string& key) -> Fault {
    return {key + ".orientation", "would be ignored, since kind \"" +
                                      std::string(name_of(loop.kind)) +
                                      "\" lets its places turn; expected none"};
  };
  const bool is_distance = loop.kind == LoopKind::distance;
  const bool turns_all = loop.kind == LoopKind::spherical || loop.kind == LoopKind::bearing;
  if (loop.from.orientation && (is_distance || turns_all)) return refuse("from");
  if (loop.to.orientation && is_distance) return refuse("to");
  return {};
}

/// Finds two places that do not move against each other.
Fault find_same_fault(const Loop& loop, const LoopSurroundings& around) {
  using Carrier = LoopPlace::Carrier;
  if (loop.to.carrier != Carrier::body || loop.to.name != loop.from.name) return {};
  const LoopBody& body = *around.find(loop.to);
  if (body.solid) {
    if (find_interface(*body.solid, loop.to.interface) !=
        find_interface(*body.solid, loop.from.interface))
      return {};
    return {"to", "is at the same interface of the same solid as from, expected another place"};
  }
  if (!body.length)
    return {"to", "is on the same rigid body as from, expected a place that moves against it"};
  const double length = *body.length;
  if (std::abs(loop.to.station.value_or(length) - loop.from.station.value_or(length)) >
      1e-9 * length)
    return {};
  return {"to", "is at the same station of the same beam as from, expected another place"};
}

Fault find_axis_fault(const Loop& loop, bool in_plane) {
  if (in_plane) {
    if (loop.kind != LoopKind::prismatic) return {};
    if (loop.axes[0].z() != 0.0) return {"axis", "leaves the plane, expected z = 0"};
    return spatial::find_direction_fault("axis", loop.axes[0]);
  }
  const FirstFault first;
  const bool are_two = count_axes(loop.kind) == 2;
  for (int i = 0; i < count_axes(loop.kind); ++i) {
    const std::string key = are_two ? "axes." + std::to_string(i + 1) : "axis";
    const spatial::Vector& axis = loop.axes[static_cast<std::size_t>(i)];
    first(key, axis, spatial::kDirection, Presence::required);
    first.add(spatial::find_direction_fault(key, axis));
  }
  if (first.found() || !are_two) return first.found();
  const double sine = loop.axes[0].normalized().cross(loop.axes[1].normalized()).norm();
  if (sine > 1e-6) return {};
  return {"axes", "are parallel, expected two directions that differ"};
}

Fault find_length_fault(const Loop& loop) {
  if (!loop.length) return {};
  if (loop.kind != LoopKind::distance)
    return {"length", "does not belong to kind \"" + std::string(name_of(loop.kind)) +
                          "\", expected only with kind \"distance\""};
  const FirstFault first;
  first("length", *loop.length, Quantity::positive("m"));
  return first.found();
}

/// Finds a fault of the springs and dampers of closures that give.
Fault find_spring_fault(const Loop& loop, bool in_plane) {
  const FirstFault first;
  const auto count = static_cast<std::size_t>(count_locked(loop.kind, in_plane));
  const auto lengths = static_cast<std::size_t>(count_locked_places(loop.kind, in_plane));
  for (const auto& [key, values] :
       {std::pair("stiffness", &loop.stiffness), std::pair("damping", &loop.damping)}) {
    if (!values->empty() && values->size() != count)
      return {key, "has " + std::to_string(values->size()) + " numbers, expected " +
                       std::to_string(count) + ", one for each direction that is locked"};
    const bool is_stiffness = values == &loop.stiffness;
    for (std::size_t i = 0; i < values->size(); ++i)
      first(std::string(key) + '.' + std::to_string(i + 1), (*values)[i],
            is_stiffness ? stiffness_of(i < lengths) : damping_of(i < lengths));
  }
  const bool is_rigid = loop.stiffness.empty();
  for (std::size_t i = 0; i < loop.damping.size(); ++i) {
    if (loop.damping[i] == 0.0 || (!is_rigid && loop.stiffness[i] > 0.0)) continue;
    if (is_rigid) first.add({"damping", "is given without stiffness, expected both or none"});
    first.add({"damping." + std::to_string(i + 1),
               "is " + describe(loop.damping[i]) +
                   " in a direction without stiffness, which is rigid; expected 0"});
  }
  return first.found();
}

Fault find_loop_fault(const Loop& loop, const LoopSurroundings& around) {
  const FirstFault first;
  first.add(spatial::find_name_fault(loop.name));
  if (around.in_plane && count_locked_in_plane(loop.kind) == 0)
    first.add({"kind", "is \"" + std::string(name_of(loop.kind)) +
                           "\", which is none in the plane; expected \"fixed\", \"revolute\", "
                           "\"prismatic\" or \"distance\""});
  if (loop.from.carrier != LoopPlace::Carrier::body)
    first.add({"from",
               "is on no body, expected a place on one; what carries the other end "
               "belongs to \"to\""});
  first.add(find_fault(loop.from, around).within("from"));
  first.add(find_fault(loop.to, around).within("to"));
  if (!first.found()) first.add(find_same_fault(loop, around));
  first.add(find_orientation_fault(loop));
  first.add(find_axis_fault(loop, around.in_plane));
  first.add(find_length_fault(loop));
  first.add(find_matrix_fault(loop));
  first.add(find_spring_fault(loop, around.in_plane));
  return first.found();
}

LoopBase base_on(HubSupport support) {
  return support == HubSupport::axle ? LoopBase::axle : LoopBase::free;
}

LoopBase base_on_hub(const spatial::Model& model) {
  return model.support ? LoopBase::supported : base_on(model.hub.support);
}

}  // namespace

std::string_view LoopSurroundings::base_name() const {
  if (!is_support()) return "hub";
  return spatial::base_name(base == LoopBase::ground ? spatial::SupportBase::ground
                                                     : spatial::SupportBase::free);
}

const LoopBody* LoopSurroundings::find(const LoopPlace& place) const {
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const LoopBody& body) { return body.name == place.name; });
  return found == bodies.end() ? nullptr : &*found;
}

LoopSurroundings surroundings_of(const Blade& blade, const Hub& hub,
                                 const std::vector<Anchor>& anchors) {
  return {true, base_on(hub.support), &anchors, {{"", blade.length, blade.bodies}}};
}

LoopSurroundings surroundings_of(const spatial::Blade& blade, const spatial::Model& model) {
  LoopSurroundings around{false, base_on_hub(model), &model.anchors, {{"", blade.beam.length}}};
  around.rotor = blade.rotor;
  return around;
}

LoopSurroundings surroundings_of(const spatial::Subsystem& subsystem, const spatial::Model& model) {
  LoopBase base = base_on_hub(model);
  if (spatial::base_of(subsystem, model).is_support)
    base =
        model.support->from == spatial::SupportBase::ground ? LoopBase::ground : LoopBase::fuselage;
  LoopSurroundings around{false, base, &model.anchors};
  around.rotor = subsystem.rotor;
  for (const spatial::Body& body : subsystem.bodies) {
    const auto* beam = std::get_if<spatial::Beam>(&body.shape);
    around.bodies.push_back({body.name, beam ? std::optional(beam->length) : std::nullopt, 1,
                             std::get_if<spatial::SolidBody>(&body.shape)});
  }
  return around;
}

int count_locked(LoopKind kind, bool in_plane) {
  return in_plane ? count_locked_in_plane(kind) : count_locked(kind);
}

int count_locked_places(LoopKind kind, bool in_plane) {
  const int all = in_plane ? 2 : 3;
  switch (kind) {
    case LoopKind::distance:
      return 1;
    case LoopKind::prismatic:
    case LoopKind::cylindrical:
    case LoopKind::bearing:
      return all - 1;
    default:
      return all;
  }
}

Fault find_fault(const LoopPlace& place, const LoopSurroundings& around) {
  if (place.carrier == LoopPlace::Carrier::elsewhere)  // see spatial::find_loop_end_fault()
    return around.in_plane ? Fault{"", "is on another blade, expected a model in space"} : Fault{};
  const FirstFault first;
  first.add(find_double_mount(place, around));
  if (place.carrier == LoopPlace::Carrier::mount) first.add(find_mount_place(around));
  if (place.carrier == LoopPlace::Carrier::body) first.add(find_body_fault(place, around));
  if (place.carrier == LoopPlace::Carrier::anchor) first.add(find_anchor_fault(place, around));
  if (!first.found()) first.add(find_fault_of_station(place, around));
  first("point", place.point, kLength, Presence::optional);
  if (place.orientation)
    first("orientation", *place.orientation, spatial::kAngle, Presence::optional);
  if (around.in_plane) first.add(find_plane_fault(place));
  return first.found();
}

Fault find_fault(const std::vector<Loop>& loops, const LoopSurroundings& around) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const FirstFault first;
    first.add(find_loop_fault(loops[i], around));
    if (!names.insert(loops[i].name).second)
      first.add(
          {"name", "is \"" + loops[i].name + "\" as another loop's, expected a name of its own"});
    if (first.found()) return first.found().within("loop." + std::to_string(i + 1));
  }
  return {};
}

std::string find_radius_fault(const Integration& integration, const Scenario& scenario) {
  if (integration.method != IntegrationMethod::generalized_alpha ||
      integration.spectral_radius <= kLargestRadius)
    return {};
  const auto is_rigid = [](const Loop& loop) {
    if (loop.matrices) return false;
    return loop.stiffness.empty() ||
           std::find(loop.stiffness.begin(), loop.stiffness.end(), 0.0) != loop.stiffness.end();
  };
  const auto are_any = [&](const auto& items) {
    return std::any_of(items.begin(), items.end(), [&](const auto& item) {
      return std::any_of(item.loops.begin(), item.loops.end(), is_rigid);
    });
  };
  const auto has_rigid_coupling = [](const auto& items) {
    return std::any_of(items.begin(), items.end(), [](const auto& item) {
      return std::any_of(item.couplings.begin(), item.couplings.end(),
                         [](const Coupling& coupling) { return coupling.stiffness == 0.0; });
    });
  };
  if (scenario.space && (has_rigid_coupling(scenario.space->blades) ||
                         has_rigid_coupling(scenario.space->subsystems)))
    return "is " + describe(integration.spectral_radius) + ", expected at most " +
           describe(kLargestRadius) +
           " with rigid couplings, whose forces oscillate from step to step above it";
  if (scenario.space ? !are_any(scenario.space->blades) && !are_any(scenario.space->subsystems)
                     : !are_any(scenario.rotor.blades))
    return {};
  return "is " + describe(integration.spectral_radius) + ", expected at most " +
         describe(kLargestRadius) +
         " with rigid closed loops, whose forces oscillate from step to step above it";
}

}  // namespace spoke
