#pragma once

// The terms of a solid in the coordinates of its nodes, tile by tile: each sets the rows of its own
// slice, and sums and shares of rows between slices, which are added up when all tiles are done.
//   r = x + Xi q,  mu = m r,  mu' = m r'      S = sum mu,  J = sum r mu^T,  G = sum r mu'^T
//   C_w^T = Xi^T [e_a x mu],    Q_f = Xi^T (b - kg u) - K q - D q',   b = -(A mu + 2 w x mu')
// with kg = sum weight_k kg_k of the stiffening, whose forms q^T K_k q and q'^T K_k q are summed.

#include <span>
#include <vector>

#include "engine/bodies/space/body_data.h"
#include "engine/bodies/space/nodal_tiles.h"
#include "models/rotor.h"

namespace spoke::space {

/// Counts the doubles of the memory besides the rows, and places them in it.
std::size_t count_nodal_work(const NodalTiles& tiles);
NodalWork place_nodal_work(const NodalTiles& tiles, double* rows, double* memory);
/// Returns the memory that tile p has in it, besides the rows.
std::vector<std::span<double>> memory_of_tile(const NodalTiles& tiles, int p,
                                              const NodalWork& work);
/// Returns the rows of a tile, and its share.
std::vector<std::span<double>> rows_of_tile(const NodalTiles& tiles, int p, double* rows);
/// Returns the rows between slices.
std::span<double> rows_between(const NodalTiles& tiles, double* rows);
/// Returns the memory of the forms of all.
std::span<double> memory_of_total_forms(const NodalTiles& tiles, const NodalWork& work);

/// Calculates the terms of tile p at the angular velocity w of the frame; `weights`: of the
/// stiffening's matrices, as many as these.
void calc_tile_terms(const NodalTiles& tiles, int p, const BodyState& state, const Angular& w,
                     const Damping& damping, const double* weights, const NodalWork& work) noexcept;

/// Sets the rows between slices, and returns the sums over all tiles; sets the forms of all.
NodalSums sum_tile_terms(const NodalTiles& tiles, const NodalWork& work) noexcept;

/// Returns the forms q^T K_k q of all tiles, then q'^T K_k q.
const double* total_forms(const NodalTiles& tiles, const NodalWork& work);

}  // namespace spoke::space
