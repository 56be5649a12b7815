// Common parts of scenes in the plane and in space.

#include "engine/scene/make_scene.h"

namespace spoke::scene {

std::vector<int> shown_nodes(int elements, std::size_t stride) {
  std::vector<int> shown;
  for (int k = 0; k < elements; k += static_cast<int>(stride)) shown.push_back(k);
  shown.push_back(elements);
  return shown;
}

int rings_per_element(std::size_t elements) { return elements > 600 ? 1 : elements > 150 ? 2 : 4; }

Scene make_scene(const Scenario& scenario, std::size_t most_nodes) {
  return scenario.space ? make_spatial_scene(*scenario.space, most_nodes)
                        : make_planar_scene(scenario, most_nodes);
}

}  // namespace spoke::scene
