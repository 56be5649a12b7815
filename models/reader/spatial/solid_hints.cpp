#include "models/reader/spatial/solid_hints.h"

#include <algorithm>
#include <cstddef>
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

/// Adds hints at a mesh; `of`: "arm / bar".
void look_at_mesh(const std::string& of, const spatial::SolidMesh& mesh,
                  std::vector<std::string>& hints) {
  if (solid::has_locking_elements(mesh))
    hints.push_back("the mesh of " + of + " has linear elements (" + list_linear_kinds(mesh) +
                    "), which lock: it is too stiff in bending; take quadratic ones (tet10, "
                    "hex20; gmsh: -order 2)");
  if (!mesh.left_out.empty()) {
    std::string list;
    for (std::size_t k = 0; k < mesh.left_out.size(); ++k)
      list += (k == 0 ? "" : k + 1 < mesh.left_out.size() ? ", " : " and ") + mesh.left_out[k];
    hints.push_back("the mesh of " + of + " leaves out " + list +
                    " of its file: joints hold a solid at its interfaces, [[load]] tables load it, "
                    "its material is linear");
  }
  if (!mesh.material_fault.empty())
    hints.push_back("the file of the mesh of " + of + ' ' + mesh.material_fault +
                    "; the scenario's isotropic material is that of all its elements");
}

}  // namespace

std::vector<std::string> find_solid_hints(const Scenario& scenario) {
  std::vector<std::string> hints;
  if (!scenario.space) return hints;
  std::vector<const spatial::SolidMesh*> seen;
  for (const spatial::Subsystem& subsystem : scenario.space->subsystems)
    for (const spatial::Body& body : subsystem.bodies) {
      const auto* solid = std::get_if<spatial::SolidBody>(&body.shape);
      if (!solid || !solid->mesh) continue;
      if (std::find(seen.begin(), seen.end(), solid->mesh.get()) != seen.end()) continue;
      seen.push_back(solid->mesh.get());
      look_at_mesh(subsystem.name + " / " + body.name, *solid->mesh, hints);
    }
  return hints;
}

}  // namespace spoke
