#include "models/solid_body.h"

#include <algorithm>

namespace spoke::spatial {

int count_nodes(ElementKind kind) {
  switch (kind) {
    case ElementKind::tet4:
      return 4;
    case ElementKind::tet10:
      return 10;
    case ElementKind::hex8:
      return 8;
    case ElementKind::hex20:
      break;
  }
  return 20;
}

std::string_view name_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::tet4:
      return "tet4";
    case ElementKind::tet10:
      return "tet10";
    case ElementKind::hex8:
      return "hex8";
    case ElementKind::hex20:
      break;
  }
  return "hex20";
}

std::optional<int> find_node(const SolidMesh& mesh, int label) {
  if (mesh.labels.empty()) {
    const bool is_there = label >= 1 && static_cast<std::size_t>(label) <= mesh.nodes.size();
    return is_there ? std::optional(label - 1) : std::nullopt;
  }
  const auto found = std::find(mesh.labels.begin(), mesh.labels.end(), label);
  if (found == mesh.labels.end()) return std::nullopt;
  return static_cast<int>(found - mesh.labels.begin());
}

bool has_same_shape(const SolidBody& a, const SolidBody& b) {
  return a.file == b.file && a.mesh == b.mesh && a.matrices == b.matrices &&
         a.material == b.material && a.length_scale == b.length_scale &&
         a.interfaces == b.interfaces;
}

bool is_same_solid(const SolidBody& a, const SolidBody& b) {
  return has_same_shape(a, b) && a.coordinates == b.coordinates && a.modes == b.modes &&
         a.up_to == b.up_to && a.geometric_stiffening == b.geometric_stiffening &&
         a.damping == b.damping && a.frame == b.frame;
}

std::optional<std::size_t> find_interface(const SolidBody& body, std::string_view name) {
  if (name.empty())
    return body.interfaces.size() == 2 ? std::optional<std::size_t>(1) : std::nullopt;
  const auto found =
      std::find_if(body.interfaces.begin(), body.interfaces.end(),
                   [name](const SolidInterface& interface) { return interface.name == name; });
  if (found == body.interfaces.end()) return std::nullopt;
  return static_cast<std::size_t>(found - body.interfaces.begin());
}

std::string_view name_of(InterfaceKind kind) {
  return kind == InterfaceKind::rigid ? "rigid" : "average";
}

std::string_view name_of(SolidCoordinates coordinates) {
  return coordinates == SolidCoordinates::reduced ? "reduced" : "nodal";
}

std::string_view name_of(SolidFrame frame) {
  return frame == SolidFrame::clamped ? "clamped" : "mean_axis";
}

}  // namespace spoke::spatial
