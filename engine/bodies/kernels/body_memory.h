#pragma once

// Memory of bodies besides the table: constants, which bodies of one type share, and workspaces of
// implicit steps.

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "engine/bodies/space/nodal_memory.h"
#include "engine/bodies/table/step_data.h"

namespace spoke {

/// Shares of Mff, K and D in the constant block Mhat of an implicit step; the explicit one has
/// (1, 0, 0).
struct ElasticShares {
  double mass_factor = 1.0;
  double stiffness_factor = 0.0;
  double damping_factor = 0.0;  ///< of the damping of sections, and of solids by modes [s]
  double tension_factor = 0.0;  ///< beta' h^2 [s^2]; 0: see engine/bodies/space/implicit_tension.h
};

/// Returns the factors of a spatial body's matrices in Mhat, the same in all formulations.
inline space::BlockFactors factors_of(const ElasticShares& shares) {
  return {shares.mass_factor, shares.stiffness_factor, shares.damping_factor};
}

/// Returns what a map has for a key. Adds what `make` returns if it has none: where copies share
/// the map, it is not changed.
template <class Map, class Make>
auto& find_or_add(Map& map, const typename Map::key_type& key, const Make& make) {
  const auto found = map.find(key);
  return found != map.end() ? found->second : map.emplace(key, make()).first->second;
}

/// Constants of bodies. Copies of a table share them: allocate() adds what is missing, and nothing
/// changes them.
template <class World>
struct BodyConstants {
  using Body = typename World::Body;
  /// Constant blocks, shared by bodies of one type: explicit, implicit. Terms of rigid bodies read
  /// them, whatever the formulation.
  std::map<const Body*, std::array<typename BodyTypes<World>::Block, 2>> blocks;
  /// Stiffening of solids, by what it is made of, which bodies of one kind share: the matrices of
  /// their trees, or the constants of those that stiffen by their own rotation.
  std::map<const void*, space::SolidTensionColumns> solid_tensions;
  /// Tiles of solids in nodal coordinates, by their constants and tension.
  std::map<std::pair<const void*, const void*>, space::NodalTiles> tiles;
};

/// Memory of all bodies of a table.
template <class World>
struct BodyMemory {
  std::shared_ptr<BodyConstants<World>> constants = std::make_shared<BodyConstants<World>>();
  /// Tension in implicit steps of spatial bodies that rotation stiffens.
  std::vector<std::unique_ptr<space::ImplicitTension>> tensions;
  std::vector<std::unique_ptr<typename BodyTypes<World>::ImplicitStrain>> strains;
  std::vector<std::unique_ptr<space::NodalMemory>> nodal_memory;  ///< of solids, by body
};

}  // namespace spoke
