#pragma once

// Chooses nodes of a mesh, by name or by place.

#include <memory>
#include <optional>
#include <vector>

#include "models/solid/solid.h"
#include "models/solid/surface.h"

namespace spoke::solid {

/// Chooses nodes of one mesh several times; finds its surface once.
class NodeChooser {
 public:
  explicit NodeChooser(const spatial::SolidMesh& mesh) : mesh_(mesh) {}

  /// Finds the nodes of a choice. Throws InputError as choose_nodes() does.
  ChosenNodes choose(const spatial::NodeChoice& choice);
  /// Finds the nodes of an interface: at least three that are not on one line, its point given or
  /// the mean. Throws InputError likewise.
  ChosenNodes choose_interface(const spatial::SolidInterface& interface);

 private:
  const std::vector<SurfaceFace>& surface();
  std::vector<int> surface_nodes();  ///< all nodes of a mesh without elements
  std::vector<int> find_on_surface(const spatial::NodeChoice& choice);
  std::vector<spatial::SolidFace> find_whole_faces(const std::vector<int>& nodes);

  const spatial::SolidMesh& mesh_;
  std::optional<std::vector<SurfaceFace>> surface_;
};

/// Whether nodes are at one place or on one line, within some hundred-thousandths of its length:
/// they determine no rotation about it.
bool are_on_line(const spatial::SolidMesh& mesh, const std::vector<int>& nodes);

/// Integrals of the shape functions of a face, by its nodes [m^2]; they sum to its area.
std::array<double, 8> integrate_shapes(const spatial::SolidMesh& mesh,
                                       const spatial::SolidFace& face);

}  // namespace spoke::solid
