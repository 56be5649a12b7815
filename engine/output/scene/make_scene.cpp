// Common parts of scenes in the plane and in space.

#include "engine/output/scene/make_scene.h"

namespace spoke::scene {

std::vector<int> shown_nodes(int elements, std::size_t stride) {
  std::vector<int> shown;
  for (int k = 0; k < elements; k += static_cast<int>(stride)) shown.push_back(k);
  shown.push_back(elements);
  return shown;
}

int rings_per_element(std::size_t elements) { return elements > 600 ? 1 : elements > 150 ? 2 : 4; }

Scene make_scene(const Scenario& scenario, std::size_t most_nodes, const SolidsInTrees& solids) {
  return scenario.space ? make_spatial_scene(*scenario.space, most_nodes, solids)
                        : make_planar_scene(scenario, most_nodes);
}

Scene make_scene(const Simulation& simulation, std::size_t most_nodes) {
  SolidsInTrees solids;
  if (const auto& space = simulation.scenario().space) {
    TreeShape shape;
    for (std::size_t i = 0; i < space->blades.size() + space->subsystems.size(); ++i) {
      simulation.calc_shape(static_cast<int>(i), shape);
      auto& own = solids.emplace_back();
      for (const TreeBodyShape& body : shape.bodies) own.push_back(body.solid);
    }
  }
  return make_scene(simulation.scenario(), most_nodes, solids);
}

}  // namespace spoke::scene
