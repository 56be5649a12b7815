#pragma once

// Surfaces of solids in scenes.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "engine/output/scene/scene.h"
#include "models/space/solid.h"

namespace spoke::scene {

/// A solid as a scene sees it.
struct SolidView {
  std::shared_ptr<const spatial::SolidMesh> mesh;  ///< null: only its nodes are known
  Vector origin = Vector::Zero();                  ///< of its frame, in the mesh's axes [m]
  /// Its constants; null where nothing is simulated: it is then drawn at rest.
  std::shared_ptr<const space::SolidConstants> constants;
};

/// Returns how many nodes of a solid are drawn, so that pages stay small. `nodal_solids`: how many
/// there are whose displacements each frame holds; `most_nodes`: see make_scene().
std::size_t count_drawn_nodes(const space::SolidConstants* solid, std::size_t nodal_solids,
                              std::size_t most_nodes);

/// Makes the surface of a solid with about `most_nodes` nodes at most: all nodes of its surface if
/// they are so few, else corners of elements, of which coarsen() keeps some.
Surface make_surface(const SolidView& solid, std::size_t most_nodes);

}  // namespace spoke::scene
