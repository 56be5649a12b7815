#pragma once

// Makes the scene of a scenario.

#include <memory>
#include <vector>

#include "engine/output/scene/scene.h"
#include "engine/simulation.h"
#include "models/space/solid.h"

namespace spoke::scene {

/// The constants of solids, by subsystem and body; null for other bodies.
using SolidsInTrees = std::vector<std::vector<std::shared_ptr<const space::SolidConstants>>>;

/// Makes the scene of a scenario that check_scenario() accepts. If bodies have many elements, only
/// every few nodes are shown, so that there are about `most_nodes` in all, but at least two for
/// each body. `solids`: constants of the solids, without which they are drawn at rest.
Scene make_scene(const Scenario& scenario, std::size_t most_nodes,
                 const SolidsInTrees& solids = {});
/// Makes the scene of a simulation, whose solids deform.
Scene make_scene(const Simulation& simulation, std::size_t most_nodes);

/// Make the scene in one world.
Scene make_planar_scene(const Scenario& scenario, std::size_t most_nodes);
Scene make_spatial_scene(const spatial::Model& model, std::size_t most_nodes,
                         const SolidsInTrees& solids = {});

/// Returns the numbers of the nodes of a body that are shown: every `stride`-th one, and the last.
std::vector<int> shown_nodes(int elements, std::size_t stride);

/// Returns the number of rings per element with which scenes of few elements look smooth, and
/// scenes of many stay small.
int rings_per_element(std::size_t elements);

/// Makes the rings of elements between shown nodes, whose stations are given: `make(station)` makes
/// a ring there.
template <class Make>
std::vector<Ring> make_rings(const std::vector<double>& stations, int first, int per_element,
                             Make make) {
  std::vector<Ring> rings;
  for (std::size_t e = 0; e + 1 < stations.size(); ++e) {
    const bool is_last = e + 2 == stations.size();
    for (int i = 0; i < per_element + (is_last ? 1 : 0); ++i) {
      const double xi = static_cast<double>(i) / per_element;
      rings.push_back(make(stations[e] + xi * (stations[e + 1] - stations[e])));
      rings.back().at.node = first + static_cast<int>(e);
      rings.back().at.xi = xi;
    }
  }
  return rings;
}

}  // namespace spoke::scene
