#pragma once

// Memory of the kernels of a solid in nodal coordinates: its size depends on tiles and factors.

#include <span>
#include <vector>

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/solid_block.h"
#include "engine/support/page_arena.h"

namespace spoke::space {

/// Makes the tiles of a solid with the matrices of its stiffening; null: without.
NodalTiles make_nodal_tiles(const SolidConstants& constants, const SolidTension* tension);

/// Counts the values of one slice in BodyWork::products: four by each coordinate of the frame, and
/// as many for each handle.
inline std::size_t count_products(const Solid& body) {
  return 4 * kTwist * (1 + body.handles.size());
}

/// Memory of one body.
struct NodalMemory {
  Arena arena;
};

/// Places the work of a solid whose blocks are made.
void place_nodal_work(const Solid& body, const NodalTiles& tiles, const SolidBlock& explicit_block,
                      const SolidBlock& implicit_block, NodalMemory& memory, BodyWork& work);

/// Returns the memory that condensing slice p writes.
std::vector<std::span<double>> memory_of_slice(const Solid& body, const SparseFactor& factor,
                                               std::size_t p, const BodyWork& work);
/// Returns the memory that condensing what is between slices writes.
std::vector<std::span<double>> memory_of_between(const Solid& body, const SparseFactor& factor,
                                                 const BodyWork& work);

/// Returns the memory of kernels of sensors.
std::vector<std::span<double>> memory_of_observed(const Solid& body, const NodalTiles& tiles,
                                                  const BodyWork& work);

}  // namespace spoke::space
