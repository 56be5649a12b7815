// Rules for solids: what they are made of, how they are reduced, and their interfaces.

#include "models/reader/spatial/solid_faults.h"

#include <set>
#include <string_view>
#include <variant>

#include "models/reader/spatial/fault.h"
#include "models/reader/toml_section.h"
#include "models/solid/choose_nodes.h"
#include "models/solid/kept_geometry.h"
#include "models/support/nearest_name.h"
#include "models/tree/solid_part.h"
#include "spoke/error.h"

namespace spoke::spatial {
namespace {

bool has_stresses(const SolidMatrices& matrices) {
  return !matrices.own[0].empty() && !matrices.translation[0].empty();
}

/// Finds geometric stiffness of which some matrices are missing.
Fault find_stiffness_fault(const SolidMatrices& matrices) {
  std::size_t given = 0;
  for (const std::string& file : matrices.own) given += file.empty() ? 0 : 1;
  for (const std::string& file : matrices.translation) given += file.empty() ? 0 : 1;
  if (given == 0 || given == matrices.own.size() + matrices.translation.size()) return {};
  return {"geometric_stiffness", "has " + std::to_string(given) +
                                     " files, expected 6 as own and 3 as translation, or none"};
}

Fault find_fault(const SolidMatrices& matrices) {
  if (matrices.format != "calculix" && matrices.format != "abaqus" &&
      matrices.format != "matrix_market")
    return {"format", "is \"" + matrices.format +
                          "\", expected \"calculix\", \"abaqus\" or \"matrix_market\""};
  for (const auto& [key, file] :
       {std::pair("mass", &matrices.mass), std::pair("stiffness", &matrices.stiffness),
        std::pair("nodes", &matrices.nodes)})
    if (file->empty()) return {key, "is missing, expected a file, as format is given"};
  return find_stiffness_fault(matrices);
}

/// Finds none, or several, of a mesh in a file, one made in code, and matrices.
Fault find_source_fault(const SolidBody& body) {
  if (body.matrices) {
    if (!body.file.empty() || body.mesh)
      return {"mesh", "given along with matrices of another program, expected only one of them"};
    if (body.material)
      return {"material", "would be ignored, since the matrices have it; expected none"};
    if (body.geometric_stiffening && !has_stresses(*body.matrices))
      return {"geometric_stiffening",
              "is true, but matrices do not tell the stresses; expected false, or files of "
              "geometric_stiffness"};
    return find_fault(*body.matrices);
  }
  if (body.file.empty() && !body.mesh)
    return {"mesh",
            "is missing, expected a file of gmsh or Abaqus; or mass, stiffness, nodes and "
            "format"};
  return {};
}

Fault find_fault(const SolidMaterial& material) {
  const FirstFault first;
  visit_fields(material, first);
  return first.found().within("material");
}

/// Finds modes and damping that do not fit the coordinates.
Fault find_coordinates_fault(const SolidBody& body) {
  const FirstFault first;
  if (body.modes) first("modes", *body.modes, kModes, Presence::optional);
  if (body.up_to) first("up_to", *body.up_to, kFrequency);
  first.numbers("damping", body.damping, kDampingRatio);
  if (body.modes && body.up_to)
    first.add({"up_to", "given along with modes, expected only one of them"});
  if (body.coordinates == SolidCoordinates::nodal) {
    const std::string expected = "belongs to coordinates \"reduced\", expected none of \"nodal\"";
    if (body.modes) first.add({"modes", expected});
    if (body.up_to) first.add({"up_to", expected});
    if (!body.damping.empty())
      first.add({"damping", expected + ": [damping] has a stiffness_factor"});
    if (body.frame == SolidFrame::mean_axis)
      first.add(
          {"reference_frame",
           "is \"mean_axis\", which belongs to coordinates \"reduced\"; expected \"clamped\""});
  }
  if (body.modes == 0 && body.interfaces.size() == 1)
    first.add({"modes",
               "is 0, which leaves no coordinates; expected 1 or more, or a further "
               "interface, or kind = \"rigid\""});
  return first.found();
}

Fault find_interface_faults(const SolidBody& body) {
  if (body.interfaces.empty())
    return {"interface",
            "is missing, expected tables headed [[subsystem.body.interface]], of which the first "
            "one carries the frame"};
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < body.interfaces.size(); ++i) {
    const SolidInterface& interface = body.interfaces[i];
    const FirstFault first;
    first.add(find_name_fault(interface.name));
    if (!names.insert(interface.name).second)
      first.add({"name", "is \"" + interface.name +
                             "\" as another interface's, expected a name of its own"});
    first.add(find_choice_fault(interface.nodes).within("nodes"));
    if (interface.point) first("point", *interface.point, kLength, Presence::optional);
    if (first.found()) return first.found().within("interface." + std::to_string(i + 1));
  }
  return {};
}

Fault find_fault(const PlaneNodes& plane) {
  const FirstFault first;
  visit_fields(plane, first);
  first.add(find_direction_fault("normal", plane.normal));
  return first.found().within("plane");
}

Fault find_fault(const CylinderNodes& cylinder) {
  const FirstFault first;
  visit_fields(cylinder, first);
  first.add(find_direction_fault("axis", cylinder.axis));
  return first.found().within("cylinder");
}

Fault find_fault(const BoxNodes& box) {
  const FirstFault first;
  visit_fields(box, first);
  for (Eigen::Index i = 0; i < 3; ++i)
    if (box.to[i] < box.from[i])
      first.add({"to." + std::to_string(i + 1), "is " + describe(box.to[i]) +
                                                    ", expected at least " + describe(box.from[i]) +
                                                    " (m), as in from"});
  return first.found().within("box");
}

}  // namespace

Fault find_choice_fault(const NodeChoice& choice) {
  if (const auto* name = std::get_if<std::string>(&choice)) {
    if (!name->empty()) return {};
    return {"", std::string("is missing, expected ") + kNodesExpected};
  }
  if (const auto* plane = std::get_if<PlaneNodes>(&choice)) return find_fault(*plane);
  if (const auto* cylinder = std::get_if<CylinderNodes>(&choice)) return find_fault(*cylinder);
  return find_fault(std::get<BoxNodes>(choice));
}

Fault find_interface_fault(const std::string& name, const SolidBody& body) {
  if (find_interface(body, name)) return {};
  TomlSection::Keys names;
  for (const SolidInterface& interface : body.interfaces) names.push_back(interface.name);
  if (!name.empty()) return {"interface", describe_unknown(name, names)};
  return {"interface", "is missing, expected " + join_names(names)};
}

Fault find_load_fault(const PointLoad& load, const SolidBody& body) {
  if (load.position)
    return {"position", "belongs to beams, expected interface or nodes on a solid"};
  if (!load.point.isZero(0.0))
    return {"point", "belongs to rigid bodies, expected interface or nodes on a solid"};
  if (load.nodes && !load.interface.empty())
    return {"nodes", "given along with interface, expected only one of them"};
  if (Fault fault = load.nodes ? find_choice_fault(*load.nodes).within("nodes")
                               : find_interface_fault(load.interface, body))
    return fault;
  const FirstFault first;
  if (load.traction) first("traction", *load.traction, kTraction, Presence::optional);
  if (load.traction && !(load.force.isZero(0.0) && load.moment.isZero(0.0)))
    first.add({"traction", "given along with force or moment, expected only one of them"});
  const std::optional<NodeChoice> set = find_loaded_set(load, body);
  if (first.found() || !set) return first.found();
  try {
    const auto kept = solid::find_geometry(body);
    const solid::ChosenNodes chosen = solid::choose_nodes(*kept->geometry.mesh, *set);
    if (!load.moment.isZero(0.0) && solid::are_on_line(*kept->geometry.mesh, chosen.nodes))
      return {"moment", "acts on nodes that are on one line, expected nodes that determine a turn"};
    if (load.traction && chosen.area == 0.0)
      return {"traction", "is on nodes without faces, expected those of a surface, or force"};
  } catch (const InputError& error) {
    return {"nodes", error.what()};
  }
  return {};
}

Fault find_description_fault(const SolidBody& body) {
  const FirstFault first;
  first.add(find_source_fault(body));
  first("scale.length", body.length_scale, kLengthScale);
  if (body.material) first.add(find_fault(*body.material));
  if (!first.found()) first.add(find_interface_faults(body));
  if (!first.found()) first.add(find_coordinates_fault(body));
  return first.found();
}

Fault find_fault(const SolidBody& body) {
  if (Fault fault = find_description_fault(body)) return fault;
  try {
    solid::find_geometry(body);
  } catch (const InputError& error) {
    if (solid::is_of_mesh(error)) throw;
    return {error.place().key, error.what()};
  }
  return {};
}

}  // namespace spoke::spatial
