#include "models/reader/spatial/solid_hints.h"

#include <algorithm>
#include <variant>

#include "models/solid/mesh_check.h"

namespace spoke {
namespace {

using spatial::ElementKind;

bool has_kind(const spatial::SolidMesh& mesh, ElementKind kind) {
  return std::any_of(mesh.elements.begin(), mesh.elements.end(),
                     [kind](const spatial::SolidElement& element) { return element.kind == kind; });
}

/// Returns "tet4, hex8", or what of these the mesh has.
std::string list_linear_kinds(const spatial::SolidMesh& mesh) {
  std::string text;
  for (const ElementKind kind : {ElementKind::tet4, ElementKind::hex8})
    if (has_kind(mesh, kind)) text += (text.empty() ? "" : ", ") + std::string(name_of(kind));
  return text;
}

}  // namespace

std::vector<std::string> find_solid_hints(const Scenario& scenario) {
  std::vector<std::string> hints;
  if (!scenario.space) return hints;
  std::vector<const spatial::SolidMesh*> seen;
  for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (const spatial::Body& body : subsystem.bodies) {
      const auto* solid = std::get_if<spatial::SolidBody>(&body.shape);
      if (!solid || !solid->mesh || !solid::has_locking_elements(*solid->mesh)) continue;
      if (std::find(seen.begin(), seen.end(), solid->mesh.get()) != seen.end()) continue;
      seen.push_back(solid->mesh.get());
      hints.push_back("the mesh of " + subsystem.name + " / " + body.name +
                      " has linear elements (" + list_linear_kinds(*solid->mesh) +
                      "), which lock: it is too stiff in bending; take quadratic ones (tet10, "
                      "hex20; gmsh: -order 2)");
    }
  return hints;
}

}  // namespace spoke
